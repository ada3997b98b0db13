// Turns the halfwords of a Thumb instruction into what the interpreter runs: a kind and its operands, taken apart once.
#pragma once

#include <cstdint>

#include "emulator/core/instruction.hpp"

namespace finemote::emulator {

/// What an instruction does. Names are those of the ARMv7-M Architecture Reference Manual, A7.7.
enum class Opcode : std::uint8_t {
  undefined,
  marked,   // stands for another, which is marked: see Interpreter::mark
  unknown,  // of RAM, not taken apart since it was written
  // clang-format off
  // Data processing with an immediate, a register, a register shifted by a constant; then, in the same order, the forms
  // that set the flags of those that have a result.
  and_imm, bic_imm, orr_imm, orn_imm, eor_imm, mov_imm, mvn_imm, add_imm, adc_imm, sub_imm, sbc_imm, rsb_imm,
  tst_imm, teq_imm, cmp_imm, cmn_imm,
  and_reg, bic_reg, orr_reg, orn_reg, eor_reg, mov_reg, mvn_reg, add_reg, adc_reg, sub_reg, sbc_reg, rsb_reg,
  tst_reg, teq_reg, cmp_reg, cmn_reg,
  and_shifted, bic_shifted, orr_shifted, orn_shifted, eor_shifted, mov_shifted, mvn_shifted, add_shifted, adc_shifted,
  sub_shifted, sbc_shifted, rsb_shifted, tst_shifted, teq_shifted, cmp_shifted, cmn_shifted,
  ands_imm, bics_imm, orrs_imm, orns_imm, eors_imm, movs_imm, mvns_imm, adds_imm, adcs_imm, subs_imm, sbcs_imm,
  rsbs_imm,
  ands_reg, bics_reg, orrs_reg, orns_reg, eors_reg, movs_reg, mvns_reg, adds_reg, adcs_reg, subs_reg, sbcs_reg,
  rsbs_reg,
  ands_shifted, bics_shifted, orrs_shifted, orns_shifted, eors_shifted, movs_shifted, mvns_shifted, adds_shifted,
  adcs_shifted, subs_shifted, sbcs_shifted, rsbs_shifted,
  shift_by, shifts_by,             // register by register; `shift` says how
  mov_plain, add_plain,            // without flags and shift, low or high registers
  mov_pc, add_pc, movt, adr,       // adr: imm counts from the aligned PC
  // Branches; imm is the distance from the instruction plus 4.
  b, b_cond, bl, bx, blx, cbz, cbnz, tbb, tbh,
  // Memory: [n + imm], [n + (m << amount)], from the aligned PC, and with write-back before or after the access.
  ldr_imm, ldrb_imm, ldrh_imm, ldrsb_imm, ldrsh_imm, str_imm, strb_imm, strh_imm,
  ldr_reg, ldrb_reg, ldrh_reg, ldrsb_reg, ldrsh_reg, str_reg, strb_reg, strh_reg,
  ldr_lit, ldrb_lit, ldrh_lit, ldrsb_lit, ldrsh_lit,
  indexed,                         // `a`: which of ldr..strh, `mode`: 1 before, 2 after
  ldm, stm,                        // imm: list, amount: its bytes; mode bit 0: write back, bit 1: decrement before
  ldrd, strd,                      // mode bit 0: write back, bit 1: index first; literal: n = 15
  ldrex, strex, clrex,             // amount: 0 byte, 1 halfword, 2 word
  // Bits and bytes.
  ubfx, sbfx, bfi, clz, rbit, rev, rev16, revsh, extend, // extend: mode bits: see Extend
  ssat, usat,
  mul, muls, mla, mls, smull, umull, smlal, umlal, umaal, sdiv, udiv,
  media,                           // the DSP extension; `a`: Media
  // System.
  nop, dsb, it, wfi, cps, mrs, msr, svc, bkpt,
  // Floating point.
  vldr, vstr, vldm, vstm, vldr_word, vstr_word, vmov_to_core, vmov_from_core, vmov_pair, vmrs, vmsr,
  vmov_imm, vmov, vabs, vneg, vadd, vsub, vmul, vnmul, vdiv, vsqrt,
  vmla, vmls, vnmla, vnmls, vfma, vfms, vfnma, vfnms,
  vcmp, vcmp_zero, vcvt_to_int, vcvt_from_int, vcvt_fixed, vcvt_half,
  // clang-format on
};

/// In the order of Opcode, both ends included.
constexpr bool is_among(Opcode kind, Opcode first, Opcode last) { return kind >= first && kind <= last; }

/// Which of the five shifts of A7.4.
enum class Shift : std::uint8_t { lsl, lsr, asr, ror, rrx };

/// Sign and zero extension: `mode` holds these bits, `amount` the rotation, n = 15 adds nothing.
struct Extend {
  static constexpr std::uint8_t kUnsigned = 1, kByte = 2, kPair = 4;
};

/// Instructions of the DSP extension that share `Opcode::media`; imm is the register that is added, or a width.
enum class Media : std::uint8_t {
  parallel_add,  ///< eight sums and differences of bytes and halfwords: mode = first[6:4] << 4 | second[6:4]
  sel,
  pkh,     ///< mode 1: top from n
  qadd,    ///< mode: QADD QDADD QSUB QDSUB
  smlaxy,  ///< mode: halves; d = a + n * m
  smlaw,
  smlad,  ///< mode bit 0: exchanged, bit 1: difference
  smmla,  ///< mode bit 0: rounded, bit 1: difference
  smlalxy,
  smlald,
  usad8,
  ssat16,
  usat16,
};

/// One instruction, taken apart.
struct Operation {
  /// Flags are set never, outside an IT block (16-bit encodings), always.
  static constexpr std::uint8_t kNever = 0, kOutsideIt = 1, kAlways = 2;
  static constexpr unsigned kForms = 16, kSettingForms = 12;  ///< of data processing, by their last operand

  Opcode kind = Opcode::undefined;
  InstructionInfo info;
  std::uint8_t d = 0, n = 0, m = 0, a = 0;
  Shift shift = Shift::lsl;
  std::uint8_t amount = 0;  ///< of the shift, 0..32
  std::uint8_t sets = kNever;
  std::uint8_t mode = 0;
  std::uint32_t imm = 0;
};
static_assert(sizeof(Operation) == 16);

/// @param first, second  the halfwords at the instruction; second is ignored for a 16-bit one
Operation take_apart(std::uint16_t first, std::uint16_t second);

/// What it does inside an IT block.
Operation inside_it(Operation operation);

/// The parts of it by the length of an encoding; the operation's cost is left to `take_apart`.
Operation take_apart16(unsigned op);
Operation take_apart32(unsigned first, unsigned second);
/// The part of it for coprocessors 10 and 11.
Operation take_apart_float(unsigned first, unsigned second);

}  // namespace finemote::emulator
