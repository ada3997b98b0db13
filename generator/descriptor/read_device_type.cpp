#include "generator/descriptor/read_device_type.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "generator/descriptor/bus_kind.hpp"
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

std::vector<std::uint32_t> read_addresses(const Json& address) {
  std::vector<std::uint32_t> allowed;
  const auto list = address.find("allowed");
  if (list == address.end()) return allowed;
  for (const Json& entry : *list) allowed.push_back(parse_hex(entry.get<std::string>()));
  return allowed;
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
    type.channel_min = optional_member<std::uint32_t>(*channel, "min");
    type.channel_max = optional_member<std::uint32_t>(*channel, "max");
  }
  if (const auto id = bus.find("id"); id != bus.end()) {
    type.needs_id = true;
    type.id_min = optional_member<std::uint32_t>(*id, "min");
    type.id_max = optional_member<std::uint32_t>(*id, "max");
  }
  if (const auto receives = bus.find("receives"); receives != bus.end())
    type.receives_base = receives->at("base").get<std::uint32_t>();
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
  result.update_ns = wcet->at("update_ns").get<std::int64_t>();
  result.handle_ns = wcet->at("handle_ns").get<std::int64_t>();
  if (const auto params = wcet->find("update_params"); params != wcet->end())
    result.update_params = params->get<std::vector<std::string>>();
  if (const auto params = wcet->find("handle_params"); params != wcet->end())
    result.handle_params = params->get<std::vector<std::string>>();
  result.per_child_ns = wcet->value("per_child_ns", std::int64_t{0});
  return result;
}

/// What a kind calls the one param it may name.
const char* param_member(const std::string& kind) {
  if (kind == "rolling") return "radius";
  return kind == "chain" ? "share" : "travel";
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

RepeatSpec read_repeats(const Json& value) {
  return {value.at("frequency").get<std::string>(), value.at("clock").get<std::string>(),
          value.at("counts").get<std::int64_t>(), value.at("dividers").at(0).get<std::int64_t>(),
          value.at("dividers").at(1).get<std::int64_t>()};
}

/// Reports what no schema can see.
class DescriptorCheck {
 public:
  DescriptorCheck(const SourceFile& source, Diagnostics& diagnostics) : source_(source), diagnostics_(diagnostics) {}

  void check(const Json& value, const DeviceType& type) {
    check_names(value, "roles", "name", "role");
    check_names(value, "uses", "name", "use");
    check_names(value, "provides", "interface", "interface");
    for (std::size_t i = 0; i < type.roles.size(); ++i) check_arity(type.roles[i], i);
    for (std::size_t i = 0; i < type.uses.size(); ++i) check_data_ready(type, i);
    for (std::size_t i = 0; i < type.geometry.size(); ++i) check_geometry(type, i);
    if (!type.link_role.empty()) check_link(type);
    if (type.wcet) check_wcet(type);
    check_bus(value, type);
  }

 private:
  void contradiction(const JsonPath& path, std::string message) {
    const Extent extent = find_value(source_, path);
    diagnostics_.error(code::descriptor_contradiction, extent.at, std::move(message)).underline(extent.length);
  }
  void check_names(const Json& value, const std::string& list, const char* key, const char* what) {
    const auto entries = value.find(list);
    if (entries == value.end()) return;
    std::set<std::string> seen;
    for (std::size_t i = 0; i < entries->size(); ++i) {
      const auto name = entries->at(i).at(key).get<std::string>();
      if (!seen.insert(name).second)
        contradiction({list, std::to_string(i), key}, fmt::format("there are two {}s '{}'", what, name));
    }
  }
  void check_arity(const RoleSpec& role, std::size_t index) {
    if (role.max && *role.max < role.min) {
      contradiction({"roles", std::to_string(index), "max"},
                    fmt::format("role '{}': max {} is below min {}", role.name, *role.max, role.min));
    }
  }
  void check_data_ready(const DeviceType& type, std::size_t index) {
    const std::string& name = type.uses[index].data_ready_of;
    const bool exists = std::any_of(type.uses.begin(), type.uses.end(), [&](const UseSpec& use) {
      return use.role == name && use.role != type.uses[index].role;
    });
    if (!name.empty() && name != kDeviceItself && !exists)
      contradiction({"uses", std::to_string(index), "data_ready_of"}, fmt::format("there is no other use '{}'", name));
  }
  void check_geometry(const DeviceType& type, std::size_t index) {
    const GeometrySpec& geometry = type.geometry[index];
    const std::string entry = std::to_string(index);
    check_role_named(type, geometry.role, {"geometry", entry, "role"});
    check_role_named(type, geometry.behind, {"geometry", entry, "behind"});
    check_role_named(type, geometry.carries, {"geometry", entry, "carries"});
    for (std::size_t i = 0; i < geometry.replaces.size(); ++i)
      check_param_named(type, geometry.replaces[i], false, {"geometry", entry, "replaces", std::to_string(i)});
    check_param_named(type, geometry.param, true, {"geometry", entry, param_member(geometry.kind)});
    check_param_named(type, geometry.lowest, true, {"geometry", entry, "lowest"});
    check_param_named(type, geometry.highest, true, {"geometry", entry, "highest"});
  }
  void check_role_named(const DeviceType& type, const std::string& name, const JsonPath& path) {
    const bool exists =
        std::any_of(type.roles.begin(), type.roles.end(), [&](const RoleSpec& role) { return role.name == name; });
    if (!name.empty() && !exists) contradiction(path, fmt::format("there is no role '{}'", name));
  }
  void check_param_named(const DeviceType& type, const std::string& name, bool is_real, const JsonPath& path) {
    const auto found =
        std::find_if(type.params.begin(), type.params.end(), [&](const ParamSpec& spec) { return spec.name == name; });
    if (name.empty()) return;
    if (found == type.params.end()) return contradiction(path, fmt::format("there is no param '{}'", name));
    if (is_real && found->kind != ParamKind::real) contradiction(path, fmt::format("param '{}' is not a float", name));
  }
  void check_link(const DeviceType& type) {
    const bool fits = std::any_of(type.roles.begin(), type.roles.end(), [&](const RoleSpec& role) {
      return role.name == type.link_role && role.interface == "any";
    });
    if (!fits) contradiction({"link", "role"}, fmt::format("there is no role '{}' of interface 'any'", type.link_role));
  }
  void check_wcet_params(const DeviceType& type, const std::vector<std::string>& names, const std::string& member) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      const bool fits = std::any_of(type.params.begin(), type.params.end(), [&](const ParamSpec& spec) {
        return spec.name == names[i] && spec.kind == ParamKind::integer && spec.unit == Unit::time_ns;
      });
      if (!fits)
        contradiction({"wcet", member, std::to_string(i)}, fmt::format("there is no param '{}' of unit ns", names[i]));
    }
  }
  void check_wcet(const DeviceType& type) {
    check_wcet_params(type, type.wcet->update_params, "update_params");
    check_wcet_params(type, type.wcet->handle_params, "handle_params");
  }
  void check_range(const std::optional<std::uint32_t>& low, const std::optional<std::uint32_t>& high,
                   const std::string& member) {
    if (low && high && *low > *high)
      contradiction({"bus", member, "max"}, fmt::format("{}: max {} is below min {}", member, *high, *low));
  }
  void check_bus(const Json& value, const DeviceType& type) {
    check_range(type.id_min, type.id_max, "id");
    check_range(type.channel_min, type.channel_max, "channel");
    const auto& allowed = type.addresses;
    if (!type.default_address || allowed.empty() ||
        std::find(allowed.begin(), allowed.end(), *type.default_address) != allowed.end())
      return;
    contradiction({"bus", "address", "default"}, fmt::format("the default address {} is not allowed",
                                                             value.at("bus").at("address").at("default").dump()));
  }

  const SourceFile& source_;
  Diagnostics& diagnostics_;
};

