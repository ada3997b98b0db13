// A timer as a PWM generator: prescaler, period and preloaded compare values become pulses. RM0090 17, 18, 19.
#pragma once

#include <array>
#include <functional>

#include "emulator/chip/peripheral.hpp"

namespace finemote::emulator {

class Timer : public Peripheral {
 public:
  Timer(World& world, std::string name, bool advanced, std::function<std::uint32_t()> clock_hz, int update_line)
      : Peripheral(world, std::move(name)),
        advanced_(advanced),
        clock_hz_(std::move(clock_hz)),
        update_line_(update_line) {}

  std::uint32_t read(std::uint32_t offset) override;
  void write(std::uint32_t offset, std::uint32_t value) override;
  void reset() override;

  struct Pulse {
    std::uint64_t width_ns = 0;
    std::uint64_t period_ns = 0;  ///< 0: the output is off
  };
  /// What channel 1..4 puts out now.
  [[nodiscard]] Pulse pulse(unsigned channel) const;
  /// Told when the output of a channel changes, at the repetition from which it does.
  std::function<void(unsigned channel, Pulse)> on_pulse;

 private:
  void update_event();
  void schedule();
  [[nodiscard]] Time count_time() const { return period_of(clock_hz_()) * (psc_active_ + 1); }
  void announce();

  bool advanced_;
  std::function<std::uint32_t()> clock_hz_;
  int update_line_;
  std::array<std::uint32_t, 21> registers_{};
  std::uint32_t psc_active_ = 0, arr_active_ = 0xFFFF;
  std::array<std::uint32_t, 4> ccr_active_{};
  std::array<std::uint64_t, 4> last_{};
  Time zero_ = 0;
  std::uint64_t token_ = 0;
};

}  // namespace finemote::emulator
