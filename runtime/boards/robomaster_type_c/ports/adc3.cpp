// AdcPort on ADC3: single conversions begun by software, RM0090 13.3.4.
#include "finemote/ports.hpp"
#include "runtime/boards/robomaster_type_c/interrupt.hpp"
#include "runtime/boards/robomaster_type_c/pin.hpp"
#include "runtime/boards/robomaster_type_c/registers/adc.hpp"
#include "runtime/boards/robomaster_type_c/registers/clock.hpp"

namespace finemote {

struct AdcHardware {
  bool converting = false;
  std::uint8_t input = 0;
};

namespace {

namespace adc = stm32f407::adc;
namespace adc3 = stm32f407::adc3;
namespace rcc = stm32f407::rcc;

// APB2 at 84 MHz by 4 is 21 MHz; at most 36 MHz at 3.3 V (DS8626 5.3.21). The longest sampling time, 480 cycles and 12
// of conversion, is 23.4 us: a divider of hundreds of kiloohms charges the sampling capacitor.
constexpr std::uint32_t kLongestSampling = 7;

AdcHardware hardware;

}  // namespace

void AdcPort::start(std::uint8_t input, std::uint8_t pin) {
  rcc::enable(rcc::apb2enr, rcc::kApb2Adc3);
  const robomaster_type_c::Pin place{static_cast<char>('A' + pin / 16), static_cast<std::uint8_t>(pin % 16)};
  configure(place, robomaster_type_c::PinSetup{robomaster_type_c::PinMode::analog});
  adc::ccr.modify(adc::kPrescalerMask, adc::kPrescalerBy4);
  adc3::smpr2.modify(7U << (3 * input), kLongestSampling << (3 * input));  // inputs 0 to 9
  adc3::sqr1.write(0);                                                     // a sequence of one
  adc3::cr2.write(adc3::kCr2On);  // up within 3 us (DS8626 5.3.21), long before the first begin()
}

void AdcPort::begin(std::uint8_t input) {
  if (hardware_->converting && !adc3::sr.any(adc3::kSrEnd)) return;  // a result nobody took is dropped
  hardware_->converting = true;
  hardware_->input = input;
  adc3::sqr3.write(input);
  adc3::sr.write(0);  // rc_w0
  adc3::cr2.set(adc3::kCr2Start);
  robomaster_type_c::drain();
}

bool AdcPort::take(std::uint8_t input, std::uint16_t& value) {
  if (!hardware_->converting || hardware_->input != input || !adc3::sr.any(adc3::kSrEnd)) return false;
  value = static_cast<std::uint16_t>(adc3::dr.read());  // reading DR clears EOC: 13.13.1
  hardware_->converting = false;
  return true;
}

AdcPort ports::adc3{hardware};

}  // namespace finemote
