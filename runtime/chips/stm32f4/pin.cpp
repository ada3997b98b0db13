#include "runtime/chips/stm32f4/pin.hpp"

#include "runtime/chips/stm32f4/registers/clock.hpp"

namespace finemote::stm32f4 {
namespace {

constexpr std::uint32_t kSpeedHigh = 2;  // OSPEEDR, RM0090 8.4.3

/// Replaces field `index` of `width` bits.
void write_field(const Register& target, std::uint32_t index, std::uint32_t width, std::uint32_t value) {
  const std::uint32_t shift = index * width;
  target.modify(((std::uint32_t{1} << width) - 1) << shift, value << shift);
}

}  // namespace

void configure(Pin pin, const PinSetup& setup) {
  rcc::enable(rcc::ahb1enr, bit(static_cast<unsigned>(pin.port - 'A')));
  const GpioRegisters gpio = pin.registers();
  write_field(gpio.ospeedr(), pin.number, 2, kSpeedHigh);
  write_field(gpio.otyper(), pin.number, 1, setup.open_drain ? 1 : 0);
  write_field(gpio.pupdr(), pin.number, 2, static_cast<std::uint32_t>(setup.pull));
  write_field(gpio.afr(pin.number / 8U), pin.number % 8U, 4, setup.function);
  write_field(gpio.moder(), pin.number, 2, static_cast<std::uint32_t>(setup.mode));
}

}  // namespace finemote::stm32f4
