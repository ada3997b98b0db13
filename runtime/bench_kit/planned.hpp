// What bench_plan.hpp, which is made of the board file for every kit, is made of.
#pragma once

#include <cstdint>

#include "runtime/chips/stm32f4/peripherals.hpp"
#include "runtime/chips/stm32f4/pin.hpp"
#include "runtime/chips/stm32f4/registers/dma.hpp"

namespace finemote::bench_kit {

/// Tests that one procedure answers.
enum class Group : std::uint8_t;

struct Planned {
  const char* name;
  Group group;
  std::uint32_t least, most;  ///< of its value
  bool is_judged;             ///< false: measured, and nothing is claimed of it
  const char* needs;          ///< what a bare board lacks for it; empty: nothing
};

/// An interrupt line of a bus of the robot, which is the one of this number.
struct BusLine {
  std::uint16_t line;
  std::uint16_t bus;
};
inline constexpr std::uint16_t kNoLine = 0xFFFF;  ///< ends the list

struct UartPins {
  stm32f4::UsartPeripheral peripheral;
  stm32f4::Pin tx, rx;
  std::uint8_t function;  ///< of both, as for all pins below
};
struct SpiPins {
  stm32f4::SpiPeripheral peripheral;
  stm32f4::Pin sck, miso, mosi;
  std::uint8_t function;
  const stm32f4::Pin* selects;
  unsigned select_count;
  stm32f4::DmaStream receive, transmit;
  std::uint32_t request;  ///< channel of both streams
};
struct I2cPins {
  stm32f4::I2cPeripheral peripheral;
  stm32f4::Pin scl, sda;
  std::uint8_t function;
};

}  // namespace finemote::bench_kit
