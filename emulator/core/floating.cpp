// The floating-point instructions: ARMv7-M Architecture Reference Manual A6.5 to A6.8.
#include "emulator/core/float_arithmetic.hpp"
#include "emulator/core/interpreter.hpp"

namespace finemote::emulator {
namespace {
constexpr std::uint32_t kModelledFpscr = 0xF000009F;  ///< flags; rounding, flushing and default NaN are not modelled
constexpr std::uint32_t kFlags = 0xF0000000U, kInvalid = 1;
}  // namespace

void Interpreter::float_transfer(const Operation& o) {
  Registers& g = registers;
  switch (o.kind) {
    case Opcode::vmov_to_core:
      g.r[o.d] = g.s[o.n];
      return;
    case Opcode::vmov_from_core:
      g.s[o.d] = g.r[o.n];
      return;
    case Opcode::vmov_pair:
      if (o.mode != 0) {
        g.r[o.d] = g.s[o.m];
        g.r[o.n] = g.s[o.m + 1U];
      } else {
        g.s[o.m] = g.r[o.d];
        g.s[o.m + 1U] = g.r[o.n];
      }
      return;
    case Opcode::vmrs:
      if (o.d == 15) {
        g.set_flags((g.fpscr & kFlags) | g.q << 27);
      } else {
        g.r[o.d] = g.fpscr;
      }
      return;
    default:
      if ((g.r[o.n] & ~kModelledFpscr) != 0) outside_.report_unmodelled("FPSCR rounding, flushing or default NaN");
      g.fpscr = g.r[o.n] & kModelledFpscr;
      return;
  }
}

/// A2.7.7: less 8, equal 6, greater 2, unordered 3.
void Interpreter::float_compare(std::uint32_t a, std::uint32_t b, bool signals) {
  const float x = as_float(a), y = as_float(b);
  const std::uint32_t flags = x < y ? 8 : x == y ? 6 : x > y ? 2 : 3;
  registers.fpscr = (registers.fpscr & ~kFlags) | flags << 28;
  if (flags == 3 && (signals || is_signalling(a) || is_signalling(b))) registers.fpscr |= kInvalid;
}

void Interpreter::floating(const Operation& o) {
  std::uint32_t& d = registers.s[o.d & 31U];
  const std::uint32_t n = registers.s[o.n & 31U], m = registers.s[o.m & 31U];
  switch (o.kind) {
    case Opcode::vmov_imm:
      d = o.imm;
      return;
    case Opcode::vmov:
      d = m;
      return;
    case Opcode::vabs:
      d = m & ~kFloatSign;
      return;
    case Opcode::vneg:
      d = m ^ kFloatSign;
      return;
    case Opcode::vadd:
      d = float_add(n, m);
      return;
    case Opcode::vsub:
      d = float_subtract(n, m);
      return;
    case Opcode::vmul:
      d = float_multiply(n, m);
      return;
    case Opcode::vnmul:
      d = float_multiply(n, m) ^ kFloatSign;
      return;
    case Opcode::vdiv:
      d = float_divide(n, m);
      return;
    case Opcode::vsqrt:
      d = float_root(m);
      return;
    case Opcode::vmla:
      d = float_add(d, float_multiply(n, m));
      return;
    case Opcode::vmls:
      d = float_add(d, float_multiply(n, m) ^ kFloatSign);
      return;
    case Opcode::vnmls:
      d = float_add(d ^ kFloatSign, float_multiply(n, m));
      return;
    case Opcode::vnmla:
      d = float_add(d ^ kFloatSign, float_multiply(n, m) ^ kFloatSign);
      return;
    case Opcode::vfma:
      d = float_fused(d, n, m);
      return;
    case Opcode::vfms:
      d = float_fused(d, n ^ kFloatSign, m);
      return;
    case Opcode::vfnma:
      d = float_fused(d ^ kFloatSign, n ^ kFloatSign, m);
      return;
    case Opcode::vfnms:
      d = float_fused(d ^ kFloatSign, n, m);
      return;
    case Opcode::vcmp:
      return float_compare(d, m, o.mode != 0);
    case Opcode::vcmp_zero:
      return float_compare(d, 0, o.mode != 0);
    case Opcode::vcvt_to_int:
      d = float_to_integer(as_float(m), (o.mode & 1) != 0, 32, (o.mode & 2) != 0);
      return;
    case Opcode::vcvt_from_int:
      d = as_bits(o.mode != 0 ? static_cast<float>(static_cast<std::int32_t>(m)) : static_cast<float>(m));
      return;
    case Opcode::vcvt_fixed: {  // in place; imm fraction bits
      const bool is_unsigned = (o.mode & 1) != 0, narrow = (o.mode & 4) == 0;
      const int fraction = static_cast<int>(o.imm);
      if ((o.mode & 2) != 0) {
        d = float_to_integer(std::ldexp(double{as_float(d)}, fraction), !is_unsigned, narrow ? 16 : 32, true);
        return;
      }
      const double whole =
          is_unsigned ? (narrow ? d & 0xFFFF : d)
                      : static_cast<double>(narrow ? static_cast<std::int16_t>(d) : static_cast<std::int32_t>(d));
      d = as_bits(static_cast<float>(std::ldexp(whole, -fraction)));
      return;
    }
    case Opcode::vcvt_half: {  // mode bit 0: top half, bit 1: to half
      const unsigned at = (o.mode & 1) != 0 ? 16 : 0;
      d = (o.mode & 2) != 0 ? (d & ~(0xFFFFU << at)) | float_to_half(m) << at : half_to_float(m >> at & 0xFFFF);
      return;
    }
    default:
      return float_transfer(o);
  }
}

}  // namespace finemote::emulator
