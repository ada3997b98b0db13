// A timer that counts up: prescaler, period and preloaded compare values become pulses, updates and compare events.
// RM0090 17 to 20. As an encoder's counter it stands until somebody turns it. Of input capture there is that of clocks
// inside the chip; other inputs, other slave modes, counting down and DMA are not modelled.
#pragma once

#include <array>
#include <functional>
#include <optional>

#include "emulator/chip/peripheral.hpp"

namespace finemote::emulator {

/// What tells one timer of the chip from another.
struct TimerKind {
  bool advanced = false;  ///< TIM1, TIM8: a main output enable
  bool wide = false;      ///< TIM2, TIM5: 32 bits
};

class Timer : public Peripheral {
 public:
  /// What it is told to do with its interrupt lines, only of changes: some timers share theirs.
  struct Lines {
    std::function<void(bool)> update, compare;
  };
  Timer(World& world, std::string name, TimerKind kind, std::function<std::uint32_t()> clock_hz, Lines lines)
      : Peripheral(world, std::move(name)), kind_(kind), clock_hz_(std::move(clock_hz)), lines_(std::move(lines)) {}

  std::uint32_t read(std::uint32_t offset) override;
  void write(std::uint32_t offset, std::uint32_t value) override;
  void reset() override;

  struct Pulse {
    std::uint64_t width_ns = 0;
    std::uint64_t period_ns = 0;  ///< 0: the output is off
  };
  /// A clock of the chip that the option register can lead to an input: RM0090 18.4.20, 19.5.11.
  struct InnerClock {
    unsigned channel;                   ///< 1 to 4
    std::uint32_t field, choice;        ///< bits of the option register, and their value that chooses it
    std::function<std::uint32_t()> hz;  ///< 0: it stands
  };
  void lead_in(InnerClock clock) { inner_clock_ = std::move(clock); }
  /// Turns the encoder it counts by `edges` edges; elsewhere nothing happens.
  void turn(int edges);
  /// What channel 1..4 puts out now.
  [[nodiscard]] Pulse pulse(unsigned channel) const;
  /// Told when the output of a channel changes, at the repetition from which it does.
  std::function<void(unsigned channel, Pulse)> on_pulse;
  /// Told of every compare value written, with the width of the pulses it asks for: with preload they begin later.
  std::function<void(unsigned channel, std::uint64_t width_ns, Tag origin)> on_compare;

 private:
  void update_event(Time at);
  void overflow(Time at);
  void schedule();
  void write_cr1(std::uint32_t value);
  void check(std::uint32_t offset, std::uint32_t value);
  void check_modes(unsigned first, std::uint32_t value);
  void update_line();
  void schedule_compare(unsigned index);
  /// The channel is an input, not an output: CCxS, RM0090 17.4.7.
  [[nodiscard]] bool is_input(unsigned index) const {
    return (registers_[kFirstMode + index / 2] >> (index % 2 * 8) & 3) != 0;
  }
  [[nodiscard]] Time capture_period() const;
  void follow_input();
  void capture_next(Time at, Time period);
  void capture(Time at);
  void match_compares();
  /// By its clock.
  [[nodiscard]] bool counts() const { return (registers_[0] & 1) != 0 && !is_encoder(); }
  [[nodiscard]] bool is_encoder() const;
  [[nodiscard]] std::uint32_t count() const;
  [[nodiscard]] Time count_time() const { return period_of(clock_hz_()) * (psc_active_ + 1); }
  void announce();
  [[nodiscard]] unsigned mode(unsigned index) const;
  [[nodiscard]] std::uint64_t width_ns(unsigned index, std::uint32_t compare, std::uint64_t top) const;

  static constexpr unsigned kFirstMode = 0x18 / 4;  ///< word of CCMR1

  TimerKind kind_;
  std::function<std::uint32_t()> clock_hz_;
  Lines lines_;
  bool update_line_ = false, compare_line_ = false;
  std::array<std::uint32_t, 21> registers_{};
  std::uint32_t psc_active_ = 0, arr_active_ = 0xFFFF;
  std::array<std::uint32_t, 4> ccr_active_{};
  std::array<std::uint64_t, 4> last_{};
  std::array<Time, 4> matched_{};  ///< compares before this were seen
  Time zero_ = 0;                  ///< when the counter was 0, while it counts
  std::uint32_t held_ = 0;         ///< the counter while it stands
  std::uint64_t token_ = 0;
  std::optional<InnerClock> inner_clock_;
  std::uint64_t input_token_ = 0;
};

}  // namespace finemote::emulator
