// GpioPort on the board's single pins, in the order of the `pins` list of the board file.
#include "finemote/ports.hpp"
#include "runtime/boards/robomaster_type_c/pin.hpp"
#include "runtime/boards/robomaster_type_c/registers/clock.hpp"

namespace finemote {

/// The port has no state of its own: the pins are the same on every board.
struct GpioHardware {};

namespace {

using robomaster_type_c::Pin;
using robomaster_type_c::PinMode;
using robomaster_type_c::PinPull;
using robomaster_type_c::PinSetup;

struct BoardPin {
  Pin pin;
  PinMode mode;
  bool idle_high;  ///< an input: pulled up
};

constexpr BoardPin kPins[] = {
    {{'A', 0}, PinMode::input, true},     // 0 key, active low
    {{'H', 10}, PinMode::output, false},  // 1 led_blue
    {{'H', 11}, PinMode::output, false},  // 2 led_green
    {{'H', 12}, PinMode::output, false},  // 3 led_red
    {{'D', 14}, PinMode::output, false},  // 4 buzzer
    {{'C', 8}, PinMode::output, false},   // 5 laser
    {{'F', 6}, PinMode::output, false},   // 6 imu_heater
    {{'A', 4}, PinMode::output, true},    // 7 bmi088_cs_accel
    {{'B', 0}, PinMode::output, true},    // 8 bmi088_cs_gyro
    {{'C', 4}, PinMode::input, true},     // 9 bmi088_int_accel
    {{'C', 5}, PinMode::input, true},     // 10 bmi088_int_gyro
    {{'G', 6}, PinMode::output, true},    // 11 ist8310_reset
    {{'G', 3}, PinMode::input, true},     // 12 ist8310_int
    {{'F', 10}, PinMode::analog, false},  // 13 battery
    {{'B', 12}, PinMode::output, true},   // 14 spi2_cs
};
constexpr std::uint8_t kPinCount = sizeof kPins / sizeof kPins[0];

GpioHardware hardware;

}  // namespace

void GpioPort::start() {
  for (const BoardPin& it : kPins) {
    const bool pulled_up = it.mode == PinMode::input && it.idle_high;
    stm32f407::rcc::enable(stm32f407::rcc::ahb1enr, stm32f407::bit(static_cast<unsigned>(it.pin.port - 'A')));
    if (it.mode == PinMode::output) it.pin.set(it.idle_high);  // the level first, so that the pin never shows the other
    configure(it.pin, PinSetup{it.mode, pulled_up ? PinPull::up : PinPull::none});
  }
}

void GpioPort::write(std::uint8_t pin, bool high) {
  if (pin < kPinCount && kPins[pin].mode == PinMode::output) kPins[pin].pin.set(high);
}

bool GpioPort::read(std::uint8_t pin) const { return pin < kPinCount && kPins[pin].pin.is_high(); }

GpioPort ports::gpio{hardware};

}  // namespace finemote
