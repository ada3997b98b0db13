#include "generator/xml/characters.hpp"

#include <algorithm>

namespace finemote::gen::xml {
namespace {

bool starts_name(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == ':' ||
         (static_cast<unsigned char>(c) & 0x80U) != 0;
}

}  // namespace

bool is_name(std::string_view text) {
  if (text.empty() || !starts_name(text.front())) return false;
  return std::all_of(text.begin(), text.end(),
                     [](char c) { return starts_name(c) || (c >= '0' && c <= '9') || c == '-' || c == '.'; });
}

bool are_characters(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) {
    return static_cast<unsigned char>(c) >= 0x20U || c == '\t' || c == '\n' || c == '\r';
  });
}

bool is_comment_text(std::string_view text) {
  return text.find("--") == std::string_view::npos && !text.ends_with('-');
}

}  // namespace finemote::gen::xml
