// An image to the loops whose bounds its sources only tell, and to where a run can count their iterations.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "generator/image/image.hpp"

namespace finemote::gen::wcet {

/// A loop with a `LoopBound<n>`, or with `retried_if_interrupted()`: runtime/include/finemote/loop_bound.hpp.
struct MarkedLoop {
  std::uint32_t place = 0;   ///< address of the mark
  std::uint32_t header = 0;  ///< address that every iteration passes first
  std::uint32_t bound = 0;   ///< how often it is passed, at most, from when the loop is entered to when it is left
  bool is_for_interrupts = false;  ///< and once more for each interrupt: `retried_if_interrupted()`
  std::string function;
  std::vector<std::uint32_t> borders = {};  ///< addresses of which one is passed before each entry of the loop, or
                                            ///< after each way out, and none in between
};

/// Those of which a run can tell when they are entered, by address. Of marks that have come to lie in a loop of the
/// image which they are not of there are none.
std::vector<MarkedLoop> marked_loops(const Image& image);

}  // namespace finemote::gen::wcet
