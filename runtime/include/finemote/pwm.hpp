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
  /// Wanted pulse width [ns] of a channel, 0 = no pulse; sent by the next flush() if it differs from the last one.
  /// A channel the part does not have is ignored. Context: any bucket.
  void set(std::uint8_t channel, std::uint32_t pulse);

  /// Pulse width [ns] that is safe on this channel (an ESC's neutral): sent first after start and after any bus
  /// recovery. Context: any bucket.
  void set_safe(std::uint8_t channel, std::uint32_t pulse);

  /// True when the part cannot be reached over its bus: what set() asks for does not arrive. Context: any.
  [[nodiscard]] bool unreachable() const { return unreachable_.load(); }

  [[nodiscard]] std::uint8_t channels() const { return count_; }

 protected:
  struct Channel {
    Shared<std::uint32_t> pulse{0};
    Shared<std::uint32_t> safe{0};
  };

  constexpr PwmOutput(Channel* channels, std::uint8_t count) : channels_(channels), count_(count) {}

  Channel* channels_;
  std::uint8_t count_;
  Shared<bool> unreachable_{false};
  Shared<std::uint32_t> changed_{0};     ///< bit n: channel n differs from what was sent
  Shared<std::uint32_t> safe_known_{0};  ///< bit n: channel n has a safe pulse
  Shared<bool> safe_changed_{false};
};

/// One channel of a PwmOutput, as a device holds it.
class PwmChannel {
 public:
  constexpr PwmChannel(PwmOutput& output, std::uint8_t channel) : output_(&output), channel_(channel) {}

  void set(std::uint32_t pulse) { output_->set(channel_, pulse); }
  void set_safe(std::uint32_t pulse) { output_->set_safe(channel_, pulse); }
  [[nodiscard]] bool unreachable() const { return output_->unreachable(); }

 private:
  PwmOutput* output_;
  std::uint8_t channel_;
};

/// A timer channel of the chip; it has channel 0 alone.
class PwmBus : public PwmOutput {
 public:
  static constexpr Duration kDefaultPeriod = 20000000;  ///< 50 Hz, what servos and ESCs take

  constexpr explicit PwmBus(PwmPort& port, Duration period = kDefaultPeriod)
      : PwmOutput(&channel_, 1), port_(&port), period_(period) {}

  /// The output stays low until the first flush(). Context: init.
  void start();

  /// Writes the pulse if it has changed. Context: end of any bucket that drives it.
  void flush();

 private:
  PwmPort* port_;
  Duration period_;
  Channel channel_;
};

}  // namespace finemote
