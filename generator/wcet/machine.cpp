#include "generator/wcet/machine.hpp"

#include <algorithm>
#include <utility>

namespace finemote::gen::wcet {
namespace {

/// Stays a distance from a base where that tells no less of the range.
Value joined(Value a, Value b) {
  const bool is_of_stack = a.is_of_stack || b.is_of_stack;
  const Value absolute = Value::in(join(a.range(), b.range()), is_of_stack);
  if (a.base != b.base || a.base == 0) return absolute;
  const Value relative{join(a.distance, b.distance), a.base, join(a.base_range, b.base_range), is_of_stack};
  return absolute.distance.contains(relative.range()) ? relative : absolute;
}

/// A word of which a range is known is as good as another.
bool holds(Value all, Value one) {
  const bool is_in_range =
      all.base == one.base ? all.distance.contains(one.distance) : all.range().contains(one.range());
  return is_in_range && (all.is_of_stack || !one.is_of_stack);
}

/// What is left of a register in so many bytes.
Value cut_to(std::uint32_t size, Value value) {
  if (size >= 4) return value;
  const std::uint32_t mask = (1U << (8 * size)) - 1U;
  const Interval range = value.range();
  if (range.high <= mask) return value;
  return Value::in(range.is_constant() ? Interval::of(range.low & mask) : Interval{0, mask});
}

void narrow_to(Value& value, std::uint32_t base, Interval range) {
  const auto both = value.base == base ? meet(value.base_range, range) : std::nullopt;
  if (both) value.base_range = *both;
}

}  // namespace

namespace {

/// A distance that may pass zero says nothing; what the word may be then still does.
Value unless_wrapped(Value relative, Interval range) {
  return relative.distance == Interval::any() ? Value::in(range, relative.is_of_stack) : relative;
}

}  // namespace

/// Of two words of which only ranges are known the result stays a distance from the less known one.
Value sum(Value a, Value b) {
  const bool is_of_stack = a.is_of_stack || b.is_of_stack;
  const auto width = [](Value v) { return v.base == 0 ? 0 : std::uint64_t{v.base_range.high} - v.base_range.low + 1; };
  if (width(a) < width(b)) std::swap(a, b);
  return unless_wrapped({add(a.distance, b.range()), a.base, a.base_range, is_of_stack}, add(a.range(), b.range()));
}

Value difference(Value a, Value b) {
  const bool is_of_stack = a.is_of_stack || b.is_of_stack;
  if (a.base == b.base) return Value::in(subtract(a.distance, b.distance), is_of_stack);
  return unless_wrapped({subtract(a.distance, b.range()), a.base, a.base_range, is_of_stack},
                        subtract(a.range(), b.range()));
}

bool StackWords::is_of_stack(std::uint32_t low, std::uint32_t high) const {
  return std::any_of(words_.begin(), words_.end(), [&](const Word& w) {
    return w.value.is_of_stack && w.address <= high && w.address + (w.size - 1) >= low;
  });
}

void StackWords::forget(std::uint32_t low, std::uint32_t high) {
  const auto overlaps = [&](const Word& w) { return w.address <= high && w.address + (w.size - 1) >= low; };
  words_.erase(std::remove_if(words_.begin(), words_.end(), overlaps), words_.end());
}

const StackWords::Word* StackWords::find(std::uint32_t address, std::uint32_t size) const {
  const auto found = std::lower_bound(words_.begin(), words_.end(), address,
                                      [](const Word& w, std::uint32_t a) { return w.address < a; });
  return found != words_.end() && found->address == address && found->size == size ? &*found : nullptr;
}

void StackWords::store(const Access& access, Value value) {
  const Interval at = access.address.range();
  const std::uint32_t last = at.high > UINT32_MAX - access.size ? UINT32_MAX : at.high + access.size - 1;
  if (!at.is_constant()) has_forgotten_address_ |= value.is_of_stack || is_of_stack(at.low, last);
  forget(at.low, last);
  if (!at.is_constant()) return;
  const auto place = std::lower_bound(words_.begin(), words_.end(), at.low,
                                      [](const Word& w, std::uint32_t a) { return w.address < a; });
  words_.insert(place, {at.low, access.size, cut_to(access.size, value)});
}

Value StackWords::load(const Access& access) const {
  const Interval at = access.address.range();
  const Word* word = at.is_constant() ? find(at.low, access.size) : nullptr;
  if (word != nullptr) return word->value;
  if (access.size < 4) return Value::in({0, (1U << (8 * access.size)) - 1U});
  const std::uint32_t last = at.high > UINT32_MAX - access.size ? UINT32_MAX : at.high + access.size - 1;
  return Value::in(Interval::any(), has_forgotten_address_ || is_of_stack(at.low, last));
}

void StackWords::join(const StackWords& other) {
  std::vector<Word> both;
  for (const Word& word : words_) {
    const Word* its = other.find(word.address, word.size);
    if (its != nullptr) both.push_back({word.address, word.size, joined(word.value, its->value)});
    has_forgotten_address_ |= its == nullptr && word.value.is_of_stack;
  }
  for (const Word& word : other.words_)
    has_forgotten_address_ |= word.value.is_of_stack && find(word.address, word.size) == nullptr;
  has_forgotten_address_ |= other.has_forgotten_address_;
  words_ = std::move(both);
}

void StackWords::widen(const StackWords& other) {
  std::vector<Word> before = std::move(words_);
  words_.clear();
  for (Word& word : before) {
    const Word* its = other.find(word.address, word.size);
    const bool is_kept = its != nullptr && holds(word.value, its->value);
    has_forgotten_address_ |= !is_kept && (word.value.is_of_stack || (its != nullptr && its->value.is_of_stack));
    if (is_kept) words_.push_back(word);
  }
  has_forgotten_address_ |= other.has_forgotten_address_;
}

bool StackWords::covers(const StackWords& other) const {
  if (other.has_forgotten_address_ && !has_forgotten_address_) return false;
  return std::all_of(words_.begin(), words_.end(), [&](const Word& word) {
    const Word* its = other.find(word.address, word.size);
    return its != nullptr && holds(word.value, its->value);
  });
}

void StackWords::narrow_base(std::uint32_t base, Interval range) {
  for (Word& word : words_) narrow_to(word.value, base, range);
}

void StackWords::drop_below(std::uint32_t address) {
  if (address > 0) forget(0, address - 1);
}

std::optional<std::size_t> Machine::index(int reg) {
  if (reg >= ARM_REG_R0 && reg <= ARM_REG_R12) return static_cast<std::size_t>(reg - ARM_REG_R0);
  if (reg == ARM_REG_SP) return 13;
  if (reg == ARM_REG_LR) return 14;
  return std::nullopt;
}

bool Machine::follows(int reg) { return index(reg).has_value(); }

Value Machine::get(int reg) const {
  const auto i = index(reg);
  return i ? registers_[*i] : Value::in(Interval::any(), true);
}

void Machine::set(int reg, Value value) {
  const auto i = index(reg);
  if (!i) return;
  registers_[*i] = value;
  if (!flags_) return;
  if (flags_->left == reg) flags_->left = ARM_REG_INVALID;
  if (flags_->right == reg) flags_->right = ARM_REG_INVALID;
  if (flags_->result == reg) flags_->result = ARM_REG_INVALID;
}

void Machine::narrow(int reg, std::uint32_t base, Interval range) {
  const auto i = index(reg);
  if (!i) return;
  Value& value = registers_[*i];
  if (value.base == base) {
    value.distance = range;
  } else if (base == 0 && value.distance.is_constant()) {
    narrow_base({value.base, value.distance.low}, range);
  } else if (base == 0 && !(range == value.range())) {
    value = Value::in(range, value.is_of_stack);  // better than a range of distances
  }
}

void Machine::narrow_base(Comparison::Offset offset, Interval range) {
  const Interval base_range = subtract(range, Interval::of(offset.distance));
  for (Value& value : registers_) narrow_to(value, offset.base, base_range);
  stack_.narrow_base(offset.base, base_range);
}

bool Machine::assume(arm_cc condition) {
  if (!flags_ || condition == ARM_CC_AL || condition == ARM_CC_INVALID) return true;
  const auto sides = where(*flags_, condition);
  const auto difference = difference_where(*flags_, condition);
  if (!sides || !difference) return false;
  flags_->left_range = sides->first;
  flags_->right_range = sides->second;
  if (flags_->left_offset.base != 0) narrow_base(flags_->left_offset, sides->first);
  if (flags_->right_offset.base != 0) narrow_base(flags_->right_offset, sides->second);
  narrow(flags_->left, flags_->base, sides->first);
  narrow(flags_->right, flags_->base, sides->second);
  const auto both = meet(*difference, subtract(sides->first, sides->second));
  if (!both) return false;
  narrow(flags_->result, 0, *both);
  return true;
}

void Machine::name_unknowns(Unknowns& unknowns) {
  for (Value& value : registers_) {
    if (value.base != 0 && value.range().is_constant()) value = Value::in(value.range(), value.is_of_stack);
    if (value.base == 0 && !value.distance.is_constant()) value = unknowns.next(value.distance, value.is_of_stack);
  }
}

void Machine::join(const Machine& other) {
  for (std::size_t i = 0; i < kRegisters; ++i) registers_[i] = joined(registers_[i], other.registers_[i]);
  if (!(flags_ == other.flags_)) flags_.reset();
  stack_.join(other.stack_);
  has_escaped_ |= other.has_escaped_;
}

void Machine::widen(const Machine& other) {
  for (std::size_t i = 0; i < kRegisters; ++i) {
    const Value its = other.registers_[i];
    if (!holds(registers_[i], its))
      registers_[i] = Value::in(Interval::any(), registers_[i].is_of_stack || its.is_of_stack);
  }
  flags_.reset();
  stack_.widen(other.stack_);
  has_escaped_ |= other.has_escaped_;
}

bool Machine::covers(const Machine& other) const {
  for (std::size_t i = 0; i < kRegisters; ++i) {
    if (!holds(registers_[i], other.registers_[i])) return false;
  }
  return stack_.covers(other.stack_) && (has_escaped_ || !other.has_escaped_);
}

}  // namespace finemote::gen::wcet
