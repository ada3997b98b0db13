// Sixteen pins: from mode and output registers, and what hangs at them, to levels. RM0090 8.
#pragma once

#include <array>
#include <functional>

#include "emulator/chip/peripheral.hpp"

namespace finemote::emulator {

class Gpio : public Peripheral {
 public:
  Gpio(World& world, char port)
      : Peripheral(world, std::string("gpio") + static_cast<char>(port - 'A' + 'a')), port_(port) {
    outside_.fill(-1);
    reset();
  }

  std::uint32_t read(std::uint32_t offset) override;
  void write(std::uint32_t offset, std::uint32_t value) override;
  void write_part(std::uint32_t offset, std::uint32_t mask, std::uint32_t value) override;
  void reset() override;

  /// What the outside does with a pin; -1: leaves it alone. A driven-low open-drain pin stays low.
  void drive(unsigned pin, int level);
  /// Level on the pin.
  [[nodiscard]] bool level(unsigned pin) const;
  [[nodiscard]] unsigned mode(unsigned pin) const { return moder_ >> (2 * pin) & 3; }
  [[nodiscard]] unsigned function(unsigned pin) const { return afr_[pin / 8] >> (4 * (pin % 8)) & 0xF; }

  /// The level of a pin is asked of a wire shared with others (open drain): wired AND.
  std::array<std::function<bool()>, 16> wire;
  /// Told after every change of an output pin or its mode.
  std::array<std::function<void(bool output, bool high)>, 16> watcher;
  /// The same for all pins, for those who look on.
  std::function<void(unsigned pin, bool output, bool high)> on_output;
  /// Told after every change of a level, for EXTI.
  std::function<void(unsigned pin, bool high)> on_level;

 private:
  void changed();

  char port_;
  std::uint32_t moder_ = 0, otyper_ = 0, ospeedr_ = 0, pupdr_ = 0, odr_ = 0;
  std::array<std::uint32_t, 2> afr_{};
  std::array<int, 16> outside_{};
  std::uint32_t last_levels_ = 0;
  std::uint64_t last_drive_ = 0;  ///< of each pin its mode and output
};

}  // namespace finemote::emulator
