// Where control goes after an instruction.
#pragma once

#include <cstdint>

#include "generator/image/instruction.hpp"

namespace finemote::gen {

struct Transfer {
  enum class Kind {
    next,      ///< to the next instruction only
    jump,      ///< to `target`
    call,      ///< of `target`, and on after it when that returns
    indirect,  ///< call through a register
    tail,      ///< jump through a register
    table,     ///< to an entry of a table
    leave,     ///< return to the caller
    stop,      ///< nowhere: an instruction that is undefined on purpose
    unknown,   ///< to a place that the instruction alone does not tell
  };
  Kind kind = Kind::next;
  bool may_fall_through = true;  ///< to the next instruction: not taken, or a call that returned
  std::uint32_t target = 0;      ///< of a jump or a direct call
};

/// Sources: ARMv7-M A7.7. An instruction that the decoder does not know is `unknown`.
Transfer transfer_of(const Instruction& instruction);

}  // namespace finemote::gen
