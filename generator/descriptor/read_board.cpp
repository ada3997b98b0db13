#include "generator/descriptor/read_board.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "generator/descriptor/bus_kind.hpp"
#include "generator/descriptor/member.hpp"
#include "generator/descriptor/read_param.hpp"
#include "generator/descriptor/runtime_limits.hpp"

namespace finemote::gen {
namespace {

const Json& array_member(const Json& value, const char* key) {
  static const Json none = Json::array();
  const auto found = value.find(key);
  return found == value.end() || !found->is_array() ? none : *found;
}

std::string upper(std::string text) {
  for (char& c : text) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  }
  return text;
}

PortPin read_port_pin(const Json& value) {
  return {value.at("pin").get<std::string>(), value.at("signal").get<std::string>(), value.at("af").get<int>()};
}

DmaStream read_dma(const Json& value) {
  return {value.at("signal").get<std::string>(), value.at("controller").get<std::string>(),
          value.at("stream").get<int>(), value.at("channel").get<int>()};
}

InterruptLine read_line(const Json& value) {
  return {value.at("name").get<std::string>(), value.at("line").get<int>()};
}

void read_resources(const Json& value, Port& port) {
  port.pins = read_list<PortPin>(value, "pins", read_port_pin);
  port.dma = read_list<DmaStream>(value, "dma", read_dma);
  port.interrupts = read_list<InterruptLine>(value, "interrupts", read_line);
  const auto timer = value.find("timer");
  if (timer != value.end() && timer->is_object())
    port.timer = {upper(timer->at("name").get<std::string>()), timer->at("channel").get<int>()};
  port.selects = optional_member<std::vector<std::string>>(value, "selects").value_or(port.selects);
  for (const PortPin& pin : port.pins) port.resources.push_back({"pin", pin.pin});
  for (const std::string& pin : port.selects) port.resources.push_back({"pin", pin});
  for (const DmaStream& stream : port.dma) port.resources.push_back({"DMA stream", stream.name()});
  if (port.timer) {
    port.resources.push_back({"timer channel", fmt::format("{} channel {}", port.timer->timer, port.timer->channel)});
  }
  for (const InterruptLine& line : port.interrupts) port.resources.push_back({"interrupt", line.text()});
}

Port read_port(const Json& value) {
  Port port;
  port.name = value.at("name").get<std::string>();
  for (const Json& label : array_member(value, "silkscreen")) port.silkscreen.push_back(label.get<std::string>());
  port.connector = optional_member<std::string>(value, "connector").value_or("");
  for (const Json& name : value.at("buses")) {
    if (const auto kind = bus_kind(name.get<std::string>())) port.kinds.push_back(*kind);
  }
  read_resources(value, port);
  port.channels = optional_member<std::uint32_t>(value, "channels").value_or(0);
  port.period_ns = optional_member<std::int64_t>(value, "period_ns").value_or(port.period_ns);
  port.clock_hz = optional_member<std::int64_t>(value, "clock_hz");
  port.min_rate = optional_member<std::int64_t>(value, "min_rate");
  port.max_rate = optional_member<std::int64_t>(value, "max_rate");
  port.drives = optional_member<std::string>(value, "drives").value_or("");
  port.has_inverter = optional_member<bool>(value, "inverter").value_or(false);
  for (const Json& rate : array_member(value, "rates")) port.rates.push_back(rate.get<std::int64_t>());
  port.max_rate_error_ppm =
      optional_member<std::int64_t>(value, "max_rate_error_ppm").value_or(port.max_rate_error_ppm);
  return port;
}

NamedPin read_pin(const Json& value) {
  NamedPin pin;
  pin.name = value.at("name").get<std::string>();
  pin.pin = value.at("pin").get<std::string>();
  for (const Json& function : value.at("functions")) pin.functions.push_back(function.get<std::string>());
  pin.active_low = value.at("active").get<std::string>() == "low";
  pin.summary = optional_member<std::string>(value, "summary").value_or("");
  if (const auto ready = value.find("data_ready"); ready != value.end() && ready->is_object())
    pin.data_ready = {ready->at("port").get<std::string>(), optional_member<std::uint32_t>(*ready, "channel")};
  if (const auto analog = value.find("analog"); analog != value.end() && analog->is_object()) {
    pin.converter = analog->at("converter").get<std::string>();
    pin.input = analog->at("input").get<std::uint32_t>();
    pin.full_scale_mv = analog->at("full_scale_mv").get<std::int64_t>();
  }
  return pin;
}

/// Index of `PA13` among the pins of a chip with ports A to I, 16 each.
int pin_index(const std::string& pin) { return (pin.at(1) - 'A') * 16 + std::stoi(pin.substr(2)); }

/// `PA0-PA15` and `PD2`, one after the other; without a package PA0 to PI15.
std::vector<std::string> read_chip_pins(const Json& value) {
  std::vector<std::string> ranges{"PA0-PI15"};
  if (const auto package = value.find("package"); package != value.end() && package->is_object())
    ranges = package->at("gpio").get<std::vector<std::string>>();
  std::vector<std::string> pins;
  for (const std::string& range : ranges) {
    const std::size_t dash = range.find('-');
    const int last = pin_index(dash == std::string::npos ? range : range.substr(dash + 1));
    for (int index = pin_index(range.substr(0, dash)); index <= last; ++index)
      pins.push_back(fmt::format("P{}{}", static_cast<char>('A' + index / 16), index % 16));
  }
  return pins;
}

ReservedPins read_reserved(const Json& value) {
  return {value.at("pins").get<std::vector<std::string>>(), value.at("for").get<std::string>(),
          optional_member<std::string>(value, "port").value_or("")};
}

Connector read_connector(const Json& value) {
  return {value.at("name").get<std::string>(), value.at("pins").get<std::vector<std::string>>(),
          optional_member<bool>(value, "offered").value_or(true)};
}

/// Reports what no schema can see.
class BoardCheck {
 public:
  BoardCheck(const SourceFile& source, Diagnostics& diagnostics) : source_(source), diagnostics_(diagnostics) {}

