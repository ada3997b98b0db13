// What a bus has carried, for the run's report.
#pragma once

#include <cstdint>
#include <map>
#include <utility>

#include "emulator/time.hpp"

namespace finemote::emulator {

struct BusStatistics {
  std::uint64_t transfers = 0;  ///< I2C: START to STOP; UART: bursts both ways; CAN: frames; SPI: exchanges
  std::uint64_t bytes = 0;
  std::uint64_t errors = 0;
  Time busy = 0;      ///< time of all bits on the wire; UART: of the line the board sends on
  Time received = 0;  ///< UART: the same of the line it receives on
  std::map<std::pair<unsigned, unsigned>, std::uint64_t> lengths = {};  ///< I2C: transfers, by address and data bytes
};

}  // namespace finemote::emulator
