// Turns conversions of one analog input into volts at the connector.
#pragma once

#include <cstdint>

#include "finemote/ports.hpp"

namespace finemote {

/// One analog input, as a device holds it.
class AnalogPin {
 public:
  /// @param port        the board's converter
  /// @param input       of the converter
  /// @param full_scale  what the highest code means [V], any divider before the pin included
  constexpr AnalogPin(AdcPort& port, std::uint8_t input, float full_scale)
      : port_(&port), input_(input), volt_per_code_(full_scale / AdcPort::kFullScale) {}

  /// The measurement the last call began, and begins the next; never waits. False: there is none. Context: bucket.
  [[nodiscard]] bool sample(float& volts) {
    std::uint16_t code = 0;
    const bool ready = port_->take(input_, code);
    if (ready) volts = static_cast<float>(code) * volt_per_code_;
    port_->begin(input_);
    return ready;
  }
  /// What the highest code means [V]: a measurement there may be more. Context: any.
  [[nodiscard]] float full_scale() const { return volt_per_code_ * AdcPort::kFullScale; }

 private:
  AdcPort* const port_;
  const std::uint8_t input_;
  const float volt_per_code_;
};

}  // namespace finemote
