// How deep one function takes the stack, and whom it calls at which depth.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "generator/image/program.hpp"

namespace finemote::gen {

struct StackUse {
  struct Call {
    FlowCall call;
    std::uint32_t depth = 0;  ///< bytes of the caller's own on the stack at the call
  };
  std::uint32_t depth = 0;  ///< largest number of own bytes on the stack
  std::vector<Call> calls;  ///< tail calls included
  std::string problem;      ///< why the depth is not known, for example a variable-length array; empty: it is
};

/// Every path is followed, conditions taken both ways, so the depth is exact for code whose stack is balanced and never
/// too small.
StackUse stack_use(const ProgramFunction& function);

}  // namespace finemote::gen
