// Marks that say what a processor's time goes to, beside those of the stages; like those they cost no instruction.
#pragma once

#include "finemote/mark.hpp"

namespace baseline {

/// Numbers that no generated firmware uses; `tests/experiment/` knows them.
constexpr std::uint32_t kSpinMark = 0x50000;  ///< looks at a peripheral again and again
constexpr std::uint32_t kIdleMark = 0x50002;  ///< has nothing to do before the next period

using Spinning = finemote::Marked<kSpinMark>;
using Idle = finemote::Marked<kIdleMark>;

}  // namespace baseline
