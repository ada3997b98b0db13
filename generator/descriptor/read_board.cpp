#include "generator/descriptor/read_board.hpp"

#include <fmt/format.h>

#include "generator/bus/bus_kind.hpp"
#include "generator/descriptor/check_board.hpp"
#include "generator/descriptor/member.hpp"
#include "generator/descriptor/pin_name.hpp"
#include "generator/descriptor/read_param.hpp"

namespace finemote::gen {
namespace {

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
  return {value.at("name").get<std::string>(), value.at("line").get<std::uint32_t>()};
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

ForbiddenLine read_forbidden(const Json& value) {
  return {value.at("line").get<std::uint32_t>(), value.at("why").get<std::string>()};
}

SpareLine read_spare(const Json& value) {
  return {value.at("line").get<std::uint32_t>(), value.at("name").get<std::string>()};
}

Port read_port(const Json& value) {
  Port port;
  port.name = value.at("name").get<std::string>();
  port.silkscreen = optional_member<std::vector<std::string>>(value, "silkscreen").value_or(port.silkscreen);
  port.connector = optional_member<std::string>(value, "connector").value_or("");
  for (const Json& name : value.at("buses")) {
    if (const auto kind = bus_kind(name.get<std::string>())) port.kinds.push_back(*kind);
  }
  read_resources(value, port);
  port.channels = optional_member<std::uint32_t>(value, "channels").value_or(0);
  port.period = duration_member(value, "period_ns").value_or(port.period);
  port.clock_hz = optional_member<std::int64_t>(value, "clock_hz");
  if (const auto rule = optional_member<std::string>(value, "rate_rule")) port.rate_rule = rate_rule(*rule);
  port.min_rate = optional_member<std::int64_t>(value, "min_rate");
  port.max_rate = optional_member<std::int64_t>(value, "max_rate");
  port.drives = optional_member<std::string>(value, "drives").value_or("");
  port.has_inverter = optional_member<bool>(value, "inverter").value_or(false);
  port.rates = optional_member<std::vector<std::int64_t>>(value, "rates").value_or(port.rates);
  port.max_rate_error_ppm =
      optional_member<std::int64_t>(value, "max_rate_error_ppm").value_or(port.max_rate_error_ppm);
  return port;
}

NamedPin read_pin(const Json& value) {
  NamedPin pin;
  pin.name = value.at("name").get<std::string>();
  pin.pin = value.at("pin").get<std::string>();
  pin.functions = value.at("functions").get<std::vector<std::string>>();
  pin.active_low = value.at("active").get<std::string>() == "low";
  pin.summary = optional_member<std::string>(value, "summary").value_or("");
  if (const auto level = optional_member<std::string>(value, "rests")) pin.rests_high = *level == "high";
  if (const auto ready = value.find("data_ready"); ready != value.end() && ready->is_object())
    pin.data_ready = {ready->at("port").get<std::string>(), optional_member<std::uint32_t>(*ready, "channel")};
  if (const auto analog = value.find("analog"); analog != value.end() && analog->is_object()) {
    pin.converter = analog->at("converter").get<std::string>();
    pin.input = analog->at("input").get<std::uint32_t>();
    pin.full_scale_mv = analog->at("full_scale_mv").get<std::int64_t>();
  }
  return pin;
}

/// Index among the pins of a chip with ports A to I, 16 each.
int index_of(const PinName& pin) { return (pin.port - 'A') * 16 + static_cast<int>(pin.number); }

PinName pin_at(int index) { return {static_cast<char>('A' + index / 16), static_cast<std::uint32_t>(index % 16)}; }

/// `PA0-PA15` and `PD2`, one after the other; without a package PA0 to PI15.
std::vector<std::string> read_chip_pins(const Json& value) {
  std::vector<std::string> ranges{"PA0-PI15"};
  if (const auto package = value.find("package"); package != value.end() && package->is_object())
    ranges = package->at("gpio").get<std::vector<std::string>>();
  std::vector<std::string> pins;
  for (const std::string& range : ranges) {
    const std::size_t dash = range.find('-');
    const int first = index_of(pin_name(range.substr(0, dash)));
    const int last = dash == std::string::npos ? first : index_of(pin_name(range.substr(dash + 1)));
    for (int index = first; index <= last; ++index) pins.push_back(pin_at(index).text());
  }
  return pins;
}

Clocks read_clocks(const Json& value) {
  Clocks clocks;
  clocks.crystal_hz = value.at("crystal_hz").get<std::uint32_t>();
  const Json& pll = value.at("pll");
  clocks.pll_m = pll.at("m").get<std::uint32_t>();
  clocks.pll_n = pll.at("n").get<std::uint32_t>();
  clocks.pll_p = pll.at("p").get<std::uint32_t>();
  clocks.pll_q = pll.at("q").get<std::uint32_t>();
  clocks.apb1_hz = value.at("apb1_hz").get<std::uint32_t>();
  clocks.apb2_hz = value.at("apb2_hz").get<std::uint32_t>();
  clocks.flash_wait_states = value.at("flash_wait_states").get<std::uint32_t>();
  return clocks;
}

Memory read_memory(const Json& value) {
  return {value.at("name").get<std::string>(), value.at("origin").get<std::string>(),
          value.at("bytes").get<std::uint32_t>()};
}

ReservedPins read_reserved(const Json& value) {
  return {value.at("pins").get<std::vector<std::string>>(), value.at("for").get<std::string>(),
          optional_member<std::string>(value, "port").value_or("")};
}

Contact read_contact(const Json& value) {
  Contact contact;
  contact.number = value.at("at").get<std::string>();
  contact.pin = optional_member<std::string>(value, "pin").value_or("");
  contact.name = optional_member<std::string>(value, "is").value_or(contact.pin);
  contact.port = optional_member<std::string>(value, "port").value_or("");
  contact.volts = optional_member<double>(value, "volts");
  return contact;
}

Connector read_connector(const Json& value) {
  Connector connector;
  connector.name = value.at("name").get<std::string>();
  connector.remark = optional_member<std::string>(value, "remark").value_or("");
  connector.pins = optional_member<std::vector<std::string>>(value, "pins").value_or(connector.pins);
  connector.is_offered = optional_member<bool>(value, "offered").value_or(true);
  const auto lines = value.find("contacts");
  if (lines == value.end()) return connector;
  for (const Json& line : *lines) {
    std::vector<Contact>& contacts = connector.lines.emplace_back();
    for (const Json& contact : line) {
      contacts.push_back(read_contact(contact));
      if (!contacts.back().pin.empty()) connector.pins.push_back(contacts.back().pin);
    }
  }
  return connector;
}

}  // namespace

std::string DmaStream::name() const { return fmt::format("{} stream {}", upper(controller), stream); }

std::string InterruptLine::text() const { return fmt::format("{} (line {})", name, number); }

Board read_board(const Json& value, const Origin& origin, Diagnostics& diagnostics) {
  Board board;
  board.name = value.at("name").get<std::string>();
  board.summary = value.at("summary").get<std::string>();
  board.chip = value.at("chip").get<std::string>();
  board.stands_in = optional_member<bool>(value, "stands_in").value_or(false);
  board.is_emulated = optional_member<bool>(value, "emulated").value_or(false);
  board.is_suggested = optional_member<bool>(value, "suggested").value_or(false);
  if (const auto clocks = value.find("clocks"); clocks != value.end() && clocks->is_object())
    board.clocks = read_clocks(*clocks);
  board.memory = read_list<Memory>(value, "memory", read_memory);
  board.cpu_hz = value.at("cpu").at("clock_hz").get<std::int64_t>();
  board.clock_ppm = optional_member<std::int64_t>(value, "clock_ppm").value_or(board.clock_ppm);
  const Json& tick = value.at("tick");
  board.default_tick = nanoseconds(tick.at("default_ns").get<std::int64_t>());
  board.min_tick = nanoseconds(tick.at("min_ns").get<std::int64_t>());
  board.max_tick = nanoseconds(tick.at("max_ns").get<std::int64_t>());
  board.ports = read_list<Port>(value, "ports", read_port);
  board.pins = read_list<NamedPin>(value, "pins", read_pin);
  board.chip_pins = read_chip_pins(value);
  board.reserved_pins = read_list<ReservedPins>(value, "reserved_pins", read_reserved);
  board.connectors = read_list<Connector>(value, "connectors", read_connector);
  board.forbidden_lines = read_list<ForbiddenLine>(value, "forbidden_lines", read_forbidden);
  board.lines = read_list<SpareLine>(value, "spare_lines", read_spare);
  const Json& levels = value.at("priorities").at("buckets");
  board.first_bucket_level = levels.at(0).get<std::uint32_t>();
  board.last_bucket_level = levels.at(1).get<std::uint32_t>();
  board.params = read_params(value, origin, diagnostics);
  const Json& costs = value.at("costs");
  board.costs = read_costs(costs, CodePlace::flash);
  board.costs_in_sram = read_costs(costs, CodePlace::sram);
  board.drivers = read_drivers(value.at("drivers"));
  if (const auto analog = value.find("analog"); analog != value.end() && analog->is_object())
    board.analog_conversion = duration_member(*analog, "conversion_ns").value_or(Duration::zero());
  board.has_watchdog = optional_member<Json>(value, "watchdog").has_value();
  check_board(board, origin, diagnostics);
  return board;
}

}  // namespace finemote::gen
