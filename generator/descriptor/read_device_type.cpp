#include "generator/descriptor/read_device_type.hpp"

#include <algorithm>
#include <iterator>
#include <tuple>
#include <utility>

#include "generator/bus/bus_kind.hpp"
#include "generator/descriptor/check_device_type.hpp"
#include "generator/descriptor/member.hpp"
#include "generator/descriptor/read_param.hpp"
#include "generator/units/units.hpp"

namespace finemote::gen {
namespace {

std::vector<BusKind> read_kinds(const Json& names) {
  std::vector<BusKind> kinds;
  for (const Json& name : names) {
    if (const auto kind = bus_kind(name.get<std::string>())) kinds.push_back(*kind);
  }
  return kinds;
}

Interface read_interface(const Json& value) {
  Interface interface;
  interface.name = value.at("interface").get<std::string>();
  interface.cpp = interface.name.find("::") == std::string::npos ? "finemote::" + interface.name : interface.name;
  interface.has_command = value.value("command", false);
  interface.state = value.value("state_member", "state");
  interface.command = value.value("command_member", "command");
  interface.fields = {read_link_fields(value, "state_fields"), read_link_fields(value, "command_fields")};
  return interface;
}

RoleSpec read_role(const Json& value) {
  return {value.at("name").get<std::string>(),
          value.at("interface").get<std::string>(),
          value.value("min", 0U),
          optional_member<std::uint32_t>(value, "max"),
          value.value("passes", true),
          value.value("summary", std::string())};
}

UseSpec read_use(const Json& value) {
  return {value.at("name").get<std::string>(),
          read_kinds(value.at("types")),
          value.value("min", 0) > 0,
          value.value("format", "8N1"),
          value.value("function", "input"),
          optional_member<std::uint32_t>(value, "mode"),
          value.value("data_ready_of", std::string()),
          value.value("summary", std::string())};
}

using Index = std::optional<std::uint32_t>;

std::pair<Index, Index> read_index_range(const Json& value) {
  return {optional_member<std::uint32_t>(value, "min"), optional_member<std::uint32_t>(value, "max")};
}

void read_bus(const Json& bus, DeviceType& type) {
  type.buses = read_kinds(bus.at("types"));
  type.bus_required = bus.value("required", true);
  if (const auto address = bus.find("address"); address != bus.end()) {
    type.needs_address = true;
    if (const auto fallback = optional_member<std::string>(*address, "default"))
      type.default_address = parse_hex(*fallback);
    type.addresses = read_addresses(*address);
  }
  if (const auto channel = bus.find("channel"); channel != bus.end()) {
    type.needs_channel = true;
    std::tie(type.channel_min, type.channel_max) = read_index_range(*channel);
  }
  if (const auto id = bus.find("id"); id != bus.end()) {
    type.needs_id = true;
    std::tie(type.id_min, type.id_max) = read_index_range(*id);
  }
  if (const auto receives = bus.find("receives"); receives != bus.end()) type.receives = read_identifiers(*receives);
  type.format = bus.value("format", "8N1");
  if (const auto rates = bus.find("rates"); rates != bus.end()) type.rates = rates->get<std::vector<std::int64_t>>();
  type.max_clock_hz = optional_member<std::int64_t>(bus, "max_clock_hz");
  type.spi_mode = bus.value("mode", kUsualSpiMode);
  type.tunes = bus.value("tunes", false);
}

std::optional<WcetDefault> read_wcet(const Json& value) {
  const auto wcet = value.find("wcet");
  if (wcet == value.end()) return {};
  WcetDefault result;
  result.update = nanoseconds(wcet->at("update_ns").get<std::int64_t>());
  result.handle = nanoseconds(wcet->at("handle_ns").get<std::int64_t>());
  if (const auto params = wcet->find("update_params"); params != wcet->end())
    result.update_params = params->get<std::vector<std::string>>();
  if (const auto params = wcet->find("handle_params"); params != wcet->end())
    result.handle_params = params->get<std::vector<std::string>>();
  result.per_frame = duration_member(*wcet, "per_frame_ns").value_or(Duration::zero());
  const Duration per_child = duration_member(*wcet, "per_child_ns").value_or(Duration::zero());
  result.update_per_child = duration_member(*wcet, "update_per_child_ns").value_or(per_child);
  result.handle_per_child = duration_member(*wcet, "handle_per_child_ns").value_or(per_child);
  return result;
}

GeometrySpec read_geometry(const Json& entry) {
  GeometrySpec spec;
  spec.kind = entry.at("kind").get<std::string>();
  spec.role = entry.value("role", std::string());
  spec.optional = entry.value("optional", false);
  spec.replaces = entry.value("replaces", std::vector<std::string>());
  spec.tolerance_deg = entry.value("tolerance", spec.tolerance_deg);
  spec.commands = entry.value("commands", std::vector<std::string>());
  spec.along = entry.value("along", std::string());
  spec.behind = entry.value("behind", std::string());
  spec.param = entry.value(param_member(spec.kind), std::string());
  spec.carries = entry.value("carries", std::string());
  spec.lowest = entry.value("lowest", std::string());
  spec.highest = entry.value("highest", std::string());
  return spec;
}

/// A frame for every id is one for the ids of the type.
void bound_ids(const DeviceType& type, Frame& frame) {
  for (SharedFrame& shared : frame.shared) {
    if (shared.id_max != UINT32_MAX) continue;
    shared.id_min = type.id_min.value_or(0);
    shared.id_max = type.id_max.value_or(shared.id_min);
  }
}

}  // namespace

std::optional<SharedFrame> DeviceType::shared_frame(std::uint32_t id) const {
  if (!frames) return {};
  for (const Frame& frame : *frames) {
    for (const SharedFrame& shared : frame.shared) {
      if (shared.holds(id)) return shared;
    }
  }
  return {};
}

std::vector<Frame> DeviceType::frames_over(std::string_view role) const {
  std::vector<Frame> over;
  if (!frames) return over;
  std::copy_if(frames->begin(), frames->end(), std::back_inserter(over),
               [&](const Frame& frame) { return frame.use == role; });
  return over;
}

const std::vector<BusKind>& DeviceType::buses_of(const Frame& frame) const {
  const auto use = std::find_if(uses.begin(), uses.end(), [&](const UseSpec& each) { return each.role == frame.use; });
  return use != uses.end() ? use->buses : buses;
}

bool DeviceType::says_interval_of(const Frame& frame) const {
  return frame.min_interval || (acquisition && (acquisition->interval || !acquisition->interval_param.empty()));
}

std::vector<IdentifierRange> DeviceType::received(std::uint32_t id) const {
  std::vector<IdentifierRange> ranges;
  for (const Identifiers& entry : receives) ranges.push_back(entry.of(id));
  return ranges;
}

const char* param_member(const std::string& kind) {
  if (kind == "rolling") return "radius";
  return kind == "chain" ? "share" : "travel";
}

std::uint32_t parse_hex(const std::string& text) {
  const auto parsed = units::parse_bare(text);
  return parsed ? *parsed : 0;
}

std::vector<std::uint32_t> read_addresses(const Json& address) {
  std::vector<std::uint32_t> allowed;
  const auto list = address.find("allowed");
  if (list == address.end()) return allowed;
  for (const Json& entry : *list) allowed.push_back(parse_hex(entry.get<std::string>()));
  return allowed;
}

std::string include_name(const std::string& header) {
  constexpr std::string_view kShipped = "runtime/include/";
  const std::size_t at = header.rfind(kShipped);
  if (at != std::string::npos) return header.substr(at + kShipped.size());
  const std::size_t slash = header.rfind('/');
  return slash == std::string::npos ? header : header.substr(slash + 1);
}

DeviceType read_device_type(const Json& value, const Origin& origin, Diagnostics& diagnostics) {
  DeviceType type;
  type.name = value.at("type").get<std::string>();
  type.summary = value.at("summary").get<std::string>();
  type.cpp_class = value.at("class").get<std::string>();
  type.header = value.at("header").get<std::string>();
  type.include = include_name(type.header);
  if (const auto bus = value.find("bus"); bus != value.end()) read_bus(*bus, type);
  type.provides = read_list<Interface>(value, "provides", read_interface);
  type.roles = read_list<RoleSpec>(value, "roles", read_role);
  type.uses = read_list<UseSpec>(value, "uses", read_use);
  type.params = read_params(value, origin, diagnostics);
  type.geometry = read_list<GeometrySpec>(value, "geometry", read_geometry);
  if (const auto link = value.find("link"); link != value.end()) type.link_role = link->at("role").get<std::string>();
  type.actuator = value.value("actuator", false);
  type.bring_up = duration_member(value, "bring_up_ns").value_or(type.bring_up);
  type.constant_init = value.value("constant_init", true);
  type.wcet = read_wcet(value);
  if (const auto it = value.find("acquisition"); it != value.end()) type.acquisition = read_acquisition(*it);
  if (const auto it = value.find("frames"); it != value.end()) {
    type.frames = read_frames(*it);
    for (Frame& frame : *type.frames) bound_ids(type, frame);
  }
  type.interrupts = read_list<Interrupt>(value, "interrupts", read_interrupt);
  if (const auto it = value.find("emulation"); it != value.end()) type.emulation = read_emulation(*it);
  check_device_type(type, origin, diagnostics);
  return type;
}

}  // namespace finemote::gen
