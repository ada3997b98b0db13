// An analog-to-digital converter: single conversions that software begins, with their time. RM0090 13.
#pragma once

#include <array>
#include <functional>

#include "emulator/chip/peripheral.hpp"

namespace finemote::emulator {

/// ADC3 alone, with the registers the three converters share.
class Adc : public Peripheral {
 public:
  struct Wiring {
    std::function<std::uint32_t()> clock_hz;  ///< of the bus
    std::function<bool(unsigned input)> pin_is_analog;
  };
  Adc(World& world, std::string name, Wiring wiring) : Peripheral(world, std::move(name)), wiring_(std::move(wiring)) {}

  std::uint32_t read(std::uint32_t offset) override;
  void write(std::uint32_t offset, std::uint32_t value) override;
  void reset() override;

  /// Voltage on the pins of inputs 0..15 [V]; the reference is 3.3 V.
  std::array<double, 16> volts{};
  /// Conversions no longer end.
  bool dead = false;
  [[nodiscard]] unsigned conversions() const { return conversions_; }

 private:
  void start();
  void finish(unsigned input);
  [[nodiscard]] Time clock_period() const;
  [[nodiscard]] unsigned cycles(unsigned input) const;
  void write_control2(std::uint32_t value);

  Wiring wiring_;
  std::uint32_t sr_ = 0, cr1_ = 0, cr2_ = 0, dr_ = 0, ccr_ = 0;
  std::array<std::uint32_t, 2> smpr_{};
  std::array<std::uint32_t, 3> sqr_{};
  Time ready_at_ = 0;
  bool converting_ = false;
  std::uint64_t token_ = 0;
  unsigned conversions_ = 0;
};

}  // namespace finemote::emulator
