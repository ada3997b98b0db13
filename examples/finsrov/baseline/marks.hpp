// Marks that say what a processor's time goes to, beside those of the stages.
#pragma once

#include "finemote/mark.hpp"

namespace baseline {

/// Numbers that no generated firmware uses; `tests/experiment/` knows them.
constexpr std::uint32_t kSpinMark = 0x50000;  ///< looks at a peripheral again and again
constexpr std::uint32_t kIdleMark = 0x50002;  ///< has nothing to do before the next period

/// Marks its scope, most of which is a loop. The instruction behind the mark keeps it out of the loop: it is passed
/// once.
template <std::uint32_t number>
class MarkedLoop {
 public:
  MarkedLoop() {
    finemote::mark<number>();
    asm volatile("nop");
  }
  ~MarkedLoop() { finemote::mark<number + 1U>(); }
  MarkedLoop(const MarkedLoop&) = delete;
  MarkedLoop& operator=(const MarkedLoop&) = delete;
};
using Spinning = MarkedLoop<kSpinMark>;
using Idle = MarkedLoop<kIdleMark>;

}  // namespace baseline