  void check(const Json& value, const Board& board) {
    check_port_names(board);
    check_rates(board);
    check_lines(value, board);
    check_line_words(board);
    check_levels(board);
    check_tick(board);
    check_pulses(value, board);
    check_pins(board);
  }

 private:
  void contradiction(const JsonPath& path, std::string message) {
    const Extent extent = find_value(source_, path);
    diagnostics_.error(code::descriptor_contradiction, extent.at, std::move(message)).underline(extent.length);
  }
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
    }
  }
  /// A line buckets may use can be neither forbidden nor an interrupt of a port.
  void check_lines(const Json& value, const Board& board) {
    std::map<int, std::string> taken;
    for (const Json& line : array_member(value, "forbidden_lines"))
      taken[line.at("line").get<int>()] = "is forbidden: " + line.at("why").get<std::string>();
    for (const Json& port : value.at("ports")) {
      for (const Json& interrupt : array_member(port, "interrupts")) {
        taken[interrupt.at("line").get<int>()] = "is the interrupt " + interrupt.at("name").get<std::string>() +
                                                 " of port '" + port.at("name").get<std::string>() + "'";
      }
    }
    for (std::size_t i = 0; i < board.lines.size(); ++i) {
      const int number = static_cast<int>(board.lines[i].number);
      const auto found = taken.find(number);
      if (found != taken.end())
        contradiction({"spare_lines", std::to_string(i), "line"}, fmt::format("line {} {}", number, found->second));
      taken[number] = "is listed twice";
    }
  }
  void check_levels(const Board& board) {
    if (board.first_bucket_level > board.last_bucket_level)
      contradiction({"priorities", "buckets"}, "the last level for buckets is below the first");
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
  void check_tick(const Board& board) {
    const auto cycles = static_cast<double>(board.max_tick_ns) * static_cast<double>(board.cpu_hz) / 1e9;
    if (cycles > static_cast<double>(runtime_limits::kTickCycles)) {
      contradiction({"tick", "max_ns"},
                    fmt::format("the release timer counts {} core cycles at most", runtime_limits::kTickCycles));
    }
  }
  /// How often pulses repeat: in the range of the driver, and one period for all outputs of a timer.
  void check_pulses(const Json& value, const Board& board) {
    std::map<std::string, const Port*> timers;
    for (std::size_t i = 0; i < board.ports.size(); ++i) {
      const Port& port = board.ports[i];
      const JsonPath path{"ports", std::to_string(i), "period_ns"};
      if (port.period_ns < runtime_limits::kShortestPwmPeriod || port.period_ns > runtime_limits::kLongestPwmPeriod)
        contradiction(path, fmt::format("port '{}': pulses repeat every 1 us to 400 ms", port.name));
      const auto timer = value.at("ports").at(i).find("timer");
      if (timer == value.at("ports").at(i).end() || !timer->is_object()) continue;
      const Port& first = *timers.emplace(timer->at("name").get<std::string>(), &port).first->second;
      if (first.period_ns != port.period_ns) {
        contradiction(path,
                      fmt::format("ports '{}' and '{}' share a timer and need one period", first.name, port.name));
      }
    }
  }

  /// Pins that reserved_pins, connectors and pins name are there.
  void check_pins(const Board& board) {
    const auto check = [&](const JsonPath& path, const std::string& pin) {
      if (std::find(board.chip_pins.begin(), board.chip_pins.end(), pin) == board.chip_pins.end())
        contradiction(path, fmt::format("the package has no pin '{}'", pin));
    };
    for (std::size_t i = 0; i < board.pins.size(); ++i) check({"pins", std::to_string(i), "pin"}, board.pins[i].pin);
    for (std::size_t i = 0; i < board.connectors.size(); ++i) {
      for (const std::string& pin : board.connectors[i].pins) check({"connectors", std::to_string(i), "pins"}, pin);
    }
    for (std::size_t i = 0; i < board.reserved_pins.size(); ++i) {
      for (const std::string& pin : board.reserved_pins[i].pins)
        check({"reserved_pins", std::to_string(i), "pins"}, pin);
    }
  }

  const SourceFile& source_;
  Diagnostics& diagnostics_;
};

}  // namespace

