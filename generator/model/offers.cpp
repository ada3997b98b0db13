#include "generator/model/offers.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/bus/bus_type.hpp"
#include "generator/model/port_rates.hpp"

namespace finemote::gen {
namespace {

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool meet(const Port& a, const Port& b) {
  return std::any_of(a.resources.begin(), a.resources.end(), [&](const Resource& mine) {
    return std::any_of(b.resources.begin(), b.resources.end(),
                       [&](const Resource& other) { return mine.kind == other.kind && mine.name == other.name; });
  });
}

bool makes(const Port& port, std::int64_t rate) {
  if (rate == 0) return true;
  if (rate < port.min_rate.value_or(0) || rate > port.max_rate.value_or(INT64_MAX)) return false;
  return port.rates.empty() || std::find(port.rates.begin(), port.rates.end(), rate) != port.rates.end();
}

/// All rates the port makes where these are few, else those that are usual for the kind.
std::vector<std::int64_t> usual_rates(const Port& port, BusKind kind) {
  if (has_few_rates(port, kind)) return rule_of(port, kind)->all(*port.clock_hz);
  const auto usual = bus_type(kind).rate.form->usual;
  return {usual.begin(), usual.end()};
}

}  // namespace

std::vector<std::int64_t> faster_rates(const Port& port, BusKind kind, std::int64_t least, const RateLimits& limits) {
  std::vector<std::int64_t> rates = limits.settings.empty() ? usual_rates(port, kind) : limits.settings.front();
  const std::optional<std::int64_t> top = limits.clock ? limits.clock : port.max_rate;
  if (limits.settings.empty() && bus_type(kind).rate.offers_fastest && top)
    rates.push_back(std::min(*top, port.max_rate.value_or(*top)));
  std::sort(rates.begin(), rates.end());
  rates.erase(std::unique(rates.begin(), rates.end()), rates.end());
  const auto serves = [&](std::int64_t rate) {
    return rate > least && rate <= limits.clock.value_or(rate) && makes(port, rate) &&
           std::all_of(limits.settings.begin(), limits.settings.end(), [&](const std::vector<std::int64_t>& known) {
             return std::find(known.begin(), known.end(), rate) != known.end();
           });
  };
  rates.erase(std::remove_if(rates.begin(), rates.end(), [&](std::int64_t rate) { return !serves(rate); }),
              rates.end());
  return rates;
}

std::string fastest_clock(const Port* port, BusKind kind, std::int64_t most) {
  const auto rates = port != nullptr ? faster_rates(*port, kind, 0, {most, {}}) : std::vector<std::int64_t>{};
  if (port != nullptr && rates.empty()) return {};
  return rate_text(kind, port == nullptr ? most : rates.back());
}

std::vector<std::string> free_ports(const Board& board, const std::vector<std::string>& used, BusKind kind) {
  std::vector<std::string> names;
  for (const Port& port : board.ports) {
    const bool is_taken = std::any_of(board.ports.begin(), board.ports.end(), [&](const Port& other) {
      return contains(used, other.name) && (other.name == port.name || meet(port, other));
    });
    if (port.serves(kind) && !is_taken) names.push_back(port.name);
  }
  return names;
}

std::string another_bus(const Board* board, const std::vector<std::string>& used, BusKind kind, std::int64_t rate) {
  if (board == nullptr) return {};
  for (const std::string& name : free_ports(*board, used, kind)) {
    if (!makes(*board->port(name), rate)) continue;
    const std::string_view attribute = rate_attribute(kind);
    const std::string written =
        rate == 0 || attribute.empty() ? std::string() : fmt::format(" {}=\"{}\"", attribute, rate_text(kind, rate));
    return fmt::format("<bus name=\"{}\" type=\"{}\" port=\"{}\"{}/>", name, bus_kind_name(kind), name, written);
  }
  return {};
}

std::vector<std::string> used_ports(const Robot& robot) {
  std::vector<std::string> names;
  for (const Bus& bus : robot.buses) {
    if (!bus.port.empty()) names.push_back(bus.port);
  }
  return names;
}

}  // namespace finemote::gen
