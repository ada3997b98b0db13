// The interrupt controller: which exceptions are pending, enabled and active, and which one comes next.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <functional>
#include <utility>

namespace finemote::emulator {

/// Exception numbers 0..97: 16 of the core, then 82 lines of the STM32F407 (RM0090 12.1.1, table 62).
inline constexpr int kExceptions = 16 + 82;

enum Exception : int {
  kReset = 1,
  kNmi = 2,
  kHardFault = 3,
  kMemManage = 4,
  kBusFault = 5,
  kUsageFault = 6,
  kSvCall = 11,
  kPendSv = 14,
  kSysTick = 15
};

/// ARMv7-M Architecture Reference Manual B1.5 and B3.4; PM0214 4.3. Four priority bits.
class Nvic {
 public:
  void reset() {
    auto told = std::move(on_due);
    *this = Nvic{};
    on_due = std::move(told);
  }
  /// Told of an exception when it begins to be pending.
  std::function<void(int exception)> on_due;

  /// A peripheral's line changes its level. A rise pends; a level still high when its routine returns pends again.
  void set_line(int line, bool high);
  void pend(int exception);
  void unpend(int exception);
  void enable(int exception, bool on);
  void set_priority(int exception, std::uint8_t register_value) {
    priority_[index(exception)] = register_value & 0xF0;
    active_priority_ = lowest_active();
    changed_ = true;
  }

  /// AIRCR.PRIGROUP: the bits up to this one order what is pending, but let nothing interrupt: PM0214 4.4.5.
  void set_grouping(unsigned last_bit) {
    group_mask_ = 0xFEU << last_bit & 0xFF;
    active_priority_ = lowest_active();
    changed_ = true;
  }
  /// What of a priority, or of BASEPRI, decides who interrupts whom.
  [[nodiscard]] int group_of(std::uint32_t priority) const { return static_cast<int>(priority & group_mask_); }

  [[nodiscard]] bool is_pending(int exception) const { return pending_.has(exception); }
  [[nodiscard]] bool is_enabled(int exception) const { return enabled_.has(exception); }
  [[nodiscard]] bool is_active(int exception) const { return active_.has(exception); }
  [[nodiscard]] int count_active() const { return std::popcount(active_.words[0]) + std::popcount(active_.words[1]); }
  /// The peripheral holds its line up.
  [[nodiscard]] bool is_high(int line) const { return level_.has(16 + line); }
  [[nodiscard]] std::uint8_t priority_register(int exception) const { return priority_[index(exception)]; }

  /// Effective priority, its group alone; smaller is more urgent; -3..-1 are reset, NMI and hard fault.
  [[nodiscard]] int priority(int exception) const;
  /// Of what runs now; 256 in thread mode. Masking registers not included.
  [[nodiscard]] int active_priority() const { return active_priority_; }
  /// The most urgent pending and enabled exception; 0 when there is none. Equal priorities, of equal sub-priority: the
  /// lowest number.
  [[nodiscard]] int most_urgent() const;

  void enter(int exception);
  void leave(int exception);

  /// True once after something that may let an exception in.
  [[nodiscard]] bool take_change() {
    const bool changed = changed_;
    changed_ = false;
    return changed;
  }
  /// The line whose level fell last, -1 when none did since the last call.
  [[nodiscard]] int take_lowered() {
    const int line = lowered_;
    lowered_ = -1;
    return line;
  }
  [[nodiscard]] bool changed() const { return changed_; }
  [[nodiscard]] unsigned times_entered(int exception) const { return entered_[index(exception)]; }

 private:
  static std::size_t index(int exception) { return static_cast<std::size_t>(exception); }

  template <class T>
  using Table = std::array<T, kExceptions>;
  /// A set of exceptions, looked through from the lowest number.
  struct Set {
    std::array<std::uint64_t, 2> words{};
    [[nodiscard]] bool has(int exception) const { return (words[index(exception) / 64] >> (exception % 64) & 1) != 0; }
    void put(int exception, bool in) {
      const std::uint64_t bit = std::uint64_t{1} << (exception % 64);
      std::uint64_t& word = words[index(exception) / 64];
      word = in ? word | bit : word & ~bit;
    }
  };
  [[nodiscard]] int lowest_active() const;
  [[nodiscard]] int whole_priority(int exception) const {
    return exception <= kHardFault ? exception - 4 : priority_[index(exception)];
  }

  Set pending_, enabled_, active_, level_;
  Table<std::uint8_t> priority_{};
  Table<unsigned> entered_{};
  std::uint32_t group_mask_ = 0xFE;
  int active_priority_ = 256;
  int lowered_ = -1;
  bool changed_ = false;
};

}  // namespace finemote::emulator
