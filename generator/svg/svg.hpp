// Boxes, texts and lines to the elements of an SVG picture.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "generator/xml/escape.hpp"

namespace finemote::gen::svg {

// In pixels. A character of a monospaced font of 13 px is 0.6 of its size wide; 8 leaves room for wider ones.
inline constexpr std::size_t kCharacter = 8;

/// The font of all texts: a line of CSS without its selector.
inline constexpr const char* kFont = "13px \"DejaVu Sans Mono\", \"Liberation Mono\", Menlo, Consolas, monospace";

struct Box {
  std::size_t x = 0, y = 0, width = 0, height = 0;
};

using xml::escaped;  // of HTML, too

/// How many characters of a monospaced font a text is wide: two for those of East Asian scripts.
std::size_t columns(std::string_view text);

/// How many pixels a text in kFont is wide, at most.
inline std::size_t width_of(std::string_view text) { return kCharacter * columns(text); }

/// `look`: its class in CSS; empty: none.
std::string rect(std::string_view look, const Box& box, std::size_t radius);
std::string text(std::string_view look, std::size_t x, std::size_t y, std::string_view text);

/// The whole file. `title` is what a screen reader says of it; `style` is CSS.
std::string picture(std::size_t width, std::size_t height, std::string_view title, std::string_view style,
                    std::string_view body);

}  // namespace finemote::gen::svg