/// What stands behind `runtime/include/`, else the file's name.
std::string include_name(const std::string& header) {
  constexpr std::string_view kShipped = "runtime/include/";
  const std::size_t at = header.rfind(kShipped);
  if (at != std::string::npos) return header.substr(at + kShipped.size());
  const std::size_t slash = header.rfind('/');
  return slash == std::string::npos ? header : header.substr(slash + 1);
}

}  // namespace

std::vector<SharedFrame> DeviceType::shared_frames() const {
  std::vector<SharedFrame> all;
  for (const Frame& frame : frames.value_or(std::vector<Frame>()))
    all.insert(all.end(), frame.shared.begin(), frame.shared.end());
  return all;
}

std::uint32_t parse_hex(const std::string& text) {
  const auto parsed = units::parse_bare(text);
  return parsed ? *parsed : 0;
}

DeviceType read_device_type(const Json& value, const SourceFile& source, Diagnostics& diagnostics) {
  DeviceType type;
  type.name = value.at("type").get<std::string>();
  type.summary = value.at("summary").get<std::string>();
  type.cpp_class = value.at("class").get<std::string>();
  type.include = include_name(value.at("header").get<std::string>());
  if (const auto bus = value.find("bus"); bus != value.end()) read_bus(*bus, type);
  type.provides = read_list<Interface>(value, "provides", read_interface);
  type.roles = read_list<RoleSpec>(value, "roles", read_role);
  type.uses = read_list<UseSpec>(value, "uses", read_use);
  type.params = read_params(value, source, diagnostics);
  type.geometry = read_list<GeometrySpec>(value, "geometry", read_geometry);
  if (const auto link = value.find("link"); link != value.end()) type.link_role = link->at("role").get<std::string>();
  type.actuator = value.value("actuator", false);
  type.constant_init = value.value("constant_init", true);
  type.wcet = read_wcet(value);
  if (const auto it = value.find("acquisition"); it != value.end()) type.acquisition = read_acquisition(*it);
  if (const auto it = value.find("frames"); it != value.end()) type.frames = read_frames(*it);
  type.interrupts = read_list<Interrupt>(value, "interrupts", read_interrupt);
  if (const auto it = value.find("emulation"); it != value.end()) type.emulation = read_emulation(*it);
  DescriptorCheck(source, diagnostics).check(value, type);
  return type;
}

ExpanderType read_expander_type(const Json& value, const SourceFile& source, Diagnostics& diagnostics) {
  ExpanderType type;
  type.name = value.at("model").get<std::string>();
  type.summary = value.at("summary").get<std::string>();
  type.cpp_class = value.value("class", "");
  type.include = value.contains("header") ? include_name(value.at("header").get<std::string>()) : "";
  const Json& bus = value.at("bus");
  type.addresses = read_addresses(bus.at("address"));
  type.max_clock_hz = optional_member<std::int64_t>(bus, "max_clock_hz");
  const Json& provides = value.at("provides");
  type.provides = bus_kind(provides.at("bus").get<std::string>()).value_or(BusKind::i2c);
  type.channels = provides.at("channels").get<std::uint32_t>();
  type.named_channels = provides.at("named").get<bool>();
  if (const auto repeats = provides.find("repeats"); repeats != provides.end()) type.repeats = read_repeats(*repeats);
  type.params = read_params(value, source, diagnostics);
  if (const auto it = value.find("frames"); it != value.end()) type.frames = read_expander_frames(*it);
  return type;
}

}  // namespace finemote::gen
