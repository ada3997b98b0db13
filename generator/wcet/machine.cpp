#include "generator/wcet/machine.hpp"

#include <algorithm>
#include <utility>

namespace finemote::gen::wcet {
namespace {

/// Stays a distance from a base where that tells no less of the range.
Value joined(Value a, Value b) {
  const bool is_of_stack = a.is_of_stack || b.is_of_stack;
  if (a.is_place != b.is_place) return Value::in(Interval::any(), is_of_stack);
  const Value absolute{join(a.range(), b.range()), 0, {}, is_of_stack, a.is_place};
  if (a.base != b.base || a.base == 0) return absolute;
  const Value relative{join(a.distance, b.distance), a.base, join(a.base_range, b.base_range), is_of_stack, a.is_place};
  return absolute.distance.contains(relative.range()) ? relative : absolute;
}

/// What holds of all words holds of this one. A word alone on its base is only in a range, and as good as another of
/// that range; several words on one base are also so far from each other.
bool holds(Value all, Value one, BaseUses& uses) {
  if (all.is_place != one.is_place)
    return all.is_of_stack && !all.is_place && all.range() == Interval::any() && uses.is_alone(all.base);
  const bool is_as_far =
      all.base == one.base && all.distance.contains(one.distance) && all.base_range.contains(one.base_range);
  if (one.is_of_stack && !all.is_of_stack) return false;
  return is_as_far || (all.range().contains(one.range()) && uses.is_alone(all.base));
}

/// What is left where that does not hold: the range, if the other word lies in it.
Value widened(Value all, Value one) {
  const bool is_of_stack = all.is_of_stack || one.is_of_stack;
  const bool is_in_range = all.base != 0 && all.is_place == one.is_place && all.range().contains(one.range());
  return is_in_range ? Value{all.range(), 0, {}, is_of_stack, all.is_place} : Value::in(Interval::any(), is_of_stack);
}

void add_base(std::uint32_t base, std::vector<std::uint32_t>& bases) {
  if (base != 0) bases.push_back(base);
}

/// What is left of a register in `size` bytes.
Value cut_to(std::uint32_t size, Value value) {
  if (size >= 4) return value;
  const std::uint32_t mask = (1U << (8 * size)) - 1U;
  const Interval range = value.anywhere();
  if (range.high <= mask) return value;
  return Value::in(range.is_constant() ? Interval::of(range.low & mask) : Interval{0, mask}, value.is_of_stack);
}

void narrow_to(Value& value, std::uint32_t base, Interval range) {
  const auto both = value.base == base ? meet(value.base_range, range) : std::nullopt;
  if (both) value.base_range = *both;
}

}  // namespace

namespace {

/// A distance that may pass zero says nothing; what the word may be then still does.
Value unless_wrapped(Value relative, Interval range) {
  const Value absolute{range, 0, {}, relative.is_of_stack, relative.is_place};
  return relative.distance == Interval::any() ? absolute : relative;
}

constexpr Value kBlurred = Value::in(Interval::any(), true);

/// How many words are known at most before another one of this size is not: what is known is copied on every way. Parts
/// of words are rarely anything but the contents of arrays.
constexpr std::size_t most_words(std::uint32_t size) { return size < 4 ? 256 : 2048; }

/// The core-coupled RAM, where every stack lies.
constexpr Interval kStackMemory{0x1000'0000, 0x1000'FFFF};

}  // namespace

Interval Value::anywhere() const {
  if (!is_place) return range();
  return is_on_stack() ? Interval{kStackMemory.low, range().high} : Interval::any();
}

bool Value::is_on_stack() const { return is_place && kStackMemory.contains(range()); }

bool Value::may_be_on_stack() const { return is_place || (is_of_stack && meet(range(), kStackMemory).has_value()); }

/// Of two words of which only ranges are known the result stays a distance from the less known one.
Value sum(Value a, Value b) {
  if (a.is_of_stack && b.is_of_stack && (a.is_place || b.is_place)) return kBlurred;
  const bool is_of_stack = a.is_of_stack || b.is_of_stack, is_place = a.is_place || b.is_place;
  const auto width = [](Value v) { return v.base == 0 ? 0 : std::uint64_t{v.base_range.high} - v.base_range.low + 1; };
  if (width(a) < width(b)) std::swap(a, b);
  return unless_wrapped({add(a.distance, b.range()), a.base, a.base_range, is_of_stack, is_place},
                        add(a.range(), b.range()));
}

/// How far a place is from another one is the same wherever the stack is.
Value difference(Value a, Value b) {
  if (b.is_place && !a.is_place) return Value::in(subtract(a.range(), b.anywhere()), true);
  if (a.is_place && !b.is_place && b.is_of_stack) return kBlurred;
  const bool is_place = a.is_place && !b.is_place;
  const bool is_of_stack = a.is_place ? is_place : a.is_of_stack || b.is_of_stack;
  if (a.base == b.base) return {subtract(a.distance, b.distance), 0, {}, is_of_stack, is_place};
  return unless_wrapped({subtract(a.distance, b.range()), a.base, a.base_range, is_of_stack, is_place},
                        subtract(a.range(), b.range()));
}

bool StackWords::is_of_stack(std::uint32_t low, std::uint32_t high) const {
  return std::any_of(words_.begin(), words_.end(),
                     [&](const Word& w) { return w.value.is_of_stack && w.meets(low, high); });
}

/// What is left of an address of which a part goes is still a part of it.
void StackWords::forget(std::uint32_t low, std::uint32_t high) {
  const auto first =
      std::partition_point(words_.begin(), words_.end(), [&](const Word& word) { return word.last() < low; });
  const auto end = std::partition_point(first, words_.end(), [&](const Word& word) { return word.address <= high; });
  std::vector<Word> left;
  for (auto word = first; word != end; ++word) {
    for (std::uint32_t at = word->address; word->value.is_of_stack && at <= word->last(); ++at) {
      if (at < low || at > high) left.push_back({at, 1, Value::in({0, 0xFF}, true)});
    }
  }
  words_.insert(words_.erase(first, end), left.begin(), left.end());
}

void StackWords::join_address(const Word& word, const StackWords& other, std::vector<Word>& both) {
  if (!word.value.is_of_stack) return;
  const bool is_alone = std::none_of(other.words_.begin(), other.words_.end(),
                                     [&](const Word& w) { return w.meets(word.address, word.last()); });
  if (is_alone && word.size == 4) both.push_back({word.address, 4, kBlurred});
  has_forgotten_address_ |= !is_alone || word.size != 4;
}

const StackWords::Word* StackWords::find(std::uint32_t address, std::uint32_t size) const {
  const auto found = std::lower_bound(words_.begin(), words_.end(), address,
                                      [](const Word& w, std::uint32_t a) { return w.address < a; });
  return found != words_.end() && found->address == address && found->size == size ? &*found : nullptr;
}

void StackWords::store(const Access& access, Value value) {
  const Interval at = access.address.is_on_stack() ? access.address.range() : Interval::any();
  const std::uint32_t last = at.high > UINT32_MAX - access.size ? UINT32_MAX : at.high + access.size - 1;
  if (!at.is_constant()) has_forgotten_address_ |= value.is_of_stack || is_of_stack(at.low, last);
  forget(at.low, last);
  if (!at.is_constant() || (words_.size() >= most_words(access.size) && !value.is_of_stack)) return;
  const auto place = std::lower_bound(words_.begin(), words_.end(), at.low,
                                      [](const Word& w, std::uint32_t a) { return w.address < a; });
  words_.insert(place, {at.low, access.size, cut_to(access.size, value)});
}

Value StackWords::load(const Access& access) const {
  const Interval at = access.address.is_on_stack() ? access.address.range() : Interval::any();
  const Word* word = at.is_constant() ? find(at.low, access.size) : nullptr;
  if (word != nullptr) return word->value;
  const std::uint32_t last = at.high > UINT32_MAX - access.size ? UINT32_MAX : at.high + access.size - 1;
  const std::uint32_t highest = access.size < 4 ? (1U << (8 * access.size)) - 1U : UINT32_MAX;
  return Value::in({0, highest}, has_forgotten_address_ || is_of_stack(at.low, last));
}

void StackWords::join(const StackWords& other) {
  std::vector<Word> both;
  for (const Word& word : words_) {
    const Word* its = other.find(word.address, word.size);
    if (its != nullptr) both.push_back({word.address, word.size, joined(word.value, its->value)});
    if (its == nullptr) join_address(word, other, both);
  }
  for (const Word& word : other.words_) {
    if (find(word.address, word.size) == nullptr) join_address(word, *this, both);
  }
  std::sort(both.begin(), both.end(), [](const Word& a, const Word& b) { return a.address < b.address; });
  has_forgotten_address_ |= other.has_forgotten_address_;
  words_ = std::move(both);
}

void StackWords::widen(const StackWords& other, BaseUses& uses) {
  has_forgotten_address_ |= lacks_address_of(other);
  std::vector<Word> before = std::move(words_);
  words_.clear();
  for (Word& word : before) {
    const Word* its = other.find(word.address, word.size);
    const bool is_kept = its != nullptr && holds(word.value, its->value, uses);
    has_forgotten_address_ |= !is_kept && (word.value.is_of_stack || (its != nullptr && its->value.is_of_stack));
    if (is_kept) words_.push_back(word);
  }
  has_forgotten_address_ |= other.has_forgotten_address_;
}

/// An address in the stack at a place that this knows nothing of.
bool StackWords::lacks_address_of(const StackWords& other) const {
  return std::any_of(other.words_.begin(), other.words_.end(), [&](const Word& word) {
    return word.value.is_of_stack && find(word.address, word.size) == nullptr;
  });
}

bool StackWords::covers(const StackWords& other, BaseUses& uses) const {
  if (!has_forgotten_address_ && (other.has_forgotten_address_ || lacks_address_of(other))) return false;
  return std::all_of(words_.begin(), words_.end(), [&](const Word& word) {
    const Word* its = other.find(word.address, word.size);
    return its != nullptr && holds(word.value, its->value, uses);
  });
}

void StackWords::add_bases(std::vector<std::uint32_t>& bases) const {
  for (const Word& word : words_) add_base(word.value.base, bases);
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
  if (reg == ARM_REG_LR) is_link_kept_ = false;
  if (quotient_ && quotient_->has(reg)) quotient_.reset();
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
    value = {range, 0, {}, value.is_of_stack, value.is_place};  // better than a range of distances
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
    const bool is_place = value.is_place;
    if (value.base != 0 && value.range().is_constant()) value = Value::in(value.range(), value.is_of_stack);
    if (value.base == 0 && !value.distance.is_constant()) value = unknowns.next(value.distance, value.is_of_stack);
    value.is_place = is_place;
  }
}

