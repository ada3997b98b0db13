// Follows the instructions of one function: how deep it takes the stack, and whom it calls at which depth.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "generator/image/image.hpp"

namespace finemote::gen {

struct Call {
  std::uint32_t at = 0;                 ///< address of the instruction
  std::uint32_t depth = 0;              ///< bytes of the caller's own on the stack at the call
  std::optional<std::uint32_t> target;  ///< none: through a register
};

struct FunctionFlow {
  std::uint32_t depth = 0;  ///< largest number of own bytes on the stack
  std::vector<Call> calls;  ///< tail calls included
  std::string problem;      ///< why the depth is not known, for example a variable-length array; empty: it is
};

/// `function` is a function symbol of the image, Thumb-2 code. Every path is followed, conditions taken both ways, so
/// the depth is exact for code whose stack is balanced and never too small. `size` 0: up to the next symbol.
FunctionFlow follow(const Image& image, const ImageSymbol& function);

}  // namespace finemote::gen
