// Floating-point instructions, taken apart: ARMv7-M Architecture Reference Manual A6.4 to A6.7.
#include "emulator/core/encoding.hpp"

namespace finemote::emulator {
namespace {

using namespace encoding;

/// Numbers of the registers an instruction names: single ones, of a double the lower half.
struct Names {
  unsigned d, n, m;
};

Names names(unsigned first, unsigned second) {
  const bool wide = bits(second, 8, 8) != 0;
  const auto number = [wide](unsigned four, unsigned one) { return wide ? (one << 4 | four) << 1 : four << 1 | one; };
  return {number(bits(second, 15, 12), bits(first, 6, 6)), number(bits(first, 3, 0), bits(second, 7, 7)),
          number(second & 0xF, bits(second, 5, 5))};
}

/// A6.6: VLDR, VSTR, VLDM, VSTM; imm is a distance in bytes, `amount` a count of words.
Op load_store(unsigned first, unsigned second) {
  const bool before = bits(first, 8, 8) != 0, up = bits(first, 7, 7) != 0, back = bits(first, 5, 5) != 0,
             load = bits(first, 4, 4) != 0, wide = bits(second, 8, 8) != 0;
  const unsigned words = second & 0xFF, n = bits(first, 3, 0), d = names(first, second).d;
  const std::uint32_t imm = up ? words * 4 : 0U - words * 4;
  Op o;
  if (before && !back) {
    o = make(load ? Opcode::vldr : Opcode::vstr, d, n, 0, imm);
    o.amount = wide ? 2 : 1;
  } else {
    if (before == up) return {};
    const unsigned count = words & (wide ? ~1U : ~0U);
    if (count == 0 || d + count > 32) return {};
    o = make(load ? Opcode::vldm : Opcode::vstm, d, n, 0, words * 4, (back ? 1U : 0U) | (before ? 2U : 0U));
    o.amount = static_cast<Byte>(count);
  }
  return d + o.amount > 32 ? Op{} : o;
}

/// A6.7 and A6.8: between core and floating-point registers.
Op transfer(unsigned first, unsigned second) {
  const bool to_core = bits(first, 4, 4) != 0, wide = bits(second, 8, 8) != 0;
  const unsigned t = bits(second, 15, 12), n = bits(first, 3, 0);
  if (!wide) {
    const unsigned s = n << 1 | bits(second, 7, 7);
    if (bits(first, 7, 5) == 0) return to_core ? make(Opcode::vmov_to_core, t, s) : make(Opcode::vmov_from_core, s, t);
    if (bits(first, 7, 5) == 7 && n == 1) return to_core ? make(Opcode::vmrs, t) : make(Opcode::vmsr, 0, t);
    return {};
  }
  if (bits(first, 7, 6) != 0 || bits(second, 6, 5) != 0) return {};
  const unsigned s = (bits(second, 7, 7) << 4 | n) * 2 + bits(first, 5, 5);
  if (s > 31) return {};
  return to_core ? make(Opcode::vmov_to_core, t, s) : make(Opcode::vmov_from_core, s, t);
}

Op transfer_pair(unsigned first, unsigned second) {
  const unsigned m = names(first, second).m;
  if ((second & 0xD0) != 0x10 || m > 30) return {};
  Op o = make(Opcode::vmov_pair, bits(second, 15, 12), bits(first, 3, 0), m, 0, bits(first, 4, 4));
  return o;
}

/// VFPExpandImm, A6.4.1.
std::uint32_t expand(unsigned imm8) {
  const std::uint32_t sign = imm8 >> 7, b = imm8 >> 6 & 1;
  return sign << 31 | (b ^ 1) << 30 | (b != 0 ? 0x1FU : 0U) << 25 | (imm8 & 0x3F) << 19;
}

/// A6.5, table A6-3.
Op other(unsigned first, unsigned second) {
  const Names r = names(first, second);
  const unsigned opc2 = bits(first, 3, 0), top = bits(second, 7, 7);
  if (bits(second, 6, 6) == 0) {
    const unsigned imm8 = opc2 << 4 | (second & 0xF);
    return make(Opcode::vmov_imm, r.d, 0, 0, expand(imm8));
  }
  switch (opc2) {
    case 0x0:
      return make(top != 0 ? Opcode::vabs : Opcode::vmov, r.d, 0, r.m);
    case 0x1:
      return make(top != 0 ? Opcode::vsqrt : Opcode::vneg, r.d, 0, r.m);
    case 0x2:
    case 0x3:
      return make(Opcode::vcvt_half, r.d, 0, r.m, 0, top | (opc2 & 1) << 1);
    case 0x4:
      return make(Opcode::vcmp, r.d, 0, r.m, 0, top);
    case 0x5:
      return make(Opcode::vcmp_zero, r.d, 0, 0, 0, top);
    case 0x8:
      return make(Opcode::vcvt_from_int, r.d, 0, r.m, 0, top);
    case 0xC:
    case 0xD:
      return make(Opcode::vcvt_to_int, r.d, 0, r.m, 0, (opc2 & 1) | top << 1);
    case 0xA:
    case 0xB:
    case 0xE:
    case 0xF: {  // mode: bit 0 unsigned, bit 1 from float, bit 2: 32 bits
      const unsigned size = top != 0 ? 32 : 16, given = (second & 0xF) << 1 | bits(second, 5, 5);
      if (given > size) return {};
      return make(Opcode::vcvt_fixed, r.d, 0, r.d, size - given, (opc2 & 1) | (opc2 & 4) >> 1 | top << 2);
    }
    default:
      return {};
  }
}

/// A6.5, table A6-2.
Op arithmetic(unsigned first, unsigned second) {
  if (bits(second, 8, 8) != 0) return {};  // doubles: not on this core
  const Names r = names(first, second);
  const bool op = bits(second, 6, 6) != 0;
  const auto three = [&](Opcode kind) { return make(kind, r.d, r.n, r.m); };
  switch (bits(first, 7, 7) << 2 | bits(first, 5, 4)) {
    case 0:
      return three(op ? Opcode::vmls : Opcode::vmla);
    case 1:
      return three(op ? Opcode::vnmla : Opcode::vnmls);
    case 2:
      return three(op ? Opcode::vnmul : Opcode::vmul);
    case 3:
      return three(op ? Opcode::vsub : Opcode::vadd);
    case 4:
      return op ? Op{} : three(Opcode::vdiv);
    case 5:
      return three(op ? Opcode::vfnma : Opcode::vfnms);
    case 6:
      return three(op ? Opcode::vfms : Opcode::vfma);
    default:
      return other(first, second);
  }
}

}  // namespace

Operation take_apart_float(unsigned first, unsigned second) {
  if ((first & 0xFFE0) == 0xEC40) return transfer_pair(first, second);
  if ((first & 0xFE00) == 0xEC00) return load_store(first, second);
  if ((first & 0xFF00) != 0xEE00) return {};
  return bits(second, 4, 4) != 0 ? transfer(first, second) : arithmetic(first, second);
}

}  // namespace finemote::emulator
