#include "emulator/core/interlock.hpp"

namespace finemote::emulator {
namespace {

bool only_compares(Opcode kind) {
  return is_among(kind, Opcode::tst_imm, Opcode::cmn_imm) || is_among(kind, Opcode::tst_reg, Opcode::cmn_reg) ||
         is_among(kind, Opcode::tst_shifted, Opcode::cmn_shifted);
}

/// Whether data processing of `o` writes core register `number`.
bool computes(const Operation& o, unsigned number) {
  if (is_among(o.kind, Opcode::smull, Opcode::umaal)) return o.d == number || o.a == number;
  const bool has_result = (is_among(o.kind, Opcode::and_imm, Opcode::adr) && !only_compares(o.kind) &&
                           o.kind != Opcode::mov_pc && o.kind != Opcode::add_pc) ||
                          is_among(o.kind, Opcode::ubfx, Opcode::media);
  return has_result && o.d == number;
}

bool is_float_load_or_store(Opcode kind) { return is_among(kind, Opcode::vldr, Opcode::vstr_word); }

bool takes_index(Opcode kind) {
  return is_among(kind, Opcode::ldr_reg, Opcode::strh_reg) || kind == Opcode::tbb || kind == Opcode::tbh;
}

/// Whether core register `number` is part of an address that `o` accesses.
bool addresses_by(const Operation& o, unsigned number) {
  if (takes_index(o.kind)) return o.n == number || o.m == number;
  const bool accesses = is_among(o.kind, Opcode::ldr_imm, Opcode::strh_imm) || o.kind == Opcode::indexed ||
                        is_among(o.kind, Opcode::ldm, Opcode::strex) || is_float_load_or_store(o.kind);
  return accesses && o.n == number;
}

/// Whether `o` makes a value in a floating-point register by arithmetic.
bool is_float_arithmetic(Opcode kind) {
  return is_among(kind, Opcode::vabs, Opcode::vfnms) || is_among(kind, Opcode::vcvt_to_int, Opcode::vcvt_half);
}

/// Whether `o` needs single register `number` as it begins. The addend of a multiplication is needed later.
bool needs(const Operation& o, unsigned number) {
  if (o.kind == Opcode::vstr_word) return o.d == number;
  if (o.kind == Opcode::vstr || o.kind == Opcode::vstm) return number - o.d < o.amount;
  if (o.kind == Opcode::vmov_to_core) return o.n == number;
  if (o.kind == Opcode::vmov_pair) return o.mode != 0 && number - o.m < 2;
  if (o.kind == Opcode::vcmp) return o.d == number || o.m == number;
  if (o.kind == Opcode::vcmp_zero) return o.d == number;
  const bool takes_two = is_among(o.kind, Opcode::vadd, Opcode::vdiv) || is_among(o.kind, Opcode::vmla, Opcode::vfnms);
  if (takes_two) return o.n == number || o.m == number;
  return (is_float_arithmetic(o.kind) || o.kind == Opcode::vmov) && o.m == number;
}

bool waits_for_address(const Operation& first, const Operation& second) {
  for (unsigned number = 0; number < 15; ++number) {
    if (addresses_by(second, number) && computes(first, number)) return true;
  }
  return false;
}

}  // namespace

unsigned interlock(const Operation& first, const Operation& second) {
  if (is_float_arithmetic(first.kind) && needs(second, first.d)) return 1;
  const bool compared = first.kind == Opcode::vcmp || first.kind == Opcode::vcmp_zero;
  if (compared && second.kind == Opcode::vmrs) return 1;
  return waits_for_address(first, second) ? 1 : 0;
}

}  // namespace finemote::emulator
