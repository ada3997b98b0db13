#include "generator/model/port_rates.hpp"

#include <algorithm>
#include <cmath>

#include "generator/bus/bus_type.hpp"

namespace finemote::gen {

const RateRule* rule_of(const Port& port, BusKind kind) {
  return port.rate_rule != nullptr ? port.rate_rule : bus_type(kind).rate.rule;
}

bool has_few_rates(const Port& port, BusKind kind) {
  const RateRule* rule = rule_of(port, kind);
  return rule != nullptr && rule->all != nullptr && port.clock_hz.has_value();
}

double nearest_rate(const Port& port, BusKind kind, double wanted) {
  if (!port.rates.empty()) {
    const auto nearer = [&](std::int64_t a, std::int64_t b) {
      return std::abs(static_cast<double>(a) - wanted) < std::abs(static_cast<double>(b) - wanted);
    };
    return static_cast<double>(*std::min_element(port.rates.begin(), port.rates.end(), nearer));
  }
  const RateRule* rule = rule_of(port, kind);
  return rule == nullptr || !port.clock_hz ? wanted : rule->nearest(static_cast<double>(*port.clock_hz), wanted);
}

double made_rate(const Port& port, BusKind kind, double wanted) {
  const RateRule* rule = rule_of(port, kind);
  const bool is_nearest = !port.rates.empty() || rule == nullptr || rule->made == nullptr || !port.clock_hz;
  return is_nearest ? nearest_rate(port, kind, wanted) : rule->made(static_cast<double>(*port.clock_hz), wanted);
}

std::int64_t slowest_rate(const Port& port, BusKind kind, std::int64_t wanted) {
  const RateRule* rule = rule_of(port, kind);
  if (rule == nullptr || rule->slowest == nullptr || !port.clock_hz || wanted <= 0) return wanted;
  return std::max<std::int64_t>(rule->slowest(*port.clock_hz, wanted), 1);
}

double rate_error(const Port& port, BusKind kind, double wanted) {
  return std::abs(made_rate(port, kind, wanted) - wanted) / wanted;
}

bool is_made(const Port& port, BusKind kind, std::int64_t rate) {
  if (rate < port.min_rate.value_or(1) || rate > port.max_rate.value_or(INT64_MAX)) return false;
  return rate_error(port, kind, static_cast<double>(rate)) * 1e6 <= static_cast<double>(port.max_rate_error_ppm);
}

}  // namespace finemote::gen
