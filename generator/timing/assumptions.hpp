// What every bound of profile `target` assumes, and whether the firmware notices where it does not hold.
#pragma once

#include <span>
#include <string_view>

namespace finemote::gen::timing {

/// One statement about the robot, its board and its parts that the analysis cannot check.
struct Assumption {
  enum class Detected {
    counted,       ///< a fault, an overrun, or a bound that the monitor saw exceeded
    stopped,       ///< the firmware goes to its safe stop, or the watchdog restarts the board
    undetectable,  ///< nothing on the board can tell, or not always
  };
  std::string_view id;  ///< stable: names it in documents
  std::string_view text;
  Detected detected;
};

/// In the order of docs/timing.md, which says of each what happens when it is violated.
std::span<const Assumption> assumptions();

/// `counted`, `stopped`, `undetectable`.
std::string_view to_string(Assumption::Detected detected);

}  // namespace finemote::gen::timing
