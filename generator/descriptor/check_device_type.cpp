#include "generator/descriptor/check_device_type.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "generator/bus/bus_type.hpp"
#include "generator/descriptor/check_can_frames.hpp"
#include "generator/descriptor/check_class.hpp"
#include "generator/descriptor/check_emulation.hpp"
#include "generator/descriptor/check_provides.hpp"
#include "generator/descriptor/check_timing_figures.hpp"
#include "generator/descriptor/contradictions.hpp"
#include "generator/descriptor/read_param.hpp"

namespace finemote::gen {
namespace {

class DescriptorCheck {
 public:
  explicit DescriptorCheck(const Contradictions& found) : found_(found) {}

  void check(const DeviceType& type) {
    check_names(type.roles, &RoleSpec::name, {"roles", "name", "role"});
    check_names(type.uses, &UseSpec::role, {"uses", "name", "use"});
    check_names(type.provides, &Interface::name, {"provides", "interface", "interface"});
    for (std::size_t i = 0; i < type.roles.size(); ++i) check_arity(type.roles[i], i);
    for (std::size_t i = 0; i < type.uses.size(); ++i) check_data_ready(type, i);
    for (std::size_t i = 0; i < type.geometry.size(); ++i) check_geometry(type, i);
    if (!type.link_role.empty()) check_link(type);
    if (type.wcet) check_wcet(type);
    check_bus(type);
    for (std::size_t i = 0; type.frames && i < type.frames->size(); ++i)
      check_use_named(type, (*type.frames)[i].use, {"frames", std::to_string(i), "use"});
    for (std::size_t i = 0; i < type.interrupts.size(); ++i)
      check_use_named(type, type.interrupts[i].use, {"interrupts", std::to_string(i), "use"});
    check_role_named(type, type.emulation.wheels, {"emulation", "wheels"});
  }

 private:
  Diagnostic& contradiction(const JsonPath& path, std::string message) { return found_.add(path, std::move(message)); }
  /// Where a list of named entries stands, and what an entry is called.
  struct Named {
    const char *list, *member, *what;
  };
  template <typename Entry>
  void check_names(const std::vector<Entry>& entries, std::string Entry::*name, const Named& named) {
    std::set<std::string> seen;
    for (std::size_t i = 0; i < entries.size(); ++i) {
      if (seen.insert(entries[i].*name).second) continue;
      contradiction({named.list, std::to_string(i), named.member},
                    fmt::format("there are two {}s '{}'", named.what, entries[i].*name));
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
  void check_use_named(const DeviceType& type, const std::string& name, const JsonPath& path) {
    const bool exists =
        std::any_of(type.uses.begin(), type.uses.end(), [&](const UseSpec& use) { return use.role == name; });
    if (!name.empty() && !exists) contradiction(path, fmt::format("there is no use '{}'", name));
  }
  void check_param_named(const DeviceType& type, const std::string& name, bool is_real, const JsonPath& path) {
    if (name.empty()) return;
    const ParamSpec* spec = find_spec(type.params, name);
    if (spec == nullptr) return void(contradiction(path, fmt::format("there is no param '{}'", name)));
    if (is_real && spec->kind != ParamKind::real) contradiction(path, fmt::format("param '{}' is not a float", name));
  }
  void check_link(const DeviceType& type) {
    const bool fits = std::any_of(type.roles.begin(), type.roles.end(), [&](const RoleSpec& role) {
      return role.name == type.link_role && role.interface == "any";
    });
    if (!fits) contradiction({"link", "role"}, fmt::format("there is no role '{}' of interface 'any'", type.link_role));
  }
  void check_wcet_params(const DeviceType& type, const std::vector<std::string>& names, const std::string& member) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      const ParamSpec* spec = find_spec(type.params, names[i]);
      if (spec == nullptr || spec->kind != ParamKind::integer || spec->unit != Unit::time_ns)
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
  static bool has_identifiers(const DeviceType& type) {
    const auto is_shared = [](const Frame& frame) { return !frame.shared.empty(); };
    return !type.receives.empty() || (type.frames && std::any_of(type.frames->begin(), type.frames->end(), is_shared));
  }
  void check_bus(const DeviceType& type) {
    check_range(type.id_min, type.id_max, "id");
    if (type.id_max.value_or(0) > kHighestId)
      contradiction({"bus", "id", "max"}, fmt::format("ids have 16 bits: {} is too high", *type.id_max));
    if (type.needs_id && !type.id_max && has_identifiers(type))
      contradiction({"bus", "id"}, "the highest id is missing: \"max\"; identifiers depend on it");
    check_range(type.channel_min, type.channel_max, "channel");
    for (const BusKind kind : type.buses) check_place(type, bus_type(kind));
    const auto& allowed = type.addresses;
    if (!type.default_address || allowed.empty() ||
        std::find(allowed.begin(), allowed.end(), *type.default_address) != allowed.end())
      return;
    contradiction({"bus", "address", "default"},
                  fmt::format("the default address \"{:#04x}\" is not allowed", *type.default_address));
  }

  /// What tells a device from the others on its bus: without it each would be the one at 0.
  void check_place(const DeviceType& type, const BusType& bus) {
    const auto lacks = [&](const char* member, const char* example) {
      contradiction({"bus"}, fmt::format("devices on {} are told apart by '{}', which the descriptor has to name",
                                         bus.name, member))
          .hint(fmt::format("\"{}\": {}", member, example));
    };
    if (bus.has_addresses && !type.needs_address) lacks("address", R"({ "default": "0x40" })");
    if (bus.channels != BusType::Channels::none && !type.needs_channel) lacks("channel", "{}");
  }

  const Contradictions& found_;
};

}  // namespace

void check_device_type(const DeviceType& type, const Origin& origin, Diagnostics& diagnostics) {
  const Contradictions found(origin, diagnostics);
  check_class(type.cpp_class, found);
  check_include(type.include, found);
  DescriptorCheck(found).check(type);
  check_provides(type.provides, found);
  check_can_frames(type, found);
  check_timing_figures(type, found);
  check_emulation(type.emulation, type.params, found);
  for (std::size_t i = 0; i < type.uses.size() && !type.emulation.part.empty(); ++i)
    check_part_member(type.uses[i].role, {"uses", std::to_string(i), "name"}, found);
}

}  // namespace finemote::gen
