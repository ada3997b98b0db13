// The line of the user's code at a place of an image that marks of loops may lie at.
#pragma once

#include <cstdint>
#include <optional>

#include "generator/image/source_lines.hpp"

namespace finemote::gen {

/// The first line at the address or right after it that is not a mark's own; none: the image does not tell.
std::optional<SourceLine> code_line(const SourceLines& lines, std::uint32_t address);

}  // namespace finemote::gen
