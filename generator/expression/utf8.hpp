// Characters of UTF-8 texts: Python counts code points, not bytes.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace finemote::gen::expression {

bool is_ascii(std::string_view text);
std::size_t count_characters(std::string_view text);

/// One view per character, into `text`. A byte that begins no character counts as one.
std::vector<std::string_view> split_characters(std::string_view text);

char32_t code_point(std::string_view character);
std::string encode(char32_t code_point);

}  // namespace finemote::gen::expression
