// AdcPort on the chip's converters: single conversions begun by software, RM0090 13.3.4.
#include "runtime/chips/stm32f4/pin.hpp"
#include "runtime/chips/stm32f4/ports/adc_hardware.hpp"

namespace finemote {
namespace {

namespace adc = stm32f4::adc;
namespace rcc = stm32f4::rcc;

// APB2 at 84 MHz by 4 is 21 MHz; at most 36 MHz at 3.3 V (DS8626 5.3.21). The longest sampling time, 480 cycles and 12
// of conversion, is 23.4 us: a divider of hundreds of kiloohms charges the sampling capacitor.
constexpr std::uint32_t kLongestSampling = 7;
static_assert(stm32f4::kApb2Hz / 4 <= 36'000'000);

/// Three bits an input; ten inputs a register.
void sample_longest(const stm32f4::AdcRegisters& registers, std::uint32_t input) {
  const std::uint32_t shift = 3 * (input % 10);
  registers.smpr(input < 10 ? 1 : 0).modify(7U << shift, kLongestSampling << shift);
}

}  // namespace

void AdcPort::start(std::uint8_t input, std::uint8_t pin) {
  const stm32f4::AdcRegisters& registers = hardware_->peripheral.adc;
  rcc::enable(rcc::apb2enr, hardware_->peripheral.clock_bit);
  const stm32f4::Pin place{static_cast<char>('A' + pin / 16), static_cast<std::uint8_t>(pin % 16)};
  configure(place, stm32f4::PinSetup{stm32f4::PinMode::analog});
  adc::ccr.modify(adc::kPrescalerMask, adc::kPrescalerBy4);
  sample_longest(registers, input);
  registers.sqr1().write(0);           // a sequence of one
  registers.cr2().write(adc::kCr2On);  // up within 3 us (DS8626 5.3.21), long before the first begin()
}

void AdcPort::begin(std::uint8_t input) {
  const stm32f4::AdcRegisters& registers = hardware_->peripheral.adc;
  if (hardware_->converting && !registers.sr().any(adc::kSrEnd)) return;  // a result nobody took is dropped
  hardware_->converting = true;
  hardware_->input = input;
  registers.sqr3().write(input);
  registers.sr().write(0);  // rc_w0
  registers.cr2().set(adc::kCr2Start);
}

bool AdcPort::take(std::uint8_t input, std::uint16_t& value) {
  const stm32f4::AdcRegisters& registers = hardware_->peripheral.adc;
  if (!hardware_->converting || hardware_->input != input || !registers.sr().any(adc::kSrEnd)) return false;
  value = static_cast<std::uint16_t>(registers.dr().read());  // reading DR clears EOC: 13.13.1
  hardware_->converting = false;
  return true;
}

}  // namespace finemote
