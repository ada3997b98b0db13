// Text to what manual pages are written in.
#pragma once

#include <string>

namespace finemote::gen {

/// Text of a line as roff reads it: dashes that can be copied, and no letter that is an instruction.
std::string roff(const std::string& text);

}  // namespace finemote::gen
