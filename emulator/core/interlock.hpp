// What an instruction waits for the one before it: Cortex-M4 TRM (DDI 0439) 3.3.2 and 7.2.3.
#pragma once

#include "emulator/core/operation.hpp"

namespace finemote::emulator {

/// Cycles that `second` waits when it runs directly after `first`: for an address that `first` computes, or for the
/// floating-point result or flags of `first`.
unsigned interlock(const Operation& first, const Operation& second);

}  // namespace finemote::emulator
