// Text to what stands for it in an XML document.
#pragma once

#include <string>
#include <string_view>

namespace finemote::gen::xml {

/// `text` with a reference for each of `& < > "`: as text of an element, or as an attribute's value in double quotes.
std::string escaped(std::string_view text);

/// The same at the end of `out`.
void append_escaped(std::string& out, std::string_view text);

}  // namespace finemote::gen::xml