void Machine::join(const Machine& other) {
  for (std::size_t i = 0; i < kRegisters; ++i) registers_[i] = joined(registers_[i], other.registers_[i]);
  if (!(flags_ == other.flags_)) flags_.reset();
  if (!(quotient_ == other.quotient_)) quotient_.reset();
  stack_.join(other.stack_);
  has_escaped_ |= other.has_escaped_;
  is_stack_in_fpu_ |= other.is_stack_in_fpu_;
  may_fail_exclusive_ |= other.may_fail_exclusive_;
  is_link_kept_ &= other.is_link_kept_;
}

std::vector<std::uint32_t> Machine::bases() const {
  std::vector<std::uint32_t> bases;
  for (const Value& value : registers_) add_base(value.base, bases);
  stack_.add_bases(bases);
  if (!flags_) return bases;
  for (const std::uint32_t base : {flags_->base, flags_->left_offset.base, flags_->right_offset.base})
    add_base(base, bases);
  return bases;
}

bool BaseUses::is_alone(std::uint32_t base) {
  if (base == 0) return true;
  if (bases_.empty()) {
    bases_ = machine_.bases();
    std::sort(bases_.begin(), bases_.end());
  }
  const auto [first, last] = std::equal_range(bases_.begin(), bases_.end(), base);
  return last - first <= 1;
}

