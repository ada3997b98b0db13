// Words as a POSIX shell reads them back.
#pragma once

#include <string>

namespace finemote::gen {

/// The text between single quotes.
std::string quoted_for_shell(const std::string& text);

/// A word of a command line as people write it: in quotes only where a shell needs them.
std::string shell_word(const std::string& word);

}  // namespace finemote::gen
