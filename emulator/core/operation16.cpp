// 16-bit Thumb instructions, taken apart: ARMv7-M Architecture Reference Manual A5.2.
#include "emulator/core/encoding.hpp"

namespace finemote::emulator {
namespace {

using namespace encoding;

/// A5.2.2.
Op data_processing16(unsigned op) {
  const unsigned d = bits(op, 2, 0), m = bits(op, 5, 3);
  const auto reg = [&](Opcode kind) { return with_flags(make(kind, d, d, m)); };
  const auto by = [&](Shift shift) {
    Op o = with_flags(make(Opcode::shift_by, d, d, m));
    o.shift = shift;
    return o;
  };
  switch (bits(op, 9, 6)) {
    case 0:
      return reg(Opcode::and_reg);
    case 1:
      return reg(Opcode::eor_reg);
    case 2:
      return by(Shift::lsl);
    case 3:
      return by(Shift::lsr);
    case 4:
      return by(Shift::asr);
    case 5:
      return reg(Opcode::adc_reg);
    case 6:
      return reg(Opcode::sbc_reg);
    case 7:
      return by(Shift::ror);
    case 8:
      return with_flags(make(Opcode::tst_reg, 0, d, m), Op::kAlways);
    case 9:
      return with_flags(make(Opcode::rsb_imm, d, m, 0, 0));
    case 10:
      return with_flags(make(Opcode::cmp_reg, 0, d, m), Op::kAlways);
    case 11:
      return with_flags(make(Opcode::cmn_reg, 0, d, m), Op::kAlways);
    case 12:
      return reg(Opcode::orr_reg);
    case 13:
      return with_flags(make(Opcode::mul, d, m, d));
    case 14:
      return reg(Opcode::bic_reg);
    default:
      return with_flags(make(Opcode::mvn_reg, d, 0, m));
  }
}

/// A5.2.3.
Op special16(unsigned op) {
  const unsigned d = bits(op, 2, 0) | bits(op, 7, 7) << 3, m = bits(op, 6, 3);
  switch (bits(op, 9, 8)) {
    case 0:
      return make(d == 15 ? Opcode::add_pc : Opcode::add_plain, d, d, m);
    case 1:
      return with_flags(make(Opcode::cmp_reg, 0, d, m), Op::kAlways);
    case 2:
      return make(d == 15 ? Opcode::mov_pc : Opcode::mov_plain, d, 0, m);
    default:
      return make(bits(op, 7, 7) != 0 ? Opcode::blx : Opcode::bx, 0, 0, m);
  }
}

/// A5.2.1.
Op shift_add_move(unsigned op) {
  const unsigned d = bits(op, 2, 0), n = bits(op, 5, 3), imm3 = bits(op, 8, 6), r8 = bits(op, 10, 8);
  switch (bits(op, 13, 11)) {
    case 0:
    case 1:
    case 2:
      return shifted(with_flags(make(Opcode::mov_reg, d, 0, n)), bits(op, 12, 11), bits(op, 10, 6));
    case 3:
      if (bits(op, 10, 10) != 0)
        return with_flags(make(bits(op, 9, 9) != 0 ? Opcode::sub_imm : Opcode::add_imm, d, n, 0, imm3));
      return with_flags(make(bits(op, 9, 9) != 0 ? Opcode::sub_reg : Opcode::add_reg, d, n, imm3));
    case 4:
      return with_flags(make(Opcode::mov_imm, r8, 0, 0, op & 0xFF));
    case 5:
      return with_flags(make(Opcode::cmp_imm, 0, r8, 0, op & 0xFF), Op::kAlways);
    case 6:
      return with_flags(make(Opcode::add_imm, r8, r8, 0, op & 0xFF));
    default:
      return with_flags(make(Opcode::sub_imm, r8, r8, 0, op & 0xFF));
  }
}

/// A5.2.4.
Op load_store16(unsigned op) {
  const unsigned d = bits(op, 2, 0), n = bits(op, 5, 3), imm5 = bits(op, 10, 6);
  if (bits(op, 15, 12) == 5) {
    constexpr Opcode kinds[] = {Opcode::str_reg, Opcode::strh_reg, Opcode::strb_reg, Opcode::ldrsb_reg,
                                Opcode::ldr_reg, Opcode::ldrh_reg, Opcode::ldrb_reg, Opcode::ldrsh_reg};
    return make(kinds[bits(op, 11, 9)], d, n, bits(op, 8, 6));
  }
  switch (bits(op, 15, 11)) {
    case 12:
      return make(Opcode::str_imm, d, n, 0, imm5 * 4);
    case 13:
      return make(Opcode::ldr_imm, d, n, 0, imm5 * 4);
    case 14:
      return make(Opcode::strb_imm, d, n, 0, imm5);
    case 15:
      return make(Opcode::ldrb_imm, d, n, 0, imm5);
    case 16:
      return make(Opcode::strh_imm, d, n, 0, imm5 * 2);
    case 17:
      return make(Opcode::ldrh_imm, d, n, 0, imm5 * 2);
    case 18:
      return make(Opcode::str_imm, bits(op, 10, 8), 13, 0, (op & 0xFF) * 4);
    default:
      return make(Opcode::ldr_imm, bits(op, 10, 8), 13, 0, (op & 0xFF) * 4);
  }
}

/// A5.2.5.
Op miscellaneous16(unsigned op) {
  const unsigned d = bits(op, 2, 0), m = bits(op, 5, 3);
  if ((op & 0x0500) == 0x0100)
    return make(bits(op, 11, 11) != 0 ? Opcode::cbnz : Opcode::cbz, 0, d, 0, bits(op, 9, 9) << 6 | bits(op, 7, 3) << 1);
  switch (bits(op, 11, 8)) {
    case 0x0:
      return make(bits(op, 7, 7) != 0 ? Opcode::sub_imm : Opcode::add_imm, 13, 13, 0, (op & 0x7F) * 4);
    case 0x2: {
      constexpr unsigned modes[] = {0, Extend::kByte, Extend::kUnsigned, Extend::kUnsigned | Extend::kByte};
      return extend(d, 15, m, 0, modes[bits(op, 7, 6)]);
    }
    case 0x4:
    case 0x5:
      return with_mode(make(Opcode::stm, 0, 13, 0, (op & 0xFF) | bits(op, 8, 8) << 14), 3);
    case 0x6:
      if ((op & 0xFFE8) == 0xB660) return with_mode(make(Opcode::cps, 0, 0, 0, op & 3), bits(op, 4, 4));
      return {};
    case 0xA: {
      constexpr Opcode kinds[] = {Opcode::rev, Opcode::rev16, Opcode::undefined, Opcode::revsh};
      return make(kinds[bits(op, 7, 6)], d, 0, m);
    }
    case 0xC:
    case 0xD:
      return with_mode(make(Opcode::ldm, 0, 13, 0, (op & 0xFF) | bits(op, 8, 8) << 15), 1);
    case 0xE:
      return make(Opcode::bkpt);
    case 0xF:
      if ((op & 0xF) != 0) return make(Opcode::it, 0, 0, 0, op & 0xFF);
      return make(op == 0xBF30 ? Opcode::wfi : Opcode::nop);
    default:
      return {};
  }
}

}  // namespace

/// A5.2.
Operation take_apart16(unsigned op) {
  switch (bits(op, 15, 12)) {
    case 0x0:
    case 0x1:
    case 0x2:
    case 0x3:
      return shift_add_move(op);
    case 0x4:
      if (bits(op, 11, 11) != 0) return make(Opcode::ldr_lit, bits(op, 10, 8), 15, 0, (op & 0xFF) * 4);
      return bits(op, 10, 10) != 0 ? special16(op) : data_processing16(op);
    case 0xA:
      if (bits(op, 11, 11) != 0) return make(Opcode::add_imm, bits(op, 10, 8), 13, 0, (op & 0xFF) * 4);
      return make(Opcode::adr, bits(op, 10, 8), 0, 0, (op & 0xFF) * 4);
    case 0xB:
      return miscellaneous16(op);
    case 0xC: {
      const unsigned n = bits(op, 10, 8);
      const bool load = bits(op, 11, 11) != 0, back = !load || (op >> n & 1) == 0;
      return with_mode(make(load ? Opcode::ldm : Opcode::stm, 0, n, 0, op & 0xFF), back ? 1 : 0);
    }
    case 0xD:
      if (bits(op, 11, 8) == 14) return {};
      if (bits(op, 11, 8) == 15) return make(Opcode::svc);
      return with_mode(make(Opcode::b_cond, 0, 0, 0, sign_extend((op & 0xFF) << 1, 9)), bits(op, 11, 8));
    case 0xE:
      return make(Opcode::b, 0, 0, 0, sign_extend((op & 0x7FF) << 1, 12));
    default:
      return load_store16(op);
  }
}

}  // namespace finemote::emulator
