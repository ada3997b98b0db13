// Turns the pulse widths of sixteen channels into bursts over I2C to a PCA9685 PWM controller.
#pragma once

#include <cstddef>
#include <cstdint>

#include "finemote/i2c.hpp"
#include "finemote/pwm.hpp"
#include "finemote/single_core.hpp"
#include "finemote/time.hpp"

namespace finemote {

/// NXP PCA9685 (datasheet rev. 4): 16 channels of 12 bits, one common repetition frequency.
///
/// flush() never waits. It starts at most one transfer: the next step of the bring-up, or one auto-increment burst from
/// the first to the last changed channel, or nothing when nothing changed. Every `refresh` flushes it reads MODE1 back;
/// a part that was reset in flight (its power, not ours) is found asleep and brought up again, safe pulses first.
class Pca9685 : public PwmOutput {
 public:
  static constexpr std::uint8_t kChannels = 16;

  struct Config {
    std::int64_t frequency = 50;         ///< repetition frequency [Hz], 24..1526
    std::int64_t oscillator = 25000000;  ///< clock of the part [Hz]: 25 MHz inside, +-3 % from part to part
    std::int32_t refresh = 50;           ///< flushes between two read-backs, 1..65535
  };

  constexpr Pca9685(I2cSlot& slot, const Config& config)
      : PwmOutput(channel_, kChannels, static_cast<std::uint32_t>(1000000000LL / config.frequency), false),
        slot_(&slot),
        prescale_(prescale(config)),
        counts_per_ns_(counts_per_ns(config)),
        refresh_(static_cast<std::uint16_t>(config.refresh)) {}
  constexpr explicit Pca9685(I2cSlot& slot) : Pca9685(slot, Config{}) {}

  /// One step, see above. Called by several buckets it does the work once; a call that preempts another leaves its
  /// changes to it. Context: end of any bucket that drives it.
  void flush();

  /// True when the outputs follow set(): bring-up is over and the last transfer went well.
  [[nodiscard]] bool running() const { return step_ == Step::kRun && !unreachable(); }

  /// PRESCALE for a frequency: round(oscillator / (4096 * frequency)) - 1 (7.3.5), 3..255.
  static constexpr std::uint8_t prescale(const Config& config) {
    const std::int64_t steps = 4096 * config.frequency;
    const std::int64_t value = (config.oscillator + steps / 2) / steps - 1;
    return static_cast<std::uint8_t>(value < 3 ? 3 : value > 255 ? 255 : value);
  }
  /// Counter ticks per ns, as a fraction of 2^32: oscillator / (prescale + 1).
  static constexpr std::uint32_t counts_per_ns(const Config& config) {
    const std::int64_t ns = (prescale(config) + 1) * 1000000000LL;
    return static_cast<std::uint32_t>(((config.oscillator << 32) + ns / 2) / ns);
  }
  /// OFF count of a pulse [ns], rounded to nearest, at most 4095.
  [[nodiscard]] std::uint16_t counts(std::uint32_t pulse) const;

 private:
  /// Bring-up in this order; the first is the safe write, so that a part that outlived our reset goes safe at once.
  enum class Step : std::uint8_t {
    kSafe,
    kReadMode,
    kReadPrescale,
    kSleep,
    kPrescale,
    kWake,
    kOscillator,
    kRestart,
    kSafeAgain,
    kRun
  };
  static constexpr std::size_t kImage = 1 + 4 * kChannels;

  void work();
  void take_result();
  void take_step_result();
  void begin_step();
  void begin_run();
  void write_register(std::uint8_t address, std::uint8_t value);
  void read_register(std::uint8_t address);
  void build_safe();
  [[nodiscard]] std::size_t build_burst();
  void put(std::uint8_t* at, std::uint32_t pulse) const;
  [[nodiscard]] bool may_change_safe() const;
  void put_pulse(unsigned channel, std::uint32_t kept_ones, std::uint8_t* at);

  I2cSlot* slot_;
  std::uint8_t prescale_;
  std::uint32_t counts_per_ns_;
  std::uint16_t refresh_, since_check_ = 0;
  Step step_ = Step::kSafe;
  bool started_ = false;   ///< the step's transfer is under way, or has ended and was not looked at
  bool checking_ = false;  ///< the transfer under way reads MODE1 back
  std::uint8_t command_[2]{};
  std::uint8_t read_back_ = 0, mode_ = 0;
  std::uint32_t safe_writes_ = 0;  ///< of the slot, as last seen
  std::uint32_t in_burst_ = 0;     ///< channels of the burst under way
  Time awake_ = 0;
  Shared<std::uint32_t> used_{0};  ///< channels that were ever sent
  Shared<bool> busy_{false};       ///< a flush is being worked on
  std::uint8_t safe_size_ = 0;
  std::uint8_t safe_first_ = 0;  ///< channel of the safe image
  std::uint16_t kept_ = 0;       ///< channels of it that have no safe pulse
  std::uint8_t burst_[kImage]{};
  std::uint8_t safe_image_[kImage]{};
  Channel channel_[kChannels];
};

}  // namespace finemote
