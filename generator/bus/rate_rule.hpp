// How a port makes the rate of a bus out of its clock: a rule of the chip, which the board file names.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "generator/bus/bus_kind.hpp"

namespace finemote::gen {

struct RateRule {
  std::string_view name;  ///< `rate_rule` of a port in a board file: `stm32_spi`

  std::span<const BusKind> kinds;  ///< of buses that a port of the rule can serve

  /// Of the rates that can be made, the one nearest to `wanted` [Hz or bit/s]; both arguments are above 0.
  double (*nearest)(double clock_hz, double wanted) = nullptr;

  /// What the runtime's driver makes of `wanted`, where that need not be the nearest; null: it is.
  double (*made)(double clock_hz, double wanted) = nullptr;

  /// The same at its slowest; null: just that rate, within what the board
  /// file allows.
  std::int64_t (*slowest)(std::int64_t clock_hz, std::int64_t wanted) = nullptr;

  /// All rates that can be made, falling [Hz or bit/s]; null: too many to list.
  std::vector<std::int64_t> (*all)(std::int64_t clock_hz) = nullptr;
};

/// STM32F4, RM0090 30.3.4: the clock over a whole divider of 16 or more.
extern const RateRule kStm32Usart;

/// STM32F4, RM0090 27.6.8: the clock over a whole divider, times 3 above 100 kHz and times 2 below.
extern const RateRule kStm32I2c;

/// STM32F4, RM0090 28.5.1: the clock over a power of two from 2 to 256.
extern const RateRule kStm32Spi;

/// STM32F4, RM0090 32.7.7: the clock over the 14 quanta that the driver divides a bit into and a whole divider.
extern const RateRule kStm32Can;

/// The rule of that name; null: there is none.
const RateRule* rate_rule(std::string_view name);

/// All names, for the schema of board files.
std::vector<std::string> rate_rule_names();

}  // namespace finemote::gen
