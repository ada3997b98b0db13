// An analog-to-digital converter: sequences of conversions that software begins, with their time, by polling, interrupt
// or DMA. RM0090 13.
#pragma once

#include <array>
#include <functional>

#include "emulator/chip/dma.hpp"
#include "emulator/chip/peripheral.hpp"

namespace finemote::emulator {

/// Registers the three converters share: 13.13.16.
struct AdcCommon {
  std::uint32_t control = 0;  ///< CCR
  [[nodiscard]] unsigned divider() const { return 2 * ((control >> 16 & 3) + 1); }
  [[nodiscard]] bool senses_inside() const { return (control >> 23 & 1) != 0; }  // TSVREFE
  [[nodiscard]] bool measures_battery() const { return (control >> 22 & 1) != 0; }
};

/// Regular channels alone: no injected ones, no triggers of timers, no analog watchdog.
class Adc : public Peripheral {
 public:
  struct Wiring {
    std::function<std::uint32_t()> clock_hz;  ///< of the bus
    /// Whether the pin of an input is set up for it; true for inputs that are no pins.
    std::function<bool(unsigned input)> pin_is_analog;
    std::function<bool(DmaRequest)> dma;
    DmaRequest request;
    std::function<void(bool)> set_line;  ///< told of changes: the converters share their line
  };
  Adc(World& world, std::string name, const AdcCommon& common, Wiring wiring)
      : Peripheral(world, std::move(name)), common_(common), wiring_(std::move(wiring)) {}

  std::uint32_t read(std::uint32_t offset) override;
  void write(std::uint32_t offset, std::uint32_t value) override;
  void reset() override;

  static constexpr unsigned kInputs = 19, kPins = 16;
  /// Voltage on the pins of inputs 0..15 [V], and inside the chip: of the temperature sensor, the reference and half of
  /// the clock's battery, which only the first converter has; the reference of all is 3.3 V.
  std::array<double, kInputs> volts{};
  /// Conversions no longer end.
  bool dead = false;
  [[nodiscard]] unsigned conversions() const { return conversions_; }
  /// Its flags, lowest byte first, as the common status register shows them: 13.13.15.
  [[nodiscard]] std::uint32_t status() const { return sr_; }

 private:
  void start();
  void convert();
  void finish(unsigned input);
  void store(std::uint32_t result);
  void check_input(unsigned input);
  void update();
  [[nodiscard]] unsigned last_rank() const;
  [[nodiscard]] unsigned input_of(unsigned rank) const;
  [[nodiscard]] Time clock_period() const { return period_of(wiring_.clock_hz()) * common_.divider(); }
  [[nodiscard]] unsigned cycles(unsigned input) const;
  void write_control2(std::uint32_t value);

  const AdcCommon& common_;
  Wiring wiring_;
  std::uint32_t sr_ = 0, cr1_ = 0, cr2_ = 0, dr_ = 0;
  std::array<std::uint32_t, 2> smpr_{};
  std::array<std::uint32_t, 3> sqr_{};
  std::array<std::uint32_t, 7> kept_{};  ///< of the injected channels and the watchdog
  Time ready_at_ = 0;
  bool converting_ = false, line_ = false;
  unsigned rank_ = 0;
  std::uint64_t token_ = 0;
  unsigned conversions_ = 0;
};

}  // namespace finemote::emulator
