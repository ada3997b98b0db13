// Device trees to a picture, as SVG.
#pragma once

#include <string>

#include "generator/graph/forest_view.hpp"

namespace finemote::gen {

/// A card for every device below its parent: name, type and period, and its place on a bus. The buses stand above.
/// Cards are as wide as the longest texts; the colours follow the reader's light or dark setting and only repeat what
/// is written.
std::string forest_svg(const ForestView& view);

/// The same to stand in a page, which defines the colours (svg/palette.hpp) and has kForestStyle in its style sheet.
/// Each card is an element of class `device` with the device's name in `data-device`.
std::string inline_forest_svg(const ForestView& view);

extern const char* const kForestStyle;

}  // namespace finemote::gen
