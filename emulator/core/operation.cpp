#include "emulator/core/operation.hpp"

#include <bit>

#include "emulator/core/encoding.hpp"

namespace finemote::emulator {
namespace {

using namespace encoding;

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
