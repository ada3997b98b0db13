// GpioPort on the chip's pins, by number: 16 a port, PA0 first.
#include "finemote/ports.hpp"
#include "runtime/chips/stm32f4/pin.hpp"
#include "runtime/chips/stm32f4/registers/clock.hpp"

namespace finemote {

/// The port has no state of its own: the registers hold it.
struct GpioHardware {};

namespace {

using stm32f4::Pin;
using stm32f4::PinMode;
using stm32f4::PinPull;
using stm32f4::PinSetup;

constexpr std::uint8_t kPinCount = 9 * 16;  // PA0 to PI15

constexpr Pin chip_pin(std::uint8_t number) {
  return {static_cast<char>('A' + number / 16), static_cast<std::uint8_t>(number % 16)};
}

constexpr PinSetup setup_of(PinSetting setting) {
  switch (setting) {
    case PinSetting::kInput:
      return {PinMode::input, PinPull::none};
    case PinSetting::kInputPullUp:
      return {PinMode::input, PinPull::up};
    case PinSetting::kInputPullDown:
      return {PinMode::input, PinPull::down};
    case PinSetting::kOutputLow:
    case PinSetting::kOutputHigh:
      return {PinMode::output, PinPull::none};
    case PinSetting::kAnalog:
      return {PinMode::analog, PinPull::none};
  }
  return {};
}

GpioHardware hardware;

}  // namespace

void GpioPort::configure(std::uint8_t number, PinSetting setting) {
  if (number >= kPinCount) return;
  const Pin pin = chip_pin(number);
  stm32f4::rcc::enable(stm32f4::rcc::ahb1enr, stm32f4::bit(static_cast<unsigned>(pin.port - 'A')));
  // The level first, so that the pin never shows the other one.
  if (setting == PinSetting::kOutputLow || setting == PinSetting::kOutputHigh) {
    pin.set(setting == PinSetting::kOutputHigh);
  }
  stm32f4::configure(pin, setup_of(setting));
}

void GpioPort::write(std::uint8_t number, bool high) {
  if (number < kPinCount) chip_pin(number).set(high);
}

bool GpioPort::read(std::uint8_t number) const { return number < kPinCount && chip_pin(number).is_high(); }

GpioPort ports::gpio{hardware};

}  // namespace finemote
