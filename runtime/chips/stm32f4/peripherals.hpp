// Where each peripheral of the chip is, and what clocks it. Addresses: RM0090 2.3, table 1; clock bits: RM0090 7.3.13
// (APB1) and 7.3.14 (APB2).
#pragma once

#include "runtime/chips/stm32f4/clock.hpp"
#include "runtime/chips/stm32f4/registers/adc.hpp"
#include "runtime/chips/stm32f4/registers/can.hpp"
#include "runtime/chips/stm32f4/registers/clock.hpp"
#include "runtime/chips/stm32f4/registers/i2c.hpp"
#include "runtime/chips/stm32f4/registers/spi.hpp"
#include "runtime/chips/stm32f4/registers/timer.hpp"
#include "runtime/chips/stm32f4/registers/usart.hpp"

namespace finemote::stm32f4 {

struct UsartPeripheral {
  UsartRegisters usart;
  Register clock_enable;
  std::uint32_t clock_bit;
  std::uint32_t clock_hz;  ///< what the baud rate is divided from
};
inline constexpr UsartPeripheral kUsart1{{0x40011000}, rcc::apb2enr, bit(4), kApb2Hz};
inline constexpr UsartPeripheral kUsart2{{0x40004400}, rcc::apb1enr, bit(17), kApb1Hz};
inline constexpr UsartPeripheral kUsart3{{0x40004800}, rcc::apb1enr, bit(18), kApb1Hz};
inline constexpr UsartPeripheral kUart4{{0x40004C00}, rcc::apb1enr, bit(19), kApb1Hz};
inline constexpr UsartPeripheral kUart5{{0x40005000}, rcc::apb1enr, bit(20), kApb1Hz};
inline constexpr UsartPeripheral kUsart6{{0x40011400}, rcc::apb2enr, bit(5), kApb2Hz};

struct SpiPeripheral {
  SpiRegisters spi;
  Register clock_enable;
  std::uint32_t clock_bit;
  std::uint32_t clock_hz;  ///< what the bus clock is divided from
};
inline constexpr SpiPeripheral kSpi1{{0x40013000}, rcc::apb2enr, bit(12), kApb2Hz};
inline constexpr SpiPeripheral kSpi2{{0x40003800}, rcc::apb1enr, bit(14), kApb1Hz};
inline constexpr SpiPeripheral kSpi3{{0x40003C00}, rcc::apb1enr, bit(15), kApb1Hz};

struct I2cPeripheral {
  I2cRegisters i2c;
  std::uint32_t clock_bit;  ///< in rcc::apb1enr
};
inline constexpr I2cPeripheral kI2c1{{0x40005400}, bit(21)};
inline constexpr I2cPeripheral kI2c2{{0x40005800}, bit(22)};
inline constexpr I2cPeripheral kI2c3{{0x40005C00}, bit(23)};

struct CanPeripheral {
  CanRegisters can;
  std::uint32_t clock_bits;  ///< in rcc::apb1enr; CAN2 needs CAN1's too, which holds the filters (RM0090 32.3.5)
};
inline constexpr CanPeripheral kCan1{{0x40006400}, bit(25)};
inline constexpr CanPeripheral kCan2{{0x40006800}, bit(25) | bit(26)};
/// The filter banks from which on each controller has its own: a documented choice, half and half.
inline constexpr std::uint8_t kCan1FirstBank = 0, kCan2FirstBank = 14;

struct TimerPeripheral {
  TimerRegisters timer;
  std::uint32_t clock_bit;  ///< in rcc::apb1enr or apb2enr

  [[nodiscard]] constexpr bool is_on_apb1() const { return timer.base < 0x40010000; }
  /// Complementary outputs, and with them a main output enable: RM0090 17.4.18.
  [[nodiscard]] constexpr bool is_advanced() const { return timer.base == 0x40010000 || timer.base == 0x40010400; }
};
inline constexpr TimerPeripheral kTim1{{0x40010000}, bit(0)}, kTim2{{0x40000000}, bit(0)}, kTim3{{0x40000400}, bit(1)},
    kTim4{{0x40000800}, bit(2)}, kTim5{{0x40000C00}, bit(3)}, kTim8{{0x40010400}, bit(1)}, kTim9{{0x40014000}, bit(16)},
    kTim10{{0x40014400}, bit(17)}, kTim11{{0x40014800}, bit(18)}, kTim12{{0x40001800}, bit(6)},
    kTim13{{0x40001C00}, bit(7)}, kTim14{{0x40002000}, bit(8)};

struct AdcPeripheral {
  AdcRegisters adc;
  std::uint32_t clock_bit;  ///< in rcc::apb2enr
};
inline constexpr AdcPeripheral kAdc1{{0x40012000}, bit(8)};
inline constexpr AdcPeripheral kAdc2{{0x40012100}, bit(9)};
inline constexpr AdcPeripheral kAdc3{{0x40012200}, bit(10)};

}  // namespace finemote::stm32f4