void Machine::widen(const Machine& other) {
  flags_.reset();
  const Machine before = *this;
  BaseUses uses(before);
  for (std::size_t i = 0; i < kRegisters; ++i) {
    const Value its = other.registers_[i];
    if (!holds(registers_[i], its, uses)) registers_[i] = widened(registers_[i], its);
  }
  stack_.widen(other.stack_, uses);
  has_escaped_ |= other.has_escaped_;
  is_stack_in_fpu_ |= other.is_stack_in_fpu_;
  may_fail_exclusive_ |= other.may_fail_exclusive_;
  is_link_kept_ &= other.is_link_kept_;
}

bool Machine::covers(const Machine& other) const {
  if (flags_ && !(flags_ == other.flags_)) return false;
  BaseUses uses(*this);
  for (std::size_t i = 0; i < kRegisters; ++i) {
    if (!holds(registers_[i], other.registers_[i], uses)) return false;
  }
  return stack_.covers(other.stack_, uses) && (has_escaped_ || !other.has_escaped_) &&
         (is_stack_in_fpu_ || !other.is_stack_in_fpu_) && (may_fail_exclusive_ || !other.may_fail_exclusive_) &&
         (!is_link_kept_ || other.is_link_kept_);
}

}  // namespace finemote::gen::wcet
