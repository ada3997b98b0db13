// Where the tags of each operation's operands go. What an operation does stands in the interpreter.
#include <bit>

#include "emulator/core/tag_flow.hpp"

namespace finemote::emulator {
namespace {

unsigned distance(Opcode first, Opcode kind) { return static_cast<unsigned>(kind) - static_cast<unsigned>(first); }

/// Data processing in the order of Opcode.
enum class Process : unsigned { kAnd, kBic, kOrr, kOrn, kEor, kMov, kMvn, kAdd };

/// Bytes of a mask with a bit in them keep their tags.
WordTags masked(WordTags tags, std::uint32_t mask) {
  for (unsigned i = 0; i < 4; ++i) {
    if ((mask >> (8 * i) & 0xFF) == 0) tags[i] = Tag::none;
  }
  return tags;
}

WordTags shifted_tags(const WordTags& tags, Shift how, unsigned amount) {
  if (amount == 0) return tags;
  const int by = static_cast<int>(std::min(amount, 32U));
  switch (how) {
    case Shift::lsl:
      return moved(tags, by);
    case Shift::lsr:
      return moved(tags, -by);
    case Shift::asr:
      return moved(tags, -by, tags[3]);
    case Shift::ror:
      return turned(tags, amount % 32);
    case Shift::rrx:
      break;
  }
  return moved(tags, -1);
}

/// Whether an IT block has an instruction for the other case too. @param state  as IT sets it: condition and mask
bool has_else(unsigned state) {
  const unsigned condition = state >> 4 & 1, count = 4 - static_cast<unsigned>(std::countr_zero(state & 0xF));
  for (unsigned i = 1; i < count; ++i) {
    if ((state >> (4 - i) & 1) != condition) return true;
  }
  return false;
}

}  // namespace

void TagFlow::follow_tags(const Operation& o, const Registers& registers, bool is_conditional, Time now) {
  if (o.kind == Opcode::it) in_choice_ = has_else(o.imm);
  may_leave_ = is_conditional && !in_choice_;
  now_ = now;
  if (is_among(o.kind, Opcode::and_imm, Opcode::rsbs_shifted)) return process(o);
  if (is_among(o.kind, Opcode::ldr_imm, Opcode::strex)) return memory(o, registers);
  if (is_among(o.kind, Opcode::ubfx, Opcode::extend) || is_among(o.kind, Opcode::shift_by, Opcode::adr))
    return move_bits(o, registers);
  if (is_among(o.kind, Opcode::ssat, Opcode::udiv)) return multiply(o);
  if (o.kind == Opcode::media) return media(o);
  if (is_among(o.kind, Opcode::vldr, Opcode::vstr_word)) return float_memory(o, registers);
  if (is_among(o.kind, Opcode::vmov_to_core, Opcode::vcvt_half)) return floating(o);
  if (o.kind == Opcode::bl || o.kind == Opcode::blx) return set(r_[14], {});
  if (o.kind == Opcode::mrs) set(r_[o.d], {});
}

// ------------------------------------------------------------------------------------------------ data processing

/// @param form  0 an immediate, 1 a register, 2 a register shifted by a constant
WordTags TagFlow::last_operand(const Operation& o, unsigned form) const {
  if (form == 0) return {};
  return form == 1 ? r_[o.m] : shifted_tags(r_[o.m], o.shift, o.amount);
}

void TagFlow::process(const Operation& o) {
  if (o.kind >= Opcode::ands_imm) {
    const unsigned which = distance(Opcode::ands_imm, o.kind);
    return process_form(o, which % Operation::kSettingForms, which / Operation::kSettingForms);
  }
  const unsigned which = distance(Opcode::and_imm, o.kind), what = which % Operation::kForms;
  if (what < Operation::kSettingForms) process_form(o, what, which / Operation::kForms);
}

void TagFlow::process_form(const Operation& o, unsigned what, unsigned form) {
  const WordTags last = last_operand(o, form);
  switch (static_cast<Process>(what)) {
    case Process::kMov:
    case Process::kMvn:
      return set(r_[o.d], last);
    case Process::kAnd:
      return set(r_[o.d], form == 0 ? masked(r_[o.n], o.imm) : newer(r_[o.n], last));
    case Process::kBic:
      return set(r_[o.d], form == 0 ? masked(r_[o.n], ~o.imm) : newer(r_[o.n], last));
    case Process::kOrr:
    case Process::kOrn:
    case Process::kEor:
      return set(r_[o.d], newer(r_[o.n], last));
    default:
      return set(r_[o.d], all_of(newest(newer(r_[o.n], last))));
  }
}

void TagFlow::move_bits(const Operation& o, const Registers& registers) {
  const WordTags m = r_[o.m];
  switch (o.kind) {
    case Opcode::shift_by:
    case Opcode::shifts_by:
      return set(r_[o.d], shifted_tags(r_[o.n], o.shift, registers.r[o.m] & 0xFF));
    case Opcode::mov_plain:
      return set(r_[o.d], m);
    case Opcode::add_plain:
      return set(r_[o.d], all_of(newest(newer(r_[o.n], m))));
    case Opcode::movt:
      return set(r_[o.d], masked(r_[o.d], 0xFFFF));
    case Opcode::adr:
      return set(r_[o.d], {});
    case Opcode::ubfx:
    case Opcode::sbfx: {
      const WordTags field = masked(moved(r_[o.n], -int{o.amount}), o.imm < 32 ? (1U << o.imm) - 1 : ~0U);
      const Tag top = field[(o.imm - 1) / 8 % 4];
      WordTags result = field;
      for (unsigned i = (o.imm + 7) / 8; o.kind == Opcode::sbfx && i < 4; ++i) result[i] = top;
      return set(r_[o.d], result);
    }
    case Opcode::bfi: {
      if (o.imm < o.amount) return;
      const std::uint32_t mask = ((2U << (o.imm - o.amount)) - 1) << o.amount;
      const WordTags field = o.n == 15 ? WordTags{} : masked(moved(r_[o.n], o.amount), mask);
      return set(r_[o.d], newer(masked(r_[o.d], ~mask), field));
    }
    case Opcode::rbit:
    case Opcode::rev:
      return set(r_[o.d], {m[3], m[2], m[1], m[0]});
    case Opcode::rev16:
      return set(r_[o.d], {m[1], m[0], m[3], m[2]});
    case Opcode::revsh:
      return set(r_[o.d], {m[1], m[0], m[0], m[0]});
    case Opcode::extend:
      return extend(o);
    case Opcode::clz:
      return set(r_[o.d], all_of(newest(m)));
    default:
      return;
  }
}

void TagFlow::extend(const Operation& o) {
  const WordTags m = turned(r_[o.m], o.amount);
  WordTags result{m[0], m[1], Tag::none, Tag::none};
  const bool is_signed = (o.mode & Extend::kUnsigned) == 0;
  if ((o.mode & Extend::kPair) != 0) {
    result = {m[0], is_signed ? m[0] : Tag::none, m[2], is_signed ? m[2] : Tag::none};
  } else {
    if ((o.mode & Extend::kByte) != 0) result[1] = is_signed ? m[0] : Tag::none;
    if (is_signed) result[2] = result[3] = result[1];
  }
  set(r_[o.d], o.n == 15 ? result : all_of(newest(newer(r_[o.n], result))));
}

// ---------------------------------------------------------------------------------------------------- arithmetic

void TagFlow::multiply(const Operation& o) {
  Tag result = newest(newer(r_[o.n], r_[o.m]));
  switch (o.kind) {
    case Opcode::ssat:
    case Opcode::usat:
      return set(r_[o.d], all_of(newest(r_[o.m])));
    case Opcode::mla:
    case Opcode::mls:
      return set(r_[o.d], all_of(newest(result, newest(r_[o.a]))));
    case Opcode::smlal:
    case Opcode::umlal:
    case Opcode::umaal:
      result = newest(result, newest(newer(r_[o.d], r_[o.a])));
      [[fallthrough]];
    case Opcode::smull:
    case Opcode::umull:
      set(r_[o.d], all_of(result));
      return set(r_[o.a], all_of(result));
    default:
      return set(r_[o.d], all_of(result));
  }
}

/// Multiplications keep the register they add in `imm`.
void TagFlow::media(const Operation& o) {
  Tag result = newest(newer(r_[o.n], r_[o.m]));
  switch (static_cast<Media>(o.a)) {
    case Media::pkh: {
      const WordTags second = shifted_tags(r_[o.m], o.shift, o.amount), &n = r_[o.n];
      return set(r_[o.d],
                 o.mode != 0 ? WordTags{second[0], second[1], n[2], n[3]} : WordTags{n[0], n[1], second[2], second[3]});
    }
    case Media::sel:
      return set(r_[o.d], newer(r_[o.n], r_[o.m]));
    case Media::ssat16:
    case Media::usat16:
      return set(r_[o.d], r_[o.n]);
    case Media::smlalxy:
    case Media::smlald:
      result = newest(result, newest(newer(r_[o.d], r_[o.imm])));
      set(r_[o.imm], all_of(result));
      break;
    case Media::smlaxy:
    case Media::smlaw:
    case Media::smlad:
    case Media::smmla:
    case Media::usad8:
      if (o.imm != 15) result = newest(result, newest(r_[o.imm]));
      break;
    case Media::parallel_add:
    case Media::qadd:
      break;
  }
  set(r_[o.d], all_of(result));
}

void TagFlow::floating(const Operation& o) {
  WordTags& d = s_[o.d & 31U];
  const WordTags n = s_[o.n & 31U], m = s_[o.m & 31U];
  switch (o.kind) {
    case Opcode::vmov_to_core:
      return set(r_[o.d], n);
    case Opcode::vmov_from_core:
      return set(d, r_[o.n]);
    case Opcode::vmov_pair:
      set(o.mode != 0 ? r_[o.d] : s_[o.m], o.mode != 0 ? m : r_[o.d]);
      return set(o.mode != 0 ? r_[o.n] : s_[o.m + 1U], o.mode != 0 ? s_[o.m + 1U] : r_[o.n]);
    case Opcode::vmrs:
      if (o.d != 15) set(r_[o.d], {});
      return;
    case Opcode::vmsr:
    case Opcode::vcmp:
    case Opcode::vcmp_zero:
      return;
    case Opcode::vmov_imm:
      return set(d, {});
    case Opcode::vmov:
    case Opcode::vabs:
    case Opcode::vneg:
      return set(d, m);
    case Opcode::vsqrt:
    case Opcode::vcvt_to_int:
    case Opcode::vcvt_from_int:
    case Opcode::vcvt_fixed:
    case Opcode::vcvt_half:  // to a half, the other one stays
      return set(d, all_of(newest(o.kind == Opcode::vcvt_half && (o.mode & 2) != 0 ? newer(d, m) : m)));
    default:
      return set(d, all_of(newest(newer(o.kind >= Opcode::vmla ? newer(d, n) : n, m))));
  }
}

// -------------------------------------------------------------------------------------------------------- memory

void TagFlow::memory(const Operation& o, const Registers& registers) {
  planned_ = crossed_ = 0;
  is_spill_ = o.n == 13;
  const auto& r = registers.r;
  if (is_among(o.kind, Opcode::ldr_imm, Opcode::strh_imm))
    return access(distance(Opcode::ldr_imm, o.kind), r[o.n] + o.imm, o.d);
  if (is_among(o.kind, Opcode::ldr_reg, Opcode::strh_reg))
    return access(distance(Opcode::ldr_reg, o.kind), r[o.n] + (r[o.m] << o.amount), o.d);
  if (is_among(o.kind, Opcode::ldr_lit, Opcode::ldrsh_lit)) return set(r_[o.d], {});
  if (o.kind == Opcode::ldm || o.kind == Opcode::stm) return multiple(o, registers);
  if (is_among(o.kind, Opcode::indexed, Opcode::strd)) return indexed(o, registers);
  exclusive(o, registers);
}

/// One register, or two, with write-back.
void TagFlow::indexed(const Operation& o, const Registers& registers) {
  const std::uint32_t base = registers.r[o.n], moved_base = base + o.imm;
  if (o.kind == Opcode::indexed) return access(o.a, o.mode == 1 ? moved_base : base, o.d);
  if (o.n == 15) {
    set(r_[o.d], {});
    return set(r_[o.a], {});
  }
  const std::uint32_t address = (o.mode & 2) != 0 ? moved_base : base;
  const unsigned which = o.kind == Opcode::ldrd ? 0 : 5;
  access(which, address, o.d);
  access(which, address + 4, o.a);
}

void TagFlow::multiple(const Operation& o, const Registers& registers) {
  std::uint32_t address = registers.r[o.n];
  if ((o.mode & 2) != 0) address -= o.amount;
  for (std::uint32_t list = o.imm & 0x7FFF; list != 0; list &= list - 1, address += 4)
    access(o.kind == Opcode::ldm ? 0 : 5, address, static_cast<unsigned>(std::countr_zero(list)));
}

void TagFlow::exclusive(const Operation& o, const Registers& registers) {
  const std::uint32_t address = registers.r[o.n] + o.imm;
  constexpr unsigned kLoads[] = {1, 2, 0}, kStores[] = {6, 7, 5};
  if (o.kind == Opcode::ldrex) return access(kLoads[o.amount], address, o.d);
  if (registers.exclusive) access(kStores[o.amount], address, o.m);
  set(r_[o.d], {});
}

void TagFlow::float_memory(const Operation& o, const Registers& registers) {
  planned_ = crossed_ = 0;
  is_spill_ = o.n == 13;
  const bool several = o.kind == Opcode::vldm || o.kind == Opcode::vstm, one = o.kind >= Opcode::vldr_word;
  const bool loads = o.kind == Opcode::vldr || o.kind == Opcode::vldm || o.kind == Opcode::vldr_word;
  const std::uint32_t base = o.n == 15 ? registers.r[15] & ~3U : registers.r[o.n];
  std::uint32_t address = several ? ((o.mode & 2) != 0 ? base - o.imm : base) : base + o.imm;
  for (unsigned i = 0; i < (one ? 1U : o.amount); ++i, address += 4) {
    WordTags& s = s_[o.d + i];
    loads ? load(address, {4, false}, s) : store(address, 4, s);
  }
}

}  // namespace finemote::emulator
