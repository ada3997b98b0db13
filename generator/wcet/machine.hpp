// What is known of the processor at a place in the code: registers, flags, and the words of the stack.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "generator/wcet/comparison.hpp"
#include "generator/wcet/interval.hpp"

namespace finemote::gen::wcet {

/// A word: a range of numbers, or of distances from a word of which a range is known. So a pointer to the end of an
/// array is known to be a fixed distance from its start, wherever that lies.
struct Value {
  Interval distance;       ///< from the base; without one the word itself
  std::uint32_t base = 0;  ///< tells words apart of which only a range is known; 0: none
  Interval base_range;     ///< of the base, where there is one
  /// Made of an address in the stack: something made of it may be one again. A pointer that was never made of the stack
  /// pointer leads to no variable there.
  bool is_of_stack = false;
  /// An address in the stack, as it would be if nothing had been preempted; the real one lies an unknown multiple of
  /// eight bytes below it (AAPCS 6.2.1.2, ARMv7-M B1.5.7 with STKALIGN).
  bool is_place = false;

  static constexpr Value of(std::uint32_t value) { return in(Interval::of(value)); }
  static constexpr Value place(std::uint32_t address) { return {Interval::of(address), 0, {}, true, true}; }
  static constexpr Value in(Interval range, bool is_of_stack = false) { return {range, 0, {}, is_of_stack, false}; }
  /// What the word may be; of a place where it is if nothing was preempted.
  [[nodiscard]] Interval range() const { return base == 0 ? distance : add(base_range, distance); }
  /// What the word may be, wherever the stack is.
  [[nodiscard]] Interval anywhere() const;
  /// As an address it leads to the stack and to nothing else.
  [[nodiscard]] bool is_on_stack() const;
  [[nodiscard]] bool may_be_on_stack() const;
};

Value sum(Value a, Value b);
Value difference(Value a, Value b);

/// Makes words of which only a range is known, each another.
class Unknowns {
 public:
  Value next(Interval range, bool is_of_stack) { return {Interval::of(0), ++last_, range, is_of_stack, false}; }

 private:
  std::uint32_t last_ = 0;
};

/// Of what one access of memory holds or changes.
struct Access {
  Value address;
  std::uint32_t size = 4;  ///< bytes: 1, 2 or 4
  std::uint32_t step = 1;  ///< it goes to a multiple of these bytes above the lowest address
};

class Machine;

/// Which bases several words of a machine rest on, counted when it is asked for.
class BaseUses {
 public:
  explicit BaseUses(const Machine& machine) : machine_(machine) {}
  /// One word rests on it, or it is none.
  [[nodiscard]] bool is_alone(std::uint32_t base);

 private:
  const Machine& machine_;
  std::vector<std::uint32_t> bases_;  // of every word that has one, in order
};

/// The bytes of the stack whose contents are known.
class StackWords {
 public:
  /// A store of `value`; an address that is not constant makes all it may reach unknown, one that may lead elsewhere
  /// everything.
  void store(const Access& access, Value value);
  /// What a load reads.
  [[nodiscard]] Value load(const Access& access) const;
  /// Keeps what both know.
  void join(const StackWords& other);
  /// Makes unknown what `other` has otherwise. `uses` are those of all that is known here, registers too.
  void widen(const StackWords& other, BaseUses& uses);
  [[nodiscard]] bool covers(const StackWords& other, BaseUses& uses) const;
  void add_bases(std::vector<std::uint32_t>& bases) const;
  /// The base of words lies in `range`.
  void narrow_base(std::uint32_t base, Interval range);
  /// Forgets what lies below the stack pointer.
  void drop_below(std::uint32_t address);

