// Which peripherals an STM32F407 has: addresses (RM0090 2.3, table 1), clock enable bits (RM0090 7.3.10 to 7.3.14),
// interrupt lines (RM0090 12.2, table 62) and DMA requests (RM0090 10.3.3, tables 42 and 43).
#pragma once

#include <cstdint>

#include "emulator/chip/can.hpp"
#include "emulator/chip/dma.hpp"
#include "emulator/chip/rcc.hpp"
#include "emulator/chip/timer.hpp"

namespace finemote::emulator::stm32f407 {

/// Where a peripheral answers, and the clock it needs for that.
struct Place {
  std::uint32_t base;
  ClockBus bus;
  unsigned bit;
};

inline constexpr Place kRcc{0x40023800, ClockBus::always, 0}, kFlash{0x40023C00, ClockBus::always, 0},
    kIwdg{0x40003000, ClockBus::always, 0}, kPwr{0x40007000, ClockBus::apb1, 28},
    kSyscfg{0x40013800, ClockBus::apb2, 14}, kExti{0x40013C00, ClockBus::always, 0},
    kDma1{0x40026000, ClockBus::ahb1, 21}, kDma2{0x40026400, ClockBus::ahb1, 22}, kCrc{0x40023000, ClockBus::ahb1, 12},
    kRtc{0x40002800, ClockBus::always, 0}, kWwdg{0x40002C00, ClockBus::apb1, 11}, kDac{0x40007400, ClockBus::apb1, 29},
    kUsb{0x50000000, ClockBus::ahb2, 7}, kRng{0x50060800, ClockBus::ahb2, 6}, kAdcs{0x40012000, ClockBus::apb2, 8};

inline constexpr char kFirstPort = 'A', kLastPort = 'I';
constexpr Place port_place(char port) {
  const auto index = static_cast<unsigned>(port - kFirstPort);
  return {0x40020000 + 0x400 * index, ClockBus::ahb1, index};
}

/// A USART or an SPI.
struct Stream {
  const char* name;
  Place place;
  int line;
  DmaRequest rx, tx;
};
inline constexpr Stream kUsarts[] = {
    {"usart1", {0x40011000, ClockBus::apb2, 4}, 37, DmaRequest::usart1_rx, DmaRequest::usart1_tx},
    {"usart2", {0x40004400, ClockBus::apb1, 17}, 38, DmaRequest::usart2_rx, DmaRequest::usart2_tx},
    {"usart3", {0x40004800, ClockBus::apb1, 18}, 39, DmaRequest::usart3_rx, DmaRequest::usart3_tx},
    {"uart4", {0x40004C00, ClockBus::apb1, 19}, 52, DmaRequest::uart4_rx, DmaRequest::uart4_tx},
    {"uart5", {0x40005000, ClockBus::apb1, 20}, 53, DmaRequest::uart5_rx, DmaRequest::uart5_tx},
    {"usart6", {0x40011400, ClockBus::apb2, 5}, 71, DmaRequest::usart6_rx, DmaRequest::usart6_tx},
};
inline constexpr Stream kSpis[] = {
    {"spi1", {0x40013000, ClockBus::apb2, 12}, 35, DmaRequest::spi1_rx, DmaRequest::spi1_tx},
    {"spi2", {0x40003800, ClockBus::apb1, 14}, 36, DmaRequest::spi2_rx, DmaRequest::spi2_tx},
    {"spi3", {0x40003C00, ClockBus::apb1, 15}, 51, DmaRequest::spi3_rx, DmaRequest::spi3_tx},
};

struct I2cEntry {
  const char* name;
  Place place;
  int event_line, error_line;
  DmaRequest rx, tx;
};
inline constexpr I2cEntry kI2cs[] = {
    {"i2c1", {0x40005400, ClockBus::apb1, 21}, 31, 32, DmaRequest::i2c1_rx, DmaRequest::i2c1_tx},
    {"i2c2", {0x40005800, ClockBus::apb1, 22}, 33, 34, DmaRequest::i2c2_rx, DmaRequest::i2c2_tx},
    {"i2c3", {0x40005C00, ClockBus::apb1, 23}, 72, 73, DmaRequest::i2c3_rx, DmaRequest::i2c3_tx},
};

struct CanEntry {
  const char* name;
  Place place;
  Can::Lines lines;
  bool is_second;  ///< its filters are CAN1's
};
inline constexpr CanEntry kCans[] = {
    {"can1", {0x40006400, ClockBus::apb1, 25}, {19, {20, 21}, 22}, false},
    {"can2", {0x40006800, ClockBus::apb1, 26}, {63, {64, 65}, 66}, true},
};

struct TimerEntry {
  const char* name;
  Place place;
  int line;  ///< of updates, and of everything where the timer has but one
  TimerKind kind;
  int compare_line = line;
};
inline constexpr TimerKind kPlain{false, false}, kAdvanced{true, false}, kWide{false, true};
inline constexpr TimerEntry kTimers[] = {
    {"tim1", {0x40010000, ClockBus::apb2, 0}, 25, kAdvanced, 27},
    {"tim2", {0x40000000, ClockBus::apb1, 0}, 28, kWide},
    {"tim3", {0x40000400, ClockBus::apb1, 1}, 29, kPlain},
    {"tim4", {0x40000800, ClockBus::apb1, 2}, 30, kPlain},
    {"tim5", {0x40000C00, ClockBus::apb1, 3}, 50, kWide},
    {"tim6", {0x40001000, ClockBus::apb1, 4}, 54, kPlain},
    {"tim7", {0x40001400, ClockBus::apb1, 5}, 55, kPlain},
    {"tim8", {0x40010400, ClockBus::apb2, 1}, 44, kAdvanced, 46},
    {"tim9", {0x40014000, ClockBus::apb2, 16}, 24, kPlain},
    {"tim10", {0x40014400, ClockBus::apb2, 17}, 25, kPlain},
    {"tim11", {0x40014800, ClockBus::apb2, 18}, 26, kPlain},
    {"tim12", {0x40001800, ClockBus::apb1, 6}, 43, kPlain},
    {"tim13", {0x40001C00, ClockBus::apb1, 7}, 44, kPlain},
    {"tim14", {0x40002000, ClockBus::apb1, 8}, 45, kPlain},
};

/// A converter: its request for DMA, and the pins of its inputs from 0 on, `PA0`; null: none. DS8626 table 7.
struct AdcEntry {
  const char* name;
  DmaRequest request;
  const char* pins[16];
};
inline constexpr int kAdcLine = 18;
inline constexpr AdcEntry kAdcEntries[] = {
    {"adc1",
     DmaRequest::adc1,
     {"PA0", "PA1", "PA2", "PA3", "PA4", "PA5", "PA6", "PA7", "PB0", "PB1", "PC0", "PC1", "PC2", "PC3", "PC4", "PC5"}},
    {"adc2",
     DmaRequest::adc2,
     {"PA0", "PA1", "PA2", "PA3", "PA4", "PA5", "PA6", "PA7", "PB0", "PB1", "PC0", "PC1", "PC2", "PC3", "PC4", "PC5"}},
    {"adc3",
     DmaRequest::adc3,
     {"PA0", "PA1", "PA2", "PA3", "PF6", "PF7", "PF8", "PF9", "PF10", "PF3", "PC0", "PC1", "PC2", "PC3", "PF4", "PF5"}},
};

}  // namespace finemote::emulator::stm32f407
