// What the interpreter sees of memory: instructions taken apart before they run, in flash for the whole image, in RAM
// where it stands at 0 as they are reached.
#include <algorithm>
#include <cstring>

#include "emulator/core/interlock.hpp"
#include "emulator/core/interpreter.hpp"

namespace finemote::emulator {
namespace {

/// Halfwords before one that changes whose operations depend on it: an instruction of two, and one that waits for it.
constexpr std::uint32_t kBefore = 3;

}  // namespace

const Operation* Interpreter::take_apart_at(std::uint32_t address, Operation& into) const {
  const auto half = [this](std::uint32_t at, std::uint16_t& value) {
    const std::uint8_t* from = nullptr;
    const std::uint32_t place = physical(at);
    if (place - Memories::kFlashBase <= Memories::kFlashBytes - 2)
      from = memories_.flash + (place - Memories::kFlashBase);
    if (place - Memories::kRamBase <= Memories::kRamBytes - 2) from = memories_.ram + (place - Memories::kRamBase);
    if (from != nullptr) std::memcpy(&value, from, 2);
    return from != nullptr;
  };
  std::uint16_t halves[2] = {0, 0};
  if (!half(address, halves[0])) return nullptr;
  if (halves[0] >= 0xE800 && !half(address + 2, halves[1])) return nullptr;
  into = take_apart(halves[0], halves[1]);
  return &into;
}

void Interpreter::take_apart_flash(std::uint32_t bytes) {
  known_count_ = (bytes + 1) / 2;
  // The last two are what runs off the end: erased flash, or none.
  operations_.assign(known_count_ + 2, {});
  for (std::uint32_t n = known_count_; n < known_count_ + 2; ++n) operations_[n] = take_apart(0xFFFF, 0xFFFF);
  for (std::uint32_t n = known_count_; n-- > 0;) take_apart_known(n);
  known_ = operations_.data();
  see(view_);
}

/// After those that follow it: a wait is charged with the instruction before, as only from there is it known that the
/// two follow each other.
void Interpreter::take_apart_known(std::uint32_t n) {
  Operation& o = operations_[n];
  if (o.kind == Opcode::marked) return;
  take_apart_at(Memories::kFlashBase + 2 * n, o);
  o.info.cycles = static_cast<std::uint8_t>(o.info.cycles + interlock(o, operations_[n + o.info.bytes / 2U]));
}

void Interpreter::take_apart_again(std::uint32_t address, std::uint32_t bytes) {
  const std::uint32_t first = (address - Memories::kFlashBase) / 2, last = first + (bytes + 1) / 2;
  for (std::uint32_t n = last < known_count_ ? last : known_count_; n-- > (first > kBefore ? first - kBefore : 0);)
    take_apart_known(n);
}

/// Halfword `n` of RAM.
const Operation* Interpreter::take_apart_ram(std::uint32_t n) {
  const std::uint32_t address = Memories::kRamBase + 2 * n;
  Operation &o = ram_operations_[n], next;
  take_apart_at(address, o);
  if (take_apart_at(address + o.info.bytes, next) != nullptr)
    o.info.cycles = static_cast<std::uint8_t>(o.info.cycles + interlock(o, next));
  if (const auto found = marked_.find(address); found != marked_.end()) {
    found->second = o;
    found->second.info.flags |= InstructionInfo::kAlone;
    o.kind = Opcode::marked;
  }
  ram_code_ = std::max(ram_code_, 2 * (n + kBefore + 1));
  watched_ = std::max(protected_ram_, ram_code_);
  return &o;
}

/// They keep their lengths and costs: one of them may be the instruction that wrote.
void Interpreter::forget_ram(std::uint32_t address, std::uint32_t bytes) {
  const std::uint32_t offset = address - Memories::kRamBase;
  if (offset >= ram_code_) return;
  const std::uint32_t first = offset / 2, end = std::min((offset + bytes + 1) / 2, Memories::kMainRamBytes / 2);
  for (std::uint32_t n = first > kBefore ? first - kBefore : 0; n < end; ++n) ram_operations_[n].kind = Opcode::unknown;
}

void Interpreter::see(const MemoryView& view) {
  view_ = view;
  pace.ram_at_zero = view.ram_at_zero;
  if (view.ram_at_zero && ram_operations_.empty()) {
    Operation unknown;
    unknown.kind = Opcode::unknown;
    unknown.info.bytes = 2;
    ram_operations_.assign(Memories::kMainRamBytes / 2 + 2, unknown);
    for (auto behind = ram_operations_.end() - 2; behind != ram_operations_.end(); ++behind)
      *behind = take_apart(0xFFFF, 0xFFFF);
  }
  low_ = view.ram_at_zero ? ram_operations_.data() : operations_.data();
  low_bytes_ = view.ram_at_zero ? Memories::kMainRamBytes : Memories::kFlashBytes;
  low_count_ = !view.runs_zero ? 0 : view.ram_at_zero ? Memories::kMainRamBytes / 2 : known_count_;
  flash_count_ = view.runs_flash ? known_count_ : 0;
  protected_ram_ = view.protected_ram;
  watched_ = std::max(protected_ram_, ram_code_);
}

void Interpreter::mark(std::uint32_t address) {
  if (address - Memories::kRamBase < Memories::kMainRamBytes) {
    marked_[address] = {};
    return forget_ram(address, 2);
  }
  const std::uint32_t n = (address - Memories::kFlashBase) / 2;
  if (n >= known_count_ || operations_[n].kind == Opcode::marked) return;
  marked_[address] = operations_[n];
  operations_[n].kind = Opcode::marked;
  marked_[address].info.flags |= InstructionInfo::kAlone;
}

}  // namespace finemote::emulator
