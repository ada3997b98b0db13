// Turns pulse widths set by several devices into one write per output part: set() marks, flush() sends.
#pragma once

#include <cstddef>
#include <cstdint>

#include "finemote/ports.hpp"
#include "finemote/single_core.hpp"
#include "finemote/time.hpp"

namespace finemote {

/// A part with up to 32 pulse outputs: what PwmBus and Pca9685 have in common.
///
/// Devices of different buckets share it: set() is atomic against preemption. flush(), in the derived classes, is what
/// the generated schedule calls once at the end of every bucket that drives it.
class PwmOutput {
 public:
  /// Wanted pulse width [ns] of a channel, 0 = no pulse; sent by the next flush() if it is the first one or differs
  /// from the last one: a part that outlived our reset may show any. A channel the part does not have is ignored.
  /// Context: any bucket.
  void set(std::uint8_t channel, std::uint32_t pulse);

  /// Pulse width [ns] that is safe on this channel (an ESC's neutral): sent first after start and after any bus
  /// recovery. Context: any bucket.
  void set_safe(std::uint8_t channel, std::uint32_t pulse);

  /// True when the part cannot be reached over its bus: what set() asks for does not arrive. Context: any.
  [[nodiscard]] bool unreachable() const { return unreachable_.load(); }

  /// How often pulses repeat [ns]. Context: any.
  [[nodiscard]] std::uint32_t period() const { return period_.load(); }

  /// Another repetition period [ns], from the next flush() on. A part whose channels share their period ignores it.
  /// Context: any bucket.
  void tune(std::uint32_t period) {
    if (tunable_ && period_.exchange(period) != period) tuned_.store(true);
  }

  [[nodiscard]] std::uint8_t channels() const { return count_; }  ///< channels the part has

 protected:
  struct Channel {
    Shared<std::uint32_t> pulse{0};
    Shared<std::uint32_t> safe{0};
  };

  constexpr PwmOutput(Channel* channels, std::uint8_t count, std::uint32_t period, bool tunable)
      : channels_(channels), count_(count), tunable_(tunable), period_(period) {}

  Channel* const channels_;
  const std::uint8_t count_;
  const bool tunable_;
  Shared<std::uint32_t> period_;  ///< ns
  Shared<bool> tuned_{false};     ///< period_ differs from what was sent
  Shared<bool> unreachable_{false};
  Shared<std::uint32_t> asked_{0};       ///< bit n: channel n was set; before, the part may show anything
  Shared<std::uint32_t> changed_{0};     ///< bit n: channel n differs from what was sent
  Shared<std::uint32_t> safe_known_{0};  ///< bit n: channel n has a safe pulse
  Shared<bool> safe_changed_{false};
};

/// One channel of a PwmOutput, as a device holds it.
class PwmChannel {
 public:
  /// Channel `channel` of the part, from 0.
  constexpr PwmChannel(PwmOutput& output, std::uint8_t channel) : output_(&output), channel_(channel) {}

  /// As PwmOutput::set(). Context: the device's bucket.
  void set(std::uint32_t pulse) { output_->set(channel_, pulse); }
  /// As PwmOutput::set_safe(). Context: the device's bucket.
  void set_safe(std::uint32_t pulse) { output_->set_safe(channel_, pulse); }
  /// A pulse that is this share of the period, cut to 0..1; no number is 0. Context: the device's bucket.
  void set_share(float share);
  /// Another repetition period [ns], where the output is alone on its timer. Context: the device's bucket.
  void tune(std::uint32_t period) { output_->tune(period); }
  /// How often pulses repeat [ns]. Context: any.
  [[nodiscard]] std::uint32_t period() const { return output_->period(); }
  /// As PwmOutput::unreachable(). Context: any.
  [[nodiscard]] bool unreachable() const { return output_->unreachable(); }

 private:
  PwmOutput* const output_;
  const std::uint8_t channel_;
};

/// A timer channel of the chip; it has channel 0 alone.
class PwmBus : public PwmOutput {
 public:
  static constexpr Duration kDefaultPeriod = 20000000;  ///< 50 Hz, what servos and ESCs take

  /// @param port    the board's
  /// @param period  how often pulses repeat
  constexpr explicit PwmBus(PwmPort& port, Duration period = kDefaultPeriod)
      : PwmOutput(&channel_, 1, static_cast<std::uint32_t>(period), true), port_(&port) {}

  /// The output stays low until the first flush(). Context: init.
  void start();

  /// Writes period and pulse where they have changed. Context: end of any bucket that drives it.
  void flush();

 private:
  PwmPort* const port_;
  Channel channel_;
};

}  // namespace finemote
