// An image to the loops whose bounds its sources only tell, and to where a run can count their rounds.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "generator/image/image.hpp"

namespace finemote::gen::wcet {

/// A loop with `loop_bound<n>()` in its body: runtime/include/finemote/loop_bound.hpp.
struct MarkedLoop {
  std::uint32_t place = 0;   ///< address of the mark
  std::uint32_t header = 0;  ///< address that every turn passes first
  std::uint32_t bound =
      0;  ///< so often the source says that it is passed, from when the loop is entered to when it is left
  std::uint32_t allowed = 0;  ///< so often it may be passed: a mark before a test once more
  std::string function;
  std::vector<std::uint32_t> borders = {};  ///< addresses of which one is passed before each entry of the loop, or
                                            ///< behind each way out, and none in between
};

/// Those of which a run can tell when they are entered, by address. Of marks that lie in one loop of the image nobody
/// knows which loops they are of: there are none of these. Rounds that interrupts add to a loop
/// (`retried_if_interrupted()`) are not in its bound: there are none of these loops.
std::vector<MarkedLoop> marked_loops(const Image& image);

}  // namespace finemote::gen::wcet
