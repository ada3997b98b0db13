#include "generator/descriptor/check_board.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "generator/bus/bus_type.hpp"
#include "generator/descriptor/check_clocks.hpp"
#include "generator/descriptor/contradictions.hpp"
#include "generator/descriptor/runtime_limits.hpp"
#include "generator/descriptor/whole_cycles.hpp"
#include "generator/units/units.hpp"

namespace finemote::gen {
namespace {

class BoardCheck {
 public:
  BoardCheck(const Origin& origin, Diagnostics& diagnostics) : found_(origin, diagnostics) {}

  void check(const Board& board) {
    check_port_names(board);
    check_rates(board);
    check_drivers(board);
    check_lines(board);
    check_line_words(board);
    check_levels(board);
    check_clocks(board, found_);
    check_tick(board);
    check_pulses(board);
    check_pins(board);
  }

 private:
  void contradiction(const JsonPath& path, std::string message) { found_.add(path, std::move(message)); }
  void check_port_names(const Board& board) {
    std::set<std::string> seen;
    for (std::size_t i = 0; i < board.ports.size(); ++i) {
      const std::string& name = board.ports[i].name;
      if (!seen.insert(name).second)
        contradiction({"ports", std::to_string(i), "name"}, fmt::format("there are two ports '{}'", name));
    }
  }
  void check_rates(const Board& board) {
    for (std::size_t i = 0; i < board.ports.size(); ++i) {
      const Port& port = board.ports[i];
      if (port.min_rate.value_or(0) > port.max_rate.value_or(INT64_MAX)) {
        contradiction({"ports", std::to_string(i), "max_rate"},
                      fmt::format("port '{}': max_rate is below min_rate", port.name));
      }
      for (std::size_t k = 0; k < port.rates.size(); ++k) {
        if (port.rates[k] < port.min_rate.value_or(0) || port.rates[k] > port.max_rate.value_or(INT64_MAX)) {
          contradiction({"ports", std::to_string(i), "rates", std::to_string(k)},
                        fmt::format("port '{}': the rate is not from min_rate to max_rate", port.name));
        }
      }
    }
  }
  /// What serves a kind of bus on a port: its driver, its interrupts and a rule for its rates.
  void check_drivers(const Board& board) {
    std::set<BusKind> missing;
    for (std::size_t i = 0; i < board.ports.size(); ++i) {
      const Port& port = board.ports[i];
      const std::string index = std::to_string(i);
      for (std::size_t k = 0; k < port.kinds.size(); ++k) {
        const BusType& bus = bus_type(port.kinds[k]);
        const JsonPath path{"ports", index, "buses", std::to_string(k)};
        if (board.driver(bus.kind) == nullptr && missing.insert(bus.kind).second)
          contradiction(path, fmt::format("\"drivers\" has no '{}'", bus.name));
        if (bus.unit != nullptr && port.interrupts.empty())
          contradiction({"ports", index, "interrupts"},
                        fmt::format("the driver of '{}' needs the interrupts of the port", bus.name));
        const auto* rule = port.rate_rule;
        if (rule != nullptr && std::find(rule->kinds.begin(), rule->kinds.end(), bus.kind) == rule->kinds.end())
          contradiction({"ports", index, "rate_rule"}, fmt::format("'{}' is no rule for {}", rule->name, bus.name));
      }
    }
  }
  /// A line buckets may use can be neither forbidden nor an interrupt of a port.
  void check_lines(const Board& board) {
    std::map<std::uint32_t, std::string> taken;
    for (const ForbiddenLine& line : board.forbidden_lines) taken[line.number] = "is forbidden: " + line.why;
    for (const Port& port : board.ports) {
      for (const InterruptLine& interrupt : port.interrupts)
        taken[interrupt.number] = fmt::format("is the interrupt {} of port '{}'", interrupt.name, port.name);
    }
    for (std::size_t i = 0; i < board.lines.size(); ++i) {
      const std::uint32_t number = board.lines[i].number;
      const auto found = taken.find(number);
      if (found != taken.end())
        contradiction({"spare_lines", std::to_string(i), "line"}, fmt::format("line {} {}", number, found->second));
      taken[number] = "is listed twice";
    }
  }
  void check_levels(const Board& board) {
    if (board.first_bucket_level > board.last_bucket_level)
      contradiction({"priorities", "buckets", "1"}, "the last level for buckets is below the first");
    if (board.first_bucket_level <= runtime_limits::kReleaseLevel)
      contradiction({"priorities", "buckets", "0"},
                    fmt::format("buckets need levels above {}, which is the release's: they would keep it out",
                                runtime_limits::kReleaseLevel));
  }

