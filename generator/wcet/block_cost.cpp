#include "generator/wcet/block_cost.hpp"

#include <algorithm>

#include "generator/wcet/operands.hpp"

namespace finemote::gen::wcet {
namespace {

constexpr std::uint32_t kLine = 16;          // bytes of flash that are read at once: RM0090 3.5
constexpr std::uint32_t kFetchedAhead = 12;  // bytes after the target of a jump that the core prefetches

std::uint32_t line_of(std::uint32_t address) { return address / kLine; }

/// Only these may be at any address: of all others the core makes a fault (ARMv7-M Architecture Reference Manual
/// A3.2.1).
bool may_be_unaligned(unsigned id) {
  switch (id) {
    case ARM_INS_LDR:
    case ARM_INS_STR:
    case ARM_INS_LDRH:
    case ARM_INS_LDRSH:
    case ARM_INS_STRH:
    case ARM_INS_LDRT:
    case ARM_INS_STRT:
    case ARM_INS_LDRHT:
    case ARM_INS_LDRSHT:
    case ARM_INS_STRHT:
      return true;
    default:
      return false;
  }
}

bool is_aligned(const Access& access) {
  const Interval address = access.address.range();
  const bool is_known = address.is_constant() || access.step % access.size == 0;
  return access.size == 1 || (is_known && address.low % access.size == 0);
}

}  // namespace

Cycles CodeCost::fetch(const Instruction& i) const {
  const bool is_wide_at_odd = i.size == 4 && i.address % 4 != 0;
  Cycles cycles = is_wide_at_odd ? table_->straddling : 0;
  if (placement_ == Placement::flash && line_of(i.address) != line_of(i.end() - 1)) cycles += table_->wait_states;
  return cycles;
}

std::optional<Cycles> CodeCost::run(const Instruction& i, const Machine& machine) const {
  const auto alone = longest_time(i, *table_);
  if (!alone) return std::nullopt;
  Cycles cycles = *alone + fetch(i);
  for (const Transferred& word : memory_use(i, machine).words) {
    const auto wait = longest_wait(word.access.address.anywhere(), placement_, table_->waits);
    if (!wait) return std::nullopt;
    cycles += std::max(*wait, may_be_unaligned(i.id) ? unaligned_wait(word.access) : Cycles{0});
  }
  if (i.id == ARM_INS_ISB) cycles += jump(i.end()) - table_->taken;  // what was fetched is fetched again
  if (i.id == ARM_INS_TBB || i.id == ARM_INS_TBH)
    cycles += longest_wait(Interval::of(i.end()), placement_, table_->waits).value_or(0);
  return cycles;
}

Cycles CodeCost::unaligned_wait(const Access& access) const {
  const auto where = is_aligned(access) ? std::nullopt : where_unaligned(access.address.anywhere());
  const auto wait = where ? longest_wait(*where, placement_, table_->waits) : std::nullopt;
  if (!wait) return 0;
  return *wait + (access.size == 4 ? table_->unaligned_word : table_->unaligned_half) * (1 + *wait);
}

Cycles CodeCost::skip(const Instruction& i) const { return table_->skipped + fetch(i); }

Cycles CodeCost::fall(const Instruction& from) const {
  if (placement_ == Placement::sram) return 0;
  // Of an instruction that straddles, the second line has been paid for.
  return line_of(from.end()) != line_of(from.end() - 1) ? table_->wait_states : 0;
}

Cycles CodeCost::jump(std::uint32_t target) const {
  if (placement_ == Placement::sram) return table_->taken;
  const bool asks_next_line = line_of(target) != line_of(target + kFetchedAhead);
  return table_->taken + table_->wait_states + table_->read_in_flight + (asks_next_line ? table_->read_in_flight : 0);
}

Cycles CodeCost::not_taken(const Instruction& branch, std::uint32_t target) const {
  const bool is_elsewhere = line_of(branch.address) != line_of(target);
  return placement_ == Placement::flash && is_elsewhere ? table_->read_in_flight : 0;
}

}  // namespace finemote::gen::wcet
