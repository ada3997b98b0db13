// MRS and MSR: the registers that are no general ones.
#include "emulator/core/interpreter.hpp"

namespace finemote::emulator {

/// MRS: B5.2.2.
void Interpreter::read_special(const Operation& o) {
  Registers& g = registers;
  std::uint32_t value = 0;
  switch (o.imm) {
    case 8:
      value = g.main_stack();
      break;
    case 9:
      value = g.process_stack();
      break;
    case 16:
      value = g.primask;
      break;
    case 17:
    case 18:
      value = g.basepri;
      break;
    case 19:
      value = g.faultmask;
      break;
    case 20:
      value = g.control | (fp_active ? 4U : 0U);
      break;
    default:  // APSR and IPSR in their combinations; EPSR reads as zero
      if (o.imm > 7) return;
      value = ((o.imm & 4) == 0 ? g.flags() | g.ge << 16 : 0) | ((o.imm & 1) != 0 ? g.exception : 0);
      break;
  }
  g.r[o.d] = value;
}

/// MSR: B5.2.3.
void Interpreter::write_special(const Operation& o) {
  Registers& g = registers;
  const std::uint32_t value = g.r[o.n];
  switch (o.imm) {
    case 8:
      g.main_stack() = value & ~3U;
      break;
    case 9:
      g.process_stack() = value & ~3U;
      break;
    case 16:
      g.primask = value & 1;
      break;
    case 17:
      g.basepri = value & 0xF0;
      break;
    case 18:
      if ((value & 0xF0) != 0 && (g.basepri == 0 || (value & 0xF0) < g.basepri)) g.basepri = value & 0xF0;
      break;
    case 19:
      g.faultmask = value & 1;
      break;
    case 20:
      if (g.exception == 0) g.choose_stack((value & Registers::kProcessStack) != 0);
      fp_active = (value & 4) != 0;
      if ((value & 1) != 0) outside_.report_unmodelled("thread mode without privileges");
      break;
    default:
      if (o.imm > 7 || (o.imm & 4) != 0) break;
      if ((o.mode & 2) != 0) g.set_flags(value);
      if ((o.mode & 1) != 0) g.ge = value >> 16 & 0xF;
      break;
  }
  outside_.masks_changed();
}

}  // namespace finemote::emulator
