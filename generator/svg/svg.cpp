#include "generator/svg/svg.hpp"

#include <fmt/format.h>

namespace finemote::gen::svg {
namespace {

std::string class_of(std::string_view look) { return look.empty() ? "" : fmt::format(" class=\"{}\"", look); }

/// The first byte of the first character of the wide scripts, which begin at U+1100.
constexpr unsigned char kWideFrom = 0xE1;

}  // namespace

std::size_t columns(std::string_view text) {
  std::size_t count = 0;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool is_first = (byte & 0xC0) != 0x80;
    if (is_first) count += byte >= kWideFrom ? 2 : 1;
  }
  return count;
}

std::string rect(std::string_view look, const Box& box, std::size_t radius) {
  return fmt::format("<rect{} x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" rx=\"{}\"/>\n", class_of(look), box.x, box.y,
                     box.width, box.height, radius);
}

std::string text(std::string_view look, std::size_t x, std::size_t y, std::string_view text) {
  return fmt::format("<text{} x=\"{}\" y=\"{}\">{}</text>\n", class_of(look), x, y, escaped(text));
}

std::string picture(std::size_t width, std::size_t height, std::string_view title, std::string_view style,
                    std::string_view body) {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" role=\"img\">\n"
      "<title>{2}</title>\n<style>\n{3}</style>\n{4}</svg>\n",
      width, height, escaped(title), style, body);
}

}  // namespace finemote::gen::svg
