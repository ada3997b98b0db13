// The text of a C++ source to the lines that its preprocessor sees.
#pragma once

#include <string>
#include <string_view>

namespace finemote::gen {

/// A letter of ASCII, a digit or an underscore.
bool is_of_word(char c);

/// As a checkout with other ends of lines has it: LF for CR LF.
std::string without_returns(std::string_view text);

/// Lines that end with a backslash are one with the next, and comments are a space: ISO C++17 [lex.phases] 2 and 3. Raw
/// strings are taken for others.
std::string logical_lines(std::string_view text);

}  // namespace finemote::gen