 private:
  struct Word {
    std::uint32_t address, size;
    Value value;
    [[nodiscard]] std::uint32_t last() const { return address + (size - 1); }
    [[nodiscard]] bool meets(std::uint32_t from, std::uint32_t to) const { return address <= to && last() >= from; }
  };
  [[nodiscard]] const Word* find(std::uint32_t address, std::uint32_t size) const;
  [[nodiscard]] bool is_of_stack(std::uint32_t low, std::uint32_t high) const;
  [[nodiscard]] bool lacks_address_of(const StackWords& other) const;
  void forget(std::uint32_t low, std::uint32_t high);
  /// An address in the stack that `other` knows nothing of.
  void join_address(const Word& word, const StackWords& other, std::vector<Word>& both);

  std::vector<Word> words_;             // by address; none overlaps another
  bool has_forgotten_address_ = false;  // of the stack: it may still be read somewhere
};

/// Which registers hold an unsigned quotient, and what it was made of.
struct Quotient {
  int result, dividend, divisor;

  [[nodiscard]] bool has(int reg) const { return reg == result || reg == dividend || reg == divisor; }
  friend bool operator==(const Quotient&, const Quotient&) = default;
};

/// Registers r0 to r12, sp and lr by their capstone names; others are not followed.
class Machine {
 public:
  [[nodiscard]] Value get(int reg) const;
  /// Forgets a comparison of the register's old value. What comes into the link register is taken for no address to
  /// return to.
  void set(int reg, Value value);
  [[nodiscard]] static bool follows(int reg);

  [[nodiscard]] const std::optional<Comparison>& flags() const { return flags_; }
  void set_flags(std::optional<Comparison> comparison) { flags_ = comparison; }
  /// Goes on where the condition holds. False where it never does.
  bool assume(arm_cc condition);

  /// Of the last division in the block whose registers have not been written since.
  [[nodiscard]] const std::optional<Quotient>& quotient() const { return quotient_; }
  void set_quotient(std::optional<Quotient> quotient) { quotient_ = quotient; }

  StackWords& stack() { return stack_; }
  [[nodiscard]] const StackWords& stack() const { return stack_; }
  /// An address in the stack was written to other memory: what is read from there may be one, and who preempts this
  /// may write to the stack by it at any time.
  [[nodiscard]] bool has_escaped() const { return has_escaped_; }
  void escape() { has_escaped_ = true; }
  /// A register of the FPU may hold an address in the stack, or a part of one.
  [[nodiscard]] bool is_stack_in_fpu() const { return is_stack_in_fpu_; }
  void put_stack_in_fpu() { is_stack_in_fpu_ = true; }
  /// The link register has what a call put there, or what was kept of that in the stack.
  [[nodiscard]] bool is_link_kept() const { return is_link_kept_; }
  void keep_link() { is_link_kept_ = true; }
  /// The last exclusive access may have been no load, so that an exclusive store may fail: ARMv7-M A3.4.1.
  [[nodiscard]] bool may_fail_exclusive() const { return may_fail_exclusive_; }
  void set_exclusive(bool may_fail) { may_fail_exclusive_ = may_fail; }

  /// Makes a base of every register of which only a range is known: what is made of it can be compared with it.
  void name_unknowns(Unknowns& unknowns);

  /// Becomes what holds for both.
  void join(const Machine& other);
  /// Forgets what `other` has otherwise: what changes from one iteration of a loop to the next.
  void widen(const Machine& other);
  /// Whatever holds here holds there: nothing new would come of going on from `other`.
  [[nodiscard]] bool covers(const Machine& other) const;
  /// The bases of all words, each as often as a word rests on it.
  [[nodiscard]] std::vector<std::uint32_t> bases() const;

 private:
  static constexpr std::size_t kRegisters = 15;
  [[nodiscard]] static std::optional<std::size_t> index(int reg);
  void narrow(int reg, std::uint32_t base, Interval range);
  /// Of every word that is so far from this base.
  void narrow_base(Comparison::Offset offset, Interval range);

  std::array<Value, kRegisters> registers_{};
  std::optional<Comparison> flags_;
  std::optional<Quotient> quotient_;
  StackWords stack_;
  bool has_escaped_ = false;
  bool is_stack_in_fpu_ = false;
  bool may_fail_exclusive_ = true;
  bool is_link_kept_ = false;
};

}  // namespace finemote::gen::wcet
