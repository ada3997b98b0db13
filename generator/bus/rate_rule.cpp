#include "generator/bus/rate_rule.hpp"

#include <algorithm>
#include <cmath>

namespace finemote::gen {
namespace {

/// What the chip makes of it, where that is slower.
template <double (*rate)(double, double)>
std::int64_t slowest_of(std::int64_t clock_hz, std::int64_t wanted) {
  const double made = rate(static_cast<double>(clock_hz), static_cast<double>(wanted));
  return std::min(wanted, static_cast<std::int64_t>(made));
}

/// As runtime/chips/stm32f4/ports/uart.cpp sets BRR: the nearest divider.
double nearest_usart_rate(double clock_hz, double wanted) {
  return clock_hz / std::max(16.0, std::round(clock_hz / wanted));
}

double nearest_i2c_rate(double clock_hz, double wanted) {
  const double step = wanted > 100'000 ? 3 : 2;
  return clock_hz / (step * std::max(1.0, std::round(clock_hz / (step * wanted))));
}

/// As runtime/chips/stm32f4/ports/i2c.cpp sets CCR: rounded up, and 87 kHz in the range that ES0182 forbids. Each clock
/// is longer by the rise of the line: 300 ns above 100 kHz, else 1000 ns (UM10204, table 10).
std::int64_t slowest_i2c_rate(std::int64_t clock_hz, std::int64_t wanted) {
  const bool is_fast = wanted > 100'000;
  const std::int64_t step = is_fast ? 3 : 2, asked = is_fast ? wanted : std::min<std::int64_t>(wanted, 87'000);
  const std::int64_t counts = step * ((clock_hz + step * asked - 1) / (step * asked));
  constexpr std::int64_t kNsPerS = 1'000'000'000;
  const std::int64_t period_ns = (counts * kNsPerS + clock_hz - 1) / clock_hz + (is_fast ? 300 : 1'000);
  return kNsPerS / period_ns;
}

double nearest_spi_rate(double clock_hz, double wanted) {
  double best = clock_hz / 2;
  for (double divider = 4; divider <= 256; divider *= 2) {
    if (std::abs(clock_hz / divider - wanted) < std::abs(best - wanted)) best = clock_hz / divider;
  }
  return best;
}

double nearest_can_rate(double clock_hz, double wanted) {
  constexpr double kQuanta = 14;
  return clock_hz / (kQuanta * std::max(1.0, std::round(clock_hz / (kQuanta * wanted))));
}

/// As runtime/chips/stm32f4/ports/spi.cpp sets BR: the fastest that is not above it.
double made_spi_rate(double clock_hz, double wanted) {
  double made = clock_hz / 2;
  for (double divider = 4; divider <= 256 && made > wanted; divider *= 2) made = clock_hz / divider;
  return made;
}

std::vector<std::int64_t> all_spi_rates(std::int64_t clock_hz) {
  std::vector<std::int64_t> rates;
  for (int power = 1; power <= 8; ++power) rates.push_back(clock_hz >> power);
  return rates;
}

constexpr BusKind kSerial[] = {BusKind::uart, BusKind::rs485};
constexpr BusKind kI2c[] = {BusKind::i2c};
constexpr BusKind kSpi[] = {BusKind::spi};
constexpr BusKind kCan[] = {BusKind::can};

constexpr const RateRule* kRules[] = {&kStm32Usart, &kStm32I2c, &kStm32Spi, &kStm32Can};

}  // namespace

constinit const RateRule kStm32Usart{
    .name = "stm32_usart", .kinds = kSerial, .nearest = nearest_usart_rate, .slowest = slowest_of<nearest_usart_rate>};
constinit const RateRule kStm32I2c{
    .name = "stm32_i2c", .kinds = kI2c, .nearest = nearest_i2c_rate, .slowest = slowest_i2c_rate};
constinit const RateRule kStm32Spi{.name = "stm32_spi",
                                   .kinds = kSpi,
                                   .nearest = nearest_spi_rate,
                                   .made = made_spi_rate,
                                   .slowest = slowest_of<made_spi_rate>,
                                   .all = all_spi_rates};
constinit const RateRule kStm32Can{
    .name = "stm32_can", .kinds = kCan, .nearest = nearest_can_rate, .slowest = slowest_of<nearest_can_rate>};

const RateRule* rate_rule(std::string_view name) {
  const auto* found =
      std::find_if(std::begin(kRules), std::end(kRules), [&](const RateRule* rule) { return rule->name == name; });
  return found == std::end(kRules) ? nullptr : *found;
}

std::vector<std::string> rate_rule_names() {
  std::vector<std::string> names;
  for (const RateRule* rule : kRules) names.emplace_back(rule->name);
  return names;
}

}  // namespace finemote::gen