  /// One store to a register of the interrupt controller, which has 32 lines, releases all buckets of an instant.
  void check_line_words(const Board& board) {
    for (std::size_t i = 0; i < board.lines.size(); ++i) {
      const std::uint32_t line = board.lines[i].number, first = board.lines.front().number;
      if (line / 32 != first / 32) {
        contradiction({"spare_lines", std::to_string(i), "line"},
                      fmt::format("lines {} and {} are not in one register of 32 lines", first, line));
        break;
      }
    }
    if (board.lines.size() > runtime_limits::kBuckets) {
      contradiction({"spare_lines"}, fmt::format("{} lines; the scheduler has room for {} buckets", board.lines.size(),
                                                 runtime_limits::kBuckets));
    }
  }
  void check_default_tick(const Board& board) {
    if (is_whole_cycles(board, board.default_tick)) return;
    found_
        .add(found_.nearest({"tick", "default_ns"}, {"cpu", "clock_hz"}),
             fmt::format("the default tick of {} is not a whole number of CPU cycles",
                         units::format_duration(board.default_tick)))
        .note(fmt::format("the core runs at {} Hz; releases would drift", board.cpu_hz))
        .hint(fmt::format("the next longer one that is: \"default_ns\": {}",
                          whole_tick_above(board, board.default_tick).ns()));
  }
  void check_tick(const Board& board) {
    check_default_tick(board);
    if (board.min_tick > board.max_tick) contradiction({"tick", "max_ns"}, "the longest tick is below the shortest");
    if (board.default_tick < board.min_tick || board.default_tick > board.max_tick)
      contradiction({"tick", "default_ns"}, "the default is not from min_ns to max_ns");
    const auto cycles = static_cast<double>(board.max_tick.ns()) * static_cast<double>(board.cpu_hz) / 1e9;
    if (cycles > static_cast<double>(runtime_limits::kTickCycles)) {
      contradiction({"tick", "max_ns"},
                    fmt::format("the release timer counts {} core cycles at most", runtime_limits::kTickCycles));
    }
  }
  /// How often pulses repeat: in the range of the driver, and one period for all outputs of a timer.
  void check_pulses(const Board& board) {
    std::map<std::string, const Port*> timers;
    for (std::size_t i = 0; i < board.ports.size(); ++i) {
      const Port& port = board.ports[i];
      const JsonPath path{"ports", std::to_string(i), "period_ns"};
      if (port.period < runtime_limits::kShortestPwmPeriod || port.period > runtime_limits::kLongestPwmPeriod)
        contradiction(path, fmt::format("port '{}': pulses repeat every {} to {}", port.name,
                                        units::spaced_duration(runtime_limits::kShortestPwmPeriod),
                                        units::spaced_duration(runtime_limits::kLongestPwmPeriod)));
      if (!port.timer) continue;
      const Port& first = *timers.emplace(port.timer->timer, &port).first->second;
      if (first.period != port.period) {
        contradiction(path,
                      fmt::format("ports '{}' and '{}' share a timer and need one period", first.name, port.name));
      }
    }
  }

  void check_pin(const Board& board, const JsonPath& path, const std::string& pin) {
    if (std::find(board.chip_pins.begin(), board.chip_pins.end(), pin) == board.chip_pins.end())
      contradiction(path, fmt::format("the package has no pin '{}'", pin));
  }
  void check_pin_list(const Board& board, const char* list, std::size_t index, const std::vector<std::string>& pins) {
    for (std::size_t i = 0; i < pins.size(); ++i)
      check_pin(board, {list, std::to_string(index), "pins", std::to_string(i)}, pins[i]);
  }
  void check_contacts(const Board& board, std::size_t connector) {
    const auto& lines = board.connectors[connector].lines;
    for (std::size_t line = 0; line < lines.size(); ++line) {
      for (std::size_t i = 0; i < lines[line].size(); ++i) {
        if (lines[line][i].pin.empty()) continue;
        check_pin(board,
                  {"connectors", std::to_string(connector), "contacts", std::to_string(line), std::to_string(i), "pin"},
                  lines[line][i].pin);
      }
    }
  }
  /// Pins that reserved_pins, connectors and pins name are there.
  void check_pins(const Board& board) {
    if (board.chip_pins.empty())
      return contradiction({"package", "gpio"}, "the package has no pins: each range ends before it begins");
    for (std::size_t i = 0; i < board.pins.size(); ++i)
      check_pin(board, {"pins", std::to_string(i), "pin"}, board.pins[i].pin);
    for (std::size_t i = 0; i < board.connectors.size(); ++i) {
      if (board.connectors[i].lines.empty()) check_pin_list(board, "connectors", i, board.connectors[i].pins);
      check_contacts(board, i);
    }
    for (std::size_t i = 0; i < board.reserved_pins.size(); ++i)
      check_pin_list(board, "reserved_pins", i, board.reserved_pins[i].pins);
  }

  Contradictions found_;
};

}  // namespace

void check_board(const Board& board, const Origin& origin, Diagnostics& diagnostics) {
  BoardCheck(origin, diagnostics).check(board);
}

}  // namespace finemote::gen
