#include "emulator/core/operation.hpp"

#include <bit>

namespace finemote::emulator {
namespace {

using Op = Operation;
using Byte = std::uint8_t;

constexpr unsigned bits(unsigned value, unsigned high, unsigned low) {
  return value >> low & ((2U << (high - low)) - 1);
}

constexpr std::uint32_t sign_extend(std::uint32_t value, unsigned width) {
  const std::uint32_t top = 1U << (width - 1);
  return (value ^ top) - top;
}

Op make(Opcode kind, unsigned d = 0, unsigned n = 0, unsigned m = 0, std::uint32_t imm = 0) {
  Op o;
  o.kind = kind;
  o.d = static_cast<Byte>(d);
  o.n = static_cast<Byte>(n);
  o.m = static_cast<Byte>(m);
  o.imm = imm;
  return o;
}

Op with_flags(Op o, Byte sets = Op::kOutsideIt) {
  o.sets = sets;
  return o;
}

/// DecodeImmShift, A7.4.2.
Op shifted(Op o, unsigned type, unsigned amount) {
  o.shift = static_cast<Shift>(type);
  o.amount = static_cast<Byte>(amount);
  if (type != 0 && amount == 0) {
    if (type == 3) {
      o.shift = Shift::rrx;
      o.amount = 1;
    } else {
      o.amount = 32;
    }
  }
  return o;
}

Op with_mode(Op o, unsigned mode) {
  o.mode = static_cast<Byte>(mode);
  return o;
}

Op with_amount(Op o, unsigned amount) {
  o.amount = static_cast<Byte>(amount);
  return o;
}

/// @param fourth  the register that is added, or a width
Op media(Media what, unsigned d, unsigned n, unsigned m, unsigned fourth, unsigned mode) {
  Op o = with_mode(make(Opcode::media, d, n, m, fourth), mode);
  o.a = static_cast<Byte>(what);
  return o;
}

constexpr Opcode offset(Opcode first, unsigned by) { return static_cast<Opcode>(static_cast<unsigned>(first) + by); }

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

Op extend(unsigned d, unsigned n, unsigned m, unsigned rotation, unsigned mode) {
  return with_amount(with_mode(make(Opcode::extend, d, n, m), mode), rotation);
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

/// A5.2.
Op take_apart16(unsigned op) {
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

/// ThumbExpandImm, A5.3.2; `rotated`: the carry becomes bit 31.
std::uint32_t expand(unsigned imm12, bool& rotated) {
  const std::uint32_t imm8 = imm12 & 0xFF;
  rotated = imm12 >= 0x400;
  if (rotated) {
    const std::uint32_t value = 0x80 | (imm12 & 0x7F);
    const unsigned by = imm12 >> 7;
    return value >> by | value << (32 - by);
  }
  switch (imm12 >> 8) {
    case 0:
      return imm8;
    case 1:
      return imm8 << 16 | imm8;
    case 2:
      return imm8 << 24 | imm8 << 8;
    default:
      return imm8 * 0x01010101U;
  }
}

/// The operation of A5.3.1 and A5.3.11, with an immediate; `undefined` when there is none.
Opcode data_processing_kind(unsigned code, unsigned n, unsigned d, bool sets) {
  const bool no_result = d == 15 && sets;
  switch (code) {
    case 0:
      return no_result ? Opcode::tst_imm : Opcode::and_imm;
    case 1:
      return Opcode::bic_imm;
    case 2:
      return n == 15 ? Opcode::mov_imm : Opcode::orr_imm;
    case 3:
      return n == 15 ? Opcode::mvn_imm : Opcode::orn_imm;
    case 4:
      return no_result ? Opcode::teq_imm : Opcode::eor_imm;
    case 8:
      return no_result ? Opcode::cmn_imm : Opcode::add_imm;
    case 10:
      return Opcode::adc_imm;
    case 11:
      return Opcode::sbc_imm;
    case 13:
      return no_result ? Opcode::cmp_imm : Opcode::sub_imm;
    case 14:
      return Opcode::rsb_imm;
    default:
      return Opcode::undefined;
  }
}

Op modified_immediate(unsigned first, unsigned second) {
  const unsigned n = bits(first, 3, 0), d = bits(second, 11, 8);
  const bool sets = bits(first, 4, 4) != 0;
  bool rotated = false;
  const std::uint32_t imm = expand(bits(first, 10, 10) << 11 | bits(second, 14, 12) << 8 | (second & 0xFF), rotated);
  const Op o = make(data_processing_kind(bits(first, 8, 5), n, d, sets), d, n, 0, imm);
  return with_mode(with_flags(o, sets ? Op::kAlways : Op::kNever), rotated ? 1 : 0);
}

/// A5.3.3.
Op plain_immediate(unsigned first, unsigned second) {
  const unsigned n = bits(first, 3, 0), d = bits(second, 11, 8), low = bits(second, 14, 12) << 2 | bits(second, 7, 6);
  const unsigned imm12 = bits(first, 10, 10) << 11 | bits(second, 14, 12) << 8 | (second & 0xFF);
  const unsigned five = second & 0x1F;
  switch (bits(first, 8, 4)) {
    case 0x00:
      return n == 15 ? make(Opcode::adr, d, 0, 0, imm12) : make(Opcode::add_imm, d, n, 0, imm12);
    case 0x04:
      return make(Opcode::mov_imm, d, 0, 0, n << 12 | imm12);
    case 0x0A:
      return n == 15 ? make(Opcode::adr, d, 0, 0, 0U - imm12) : make(Opcode::sub_imm, d, n, 0, imm12);
    case 0x0C:
      return make(Opcode::movt, d, 0, 0, n << 12 | imm12);
    case 0x10:
    case 0x12:
      if (bits(first, 5, 5) != 0 && low == 0) return media(Media::ssat16, d, n, 0, (second & 0xF) + 1, 0);
      return shifted(make(Opcode::ssat, d, 0, n, five + 1), bits(first, 5, 5) * 2, low);
    case 0x14:
      return with_amount(make(Opcode::sbfx, d, n, 0, five + 1), low);
    case 0x16:
      return with_amount(make(Opcode::bfi, d, n, 0, five), low);  // n = 15: BFC
    case 0x18:
    case 0x1A:
      if (bits(first, 5, 5) != 0 && low == 0) return media(Media::usat16, d, n, 0, second & 0xF, 0);
      return shifted(make(Opcode::usat, d, 0, n, five), bits(first, 5, 5) * 2, low);
    case 0x1C:
      return with_amount(make(Opcode::ubfx, d, n, 0, five + 1), low);
    default:
      return {};
  }
}

/// A5.3.4 to A5.3.6.
Op branch_or_control(unsigned first, unsigned second) {
  const unsigned s = bits(first, 10, 10), j1 = bits(second, 13, 13), j2 = bits(second, 11, 11);
  if (bits(second, 14, 14) != 0 || bits(second, 12, 12) != 0) {
    if (bits(second, 14, 14) != 0 && bits(second, 12, 12) == 0) return {};
    const unsigned i1 = (j1 ^ s) ^ 1, i2 = (j2 ^ s) ^ 1;
    const std::uint32_t distance =
        sign_extend(s << 24 | i1 << 23 | i2 << 22 | bits(first, 9, 0) << 12 | bits(second, 10, 0) << 1, 25);
    return make(bits(second, 14, 14) != 0 ? Opcode::bl : Opcode::b, 0, 0, 0, distance);
  }
  if (bits(first, 9, 7) != 7) {
    const std::uint32_t distance =
        sign_extend(s << 20 | j2 << 19 | j1 << 18 | bits(first, 5, 0) << 12 | bits(second, 10, 0) << 1, 21);
    return with_mode(make(Opcode::b_cond, 0, 0, 0, distance), bits(first, 9, 6));
  }
  switch (bits(first, 10, 4)) {
    case 0x38:
    case 0x39:
      return with_mode(make(Opcode::msr, 0, bits(first, 3, 0), 0, second & 0xFF), bits(second, 11, 10));
    case 0x3A:
      return make((second & 0xFF) == 3 ? Opcode::wfi : Opcode::nop);
    case 0x3B:
      return make(bits(second, 7, 4) == 2 ? Opcode::clrex : bits(second, 7, 4) == 4 ? Opcode::dsb : Opcode::nop);
    case 0x3E:
    case 0x3F:
      return make(Opcode::mrs, bits(second, 11, 8), 0, 0, second & 0xFF);
    default:
      return {};
  }
}

/// A5.3.6 and the table branch: LDRD, STRD, exclusives.
Op dual_or_exclusive(unsigned first, unsigned second) {
  const unsigned n = bits(first, 3, 0), t = bits(second, 15, 12), t2 = bits(second, 11, 8), imm8 = second & 0xFF;
  const bool before = bits(first, 8, 8) != 0, up = bits(first, 7, 7) != 0, back = bits(first, 5, 5) != 0,
             load = bits(first, 4, 4) != 0;
  if (before || back) {
    Op o = make(load ? Opcode::ldrd : Opcode::strd, t, n, 0, up ? imm8 * 4 : 0U - imm8 * 4);
    o.a = static_cast<Byte>(t2);
    return with_mode(o, (back ? 1U : 0U) | (before ? 2U : 0U));
  }
  if (!up)
    return with_amount(load ? make(Opcode::ldrex, t, n, 0, imm8 * 4) : make(Opcode::strex, t2, n, t, imm8 * 4), 2);
  switch (bits(second, 7, 4)) {
    case 0:
    case 1:
      return load ? make(bits(second, 4, 4) != 0 ? Opcode::tbh : Opcode::tbb, 0, n, second & 0xF) : Op{};
    case 4:
    case 5:
      return with_amount(load ? make(Opcode::ldrex, t, n) : make(Opcode::strex, second & 0xF, n, t),
                         bits(second, 4, 4));
    default:
      return {};
  }
}

/// A5.3.7 to A5.3.10.
Op load_store32(unsigned first, unsigned second) {
  const unsigned n = bits(first, 3, 0), t = bits(second, 15, 12), size = bits(first, 6, 5);
  const bool load = bits(first, 4, 4) != 0, is_signed = bits(first, 8, 8) != 0;
  if (size == 3 || (is_signed && (size == 2 || !load))) return {};
  // Counted as in Opcode: ldr ldrb ldrh ldrsb ldrsh str strb strh.
  const unsigned which = load ? (size == 2 ? 0 : size + 1 + (is_signed ? 2 : 0)) : (size == 2 ? 5 : size + 6);
  if (load && t == 15 && size != 2) return make(Opcode::nop);  // PLD and its like
  if (n == 15) {
    if (!load) return {};
    const std::uint32_t imm12 = second & 0xFFF;
    return make(offset(Opcode::ldr_lit, which), t, 15, 0, bits(first, 7, 7) != 0 ? imm12 : 0U - imm12);
  }
  if (bits(first, 7, 7) != 0) return make(offset(Opcode::ldr_imm, which), t, n, 0, second & 0xFFF);
  if (bits(second, 11, 11) == 0) {
    if (bits(second, 10, 6) != 0) return {};
    return with_amount(make(offset(Opcode::ldr_reg, which), t, n, second & 0xF), bits(second, 5, 4));
  }
  const std::uint32_t imm = bits(second, 9, 9) != 0 ? second & 0xFF : 0U - (second & 0xFF);
  const bool before = bits(second, 10, 10) != 0, back = bits(second, 8, 8) != 0;
  if (before && !back) return make(offset(Opcode::ldr_imm, which), t, n, 0, imm);
  if (!before && !back) return {};
  Op o = with_mode(make(Opcode::indexed, t, n, 0, imm), before ? 1 : 2);
  o.a = static_cast<Byte>(which);
  return o;
}

/// A5.3.12 to A5.3.15.
Op data_processing_register(unsigned first, unsigned second) {
  const unsigned op1 = bits(first, 7, 4), op2 = bits(second, 7, 4), n = bits(first, 3, 0), d = bits(second, 11, 8),
                 m = second & 0xF;
  if (bits(second, 15, 12) != 15) return {};
  if (op1 < 8 && op2 == 0) {
    Op o = with_flags(make(Opcode::shift_by, d, n, m), bits(first, 4, 4) != 0 ? Op::kAlways : Op::kNever);
    o.shift = static_cast<Shift>(op1 >> 1);
    return o;
  }
  if (op1 < 6 && op2 >= 8) {
    constexpr unsigned modes[] = {0,
                                  Extend::kUnsigned,
                                  Extend::kByte | Extend::kPair,
                                  Extend::kUnsigned | Extend::kByte | Extend::kPair,
                                  Extend::kByte,
                                  Extend::kUnsigned | Extend::kByte};
    return extend(d, n, m, (op2 & 3) * 8, modes[op1]);
  }
  if (op1 >= 8 && op2 < 8 && (op2 & 3) != 3) return media(Media::parallel_add, d, n, m, 0, (op1 & 7) << 4 | op2);
  if (op1 >= 8 && op1 < 12 && op2 >= 8 && op2 < 12) {
    constexpr Opcode reversals[] = {Opcode::rev, Opcode::rev16, Opcode::rbit, Opcode::revsh};
    if (op1 == 8) return media(Media::qadd, d, n, m, 0, op2 & 3);
    if (op1 == 9) return make(reversals[op2 & 3], d, 0, m);
    if (op1 == 10 && op2 == 8) return media(Media::sel, d, n, m, 0, 0);
    if (op1 == 11 && op2 == 8) return make(Opcode::clz, d, 0, m);
  }
  return {};
}

/// A5.3.16.
Op multiply(unsigned first, unsigned second) {
  const unsigned n = bits(first, 3, 0), a = bits(second, 15, 12), d = bits(second, 11, 8), m = second & 0xF,
                 op2 = bits(second, 5, 4);
  if (bits(second, 7, 6) != 0) return {};
  const unsigned exchanged = op2 & 1;
  switch (bits(first, 6, 4)) {
    case 0: {
      if (op2 > 1) return {};
      Op o = make(op2 == 1 ? Opcode::mls : a == 15 ? Opcode::mul : Opcode::mla, d, n, m);
      o.a = static_cast<Byte>(a);
      return o;
    }
    case 1:
      return media(Media::smlaxy, d, n, m, a, op2);
    case 2:
      return op2 > 1 ? Op{} : media(Media::smlad, d, n, m, a, exchanged);
    case 3:
      return op2 > 1 ? Op{} : media(Media::smlaw, d, n, m, a, exchanged);
    case 4:
      return op2 > 1 ? Op{} : media(Media::smlad, d, n, m, a, exchanged | 2);
    case 5:
      return op2 > 1 ? Op{} : media(Media::smmla, d, n, m, a, op2);
    case 6:
      return op2 > 1 ? Op{} : media(Media::smmla, d, n, m, a, op2 | 2);
    default:
      return op2 > 0 ? Op{} : media(Media::usad8, d, n, m, a, 0);
  }
}

/// A5.3.17.
Op long_multiply(unsigned first, unsigned second) {
  const unsigned n = bits(first, 3, 0), low = bits(second, 15, 12), high = bits(second, 11, 8), m = second & 0xF,
                 op1 = bits(first, 6, 4), op2 = bits(second, 7, 4);
  const auto wide = [&](Opcode kind) {
    Op o = make(kind, low, n, m);
    o.a = static_cast<Byte>(high);
    return o;
  };
  const unsigned code = op1 << 4 | op2;
  switch (code) {
    case 0x00:
      return wide(Opcode::smull);
    case 0x1F:
      return make(Opcode::sdiv, high, n, m);
    case 0x20:
      return wide(Opcode::umull);
    case 0x3F:
      return make(Opcode::udiv, high, n, m);
    case 0x40:
      return wide(Opcode::smlal);
    case 0x60:
      return wide(Opcode::umlal);
    case 0x66:
      return wide(Opcode::umaal);
    default:
      break;
  }
  if (op1 == 4 && op2 >= 8 && op2 < 12) return media(Media::smlalxy, low, n, m, high, op2 & 3);
  if (op1 == 4 && (op2 & 0xE) == 0xC) return media(Media::smlald, low, n, m, high, op2 & 1);
  if (op1 == 5 && (op2 & 0xE) == 0xC) return media(Media::smlald, low, n, m, high, (op2 & 1) | 2);
  return {};
}

Op shifted_register(unsigned first, unsigned second) {
  const unsigned n = bits(first, 3, 0), d = bits(second, 11, 8), m = second & 0xF, type = bits(second, 5, 4),
                 amount = bits(second, 14, 12) << 2 | bits(second, 7, 6), code = bits(first, 8, 5);
  const bool sets = bits(first, 4, 4) != 0;
  if (code == 6) {  // PKHBT, PKHTB
    if (sets) return {};
    return shifted(media(Media::pkh, d, n, m, 0, bits(second, 5, 5)), type & 2, amount);
  }
  const Opcode kind = data_processing_kind(code, n, d, sets);
  if (kind == Opcode::undefined) return {};
  return shifted(with_flags(make(offset(kind, Op::kForms), d, n, m), sets ? Op::kAlways : Op::kNever), type, amount);
}

/// A5.3.
Op take_apart32(unsigned first, unsigned second) {
  if ((first & 0xEC00) == 0xEC00) {
    const unsigned coprocessor = bits(second, 11, 8);
    return (first & 0x1000) == 0 && (coprocessor & 0xE) == 10 ? take_apart_float(first, second) : Op{};
  }
  if ((first & 0xF800) == 0xF000) {
    if (bits(second, 15, 15) != 0) return branch_or_control(first, second);
    return bits(first, 9, 9) != 0 ? plain_immediate(first, second) : modified_immediate(first, second);
  }
  if ((first & 0xFE00) == 0xEA00) return shifted_register(first, second);
  if ((first & 0xFE40) == 0xE840) return dual_or_exclusive(first, second);
  if ((first & 0xFE40) == 0xE800) {
    const unsigned direction = bits(first, 8, 7);
    if (direction == 0 || direction == 3) return {};
    return with_mode(make(bits(first, 4, 4) != 0 ? Opcode::ldm : Opcode::stm, 0, bits(first, 3, 0), 0, second),
                     bits(first, 5, 5) | (direction == 2 ? 2U : 0U));
  }
  if ((first & 0xFE00) == 0xF800) return load_store32(first, second);
  if ((first & 0xFF00) == 0xFA00) return data_processing_register(first, second);
  if ((first & 0xFF80) == 0xFB00) return multiply(first, second);
  if ((first & 0xFF80) == 0xFB80) return long_multiply(first, second);
  return {};
}

/// To the form that sets the flags, or back.
Opcode other_form(Opcode kind, bool setting) {
  if (kind == Opcode::shift_by || kind == Opcode::shifts_by) return setting ? Opcode::shifts_by : Opcode::shift_by;
  if (kind == Opcode::mul || kind == Opcode::muls) return setting ? Opcode::muls : Opcode::mul;
  const Opcode from = setting ? Opcode::and_imm : Opcode::ands_imm, to = setting ? Opcode::ands_imm : Opcode::and_imm;
  const unsigned width = setting ? Op::kForms : Op::kSettingForms, target = setting ? Op::kSettingForms : Op::kForms;
  const unsigned n = static_cast<unsigned>(kind) - static_cast<unsigned>(from);
  return n < 3 * width && n % width < Op::kSettingForms ? offset(to, n / width * target + n % width) : kind;
}

/// What of it the interpreter need not find out at every run.
void settle(Op& o) {
  if (o.kind >= Opcode::and_reg && o.kind <= Opcode::cmn_reg && o.amount != 0) o.kind = offset(o.kind, Op::kForms);
  if (o.sets != Op::kNever) o.kind = other_form(o.kind, true);
  const bool word = o.kind == Opcode::ldr_imm || o.kind == Opcode::ldr_reg || o.kind == Opcode::ldr_lit ||
                    (o.kind == Opcode::indexed && o.a == 0);
  if (word && o.d == 15) o.info.flags |= InstructionInfo::kLoadsPc;
  if (o.kind == Opcode::ldm || o.kind == Opcode::stm) o.amount = static_cast<Byte>(4 * std::popcount(o.imm));
  const bool branch = (o.kind >= Opcode::b && o.kind <= Opcode::tbh) || o.kind == Opcode::mov_pc ||
                      o.kind == Opcode::add_pc || (o.kind == Opcode::ldm && (o.imm & 0x8000) != 0);
  if (branch) o.info.flags |= InstructionInfo::kJumps;
  if (o.kind == Opcode::vldr && o.amount == 1 && o.n != 15) o.kind = Opcode::vldr_word;
  if (o.kind == Opcode::vstr && o.amount == 1) o.kind = Opcode::vstr_word;
  if (o.kind == Opcode::it) o.info.flags |= InstructionInfo::kAlone;
}

}  // namespace

Operation take_apart(std::uint16_t first, std::uint16_t second) {
  Op o = first >= 0xE800 ? take_apart32(first, second) : take_apart16(first);
  o.info = decode(first, second);
  settle(o);
  return o;
}

Operation inside_it(Operation operation) {
  if (operation.sets == Op::kOutsideIt) operation.kind = other_form(operation.kind, false);
  operation.info.flags |= InstructionInfo::kAlone;
  return operation;
}

}  // namespace finemote::emulator