std::string DmaStream::name() const { return fmt::format("{} stream {}", upper(controller), stream); }

std::string InterruptLine::text() const { return fmt::format("{} (line {})", name, number); }

Board read_board(const Json& value, const SourceFile& source, Diagnostics& diagnostics) {
  Board board;
  board.name = value.at("name").get<std::string>();
  board.summary = value.at("summary").get<std::string>();
  board.cpu_hz = value.at("cpu").at("clock_hz").get<std::int64_t>();
  const Json& tick = value.at("tick");
  board.default_tick_ns = tick.at("default_ns").get<std::int64_t>();
  board.min_tick_ns = tick.at("min_ns").get<std::int64_t>();
  board.max_tick_ns = tick.at("max_ns").get<std::int64_t>();
  for (const Json& port : value.at("ports")) board.ports.push_back(read_port(port));
  for (const Json& pin : array_member(value, "pins")) board.pins.push_back(read_pin(pin));
  board.chip_pins = read_chip_pins(value);
  for (const Json& pins : array_member(value, "reserved_pins")) board.reserved_pins.push_back(read_reserved(pins));
  for (const Json& connector : array_member(value, "connectors")) board.connectors.push_back(read_connector(connector));
  for (const Json& line : value.at("spare_lines"))
    board.lines.push_back({line.at("line").get<std::uint32_t>(), line.at("name").get<std::string>()});
  const Json& levels = value.at("priorities").at("buckets");
  board.first_bucket_level = levels.at(0).get<std::uint32_t>();
  board.last_bucket_level = levels.at(1).get<std::uint32_t>();
  board.params = read_params(value, source, diagnostics);
  board.costs = read_costs(value.at("costs"));
  board.drivers = read_drivers(value.at("drivers"));
  board.has_watchdog = optional_member<Json>(value, "watchdog").has_value();
  BoardCheck(source, diagnostics).check(value, board);
  return board;
}

}  // namespace finemote::gen
