#include "generator/model/offers.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/bus/bus_kind.hpp"

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

/// SPI: its clock over powers of two from 2 to 256 (RM0090 28.5.1).
std::vector<std::int64_t> usual_rates(const Port& port, BusKind kind) {
  const std::string_view attribute = rate_attribute(kind);
  if (kind == BusKind::spi && port.clock_hz) {
    std::vector<std::int64_t> rates;
    for (int power = 1; power <= 8; ++power) rates.push_back(*port.clock_hz >> power);
    return rates;
  }
  if (attribute == "bitrate") return {125'000, 250'000, 500'000, 1'000'000};
  if (attribute == "clock") return {100'000, 400'000, 1'000'000, 2'000'000, 5'000'000, 10'000'000, 20'000'000};
  return {9'600, 19'200, 38'400, 57'600, 115'200, 230'400, 460'800, 921'600, 1'000'000, 2'000'000, 3'000'000};
}

}  // namespace

std::string_view rate_attribute(BusKind kind) {
  switch (kind) {
    case BusKind::uart:
    case BusKind::rs485:
      return "baud";
    case BusKind::i2c:
    case BusKind::spi:
      return "clock";
    case BusKind::can:
      return "bitrate";
    default:
      return {};
  }
}

std::string rate_text(BusKind kind, std::int64_t rate) {
  const std::string_view attribute = rate_attribute(kind);
  if (attribute == "baud") return fmt::format("{}baud", rate);
  const std::string_view unit = attribute == "clock" ? "Hz" : "bit/s";
  if (rate % 1'000'000 == 0) return fmt::format("{}M{}", rate / 1'000'000, unit);
  if (rate % 1'000 == 0) return fmt::format("{}k{}", rate / 1'000, unit);
  return fmt::format("{}{}", rate, unit);
}

std::vector<std::int64_t> faster_rates(const Port& port, BusKind kind, std::int64_t least, const RateLimits& limits) {
  std::vector<std::int64_t> rates = limits.settings.empty() ? usual_rates(port, kind) : limits.settings.front();
  const std::optional<std::int64_t> top = limits.clock ? limits.clock : port.max_rate;
  if (limits.settings.empty() && kind == BusKind::i2c && top)
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
    const bool serves = std::find(port.kinds.begin(), port.kinds.end(), kind) != port.kinds.end();
    const bool is_taken = std::any_of(board.ports.begin(), board.ports.end(), [&](const Port& other) {
      return contains(used, other.name) && (other.name == port.name || meet(port, other));
    });
    if (serves && !is_taken) names.push_back(port.name);
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
