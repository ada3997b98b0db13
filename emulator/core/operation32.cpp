// 32-bit Thumb instructions, taken apart: ARMv7-M Architecture Reference Manual A5.3.
#include "emulator/core/encoding.hpp"

namespace finemote::emulator {
namespace {

using namespace encoding;

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

}  // namespace

/// A5.3.
Operation take_apart32(unsigned first, unsigned second) {
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

}  // namespace finemote::emulator
