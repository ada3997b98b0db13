#include "generator/document/device_page.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "generator/bus/bus_type.hpp"
#include "generator/document/markdown.hpp"
#include "generator/document/param_table.hpp"

namespace finemote::gen {
namespace {

/// Whether `test` holds of one of the kinds.
template <typename Test>
bool takes(const std::vector<BusKind>& kinds, const Test& test) {
  return std::any_of(kinds.begin(), kinds.end(), [&](BusKind kind) { return test(bus_type(kind)); });
}

bool has_line_format(const BusType& type) { return type.has_line_format; }
bool has_modes(const BusType& type) { return type.slot_class.takes_mode; }
bool is_of_pins(const BusType& type) { return type.channels == BusType::Channels::pins; }

std::string hex(std::uint32_t address) { return fmt::format("{:#04x}", address); }

std::string number(const std::optional<std::uint32_t>& value) { return value ? std::to_string(*value) : std::string(); }

std::string range_of(const std::optional<std::uint32_t>& least, const std::optional<std::uint32_t>& most) {
  return least || most ? fmt::format("{}..{}", number(least), number(most)) : "required";
}

void add_address(const DeviceType& type, std::vector<std::string>& parts) {
  if (!type.needs_address) return;
  parts.push_back(type.default_address ? "`address` default " + hex(*type.default_address) : "`address` required");
  std::vector<std::string> allowed;
  for (const std::uint32_t address : type.addresses) allowed.push_back(hex(address));
  if (!allowed.empty()) parts.push_back("one of " + joined(allowed));
}

/// `identifier 0x201 + `id``, and with a factor, a block or several where there are.
std::string identifiers_text(const std::vector<Identifiers>& entries) {
  std::vector<std::string> texts;
  for (const Identifiers& entry : entries) {
    std::string text = fmt::format("{:#05x}", entry.base);
    if (entry.per_id == 1) text += " + `id`";
    if (entry.per_id > 1) text += fmt::format(" + {:#x} × `id`", entry.per_id);
    if (entry.count > 1) text += fmt::format(" and the {} after it", entry.count - 1);
    texts.push_back(text);
  }
  const bool is_one = entries.size() == 1 && entries.front().count == 1;
  return (is_one ? "identifier " : "identifiers ") + joined(texts);
}

std::string bus_text(const DeviceType& type) {
  if (type.buses.empty()) return "none";
  std::vector<std::string> parts{joined(bus_kind_names(type.buses), " or ")};
  if (!type.bus_required) parts.emplace_back("may be left out");
  add_address(type, parts);
  if (type.needs_channel) parts.push_back("`channel` " + range_of(type.channel_min, type.channel_max));
  if (type.needs_id) parts.push_back("`id` " + range_of(type.id_min, type.id_max));
  if (!type.rates.empty()) parts.push_back(fmt::format("{} bit/s", fmt::join(type.rates, " or ")));
  if (takes(type.buses, has_line_format)) parts.push_back(type.format);
  if (takes(type.buses, has_modes)) parts.push_back(fmt::format("mode {}", type.spi_mode));
  if (type.max_clock_hz) parts.push_back(fmt::format("at most {} Hz", *type.max_clock_hz));
  if (!type.receives.empty()) parts.push_back("its frames have the " + identifiers_text(type.receives));
  return joined(parts, "; ");
}

std::string provides_text(const DeviceType& type) {
  std::vector<std::string> parts;
  for (const Interface& it : type.provides)
    parts.push_back("`" + it.name + "`" + (it.has_command ? " with command" : ""));
  return joined(parts, ", ", "its age, to roles that take any device");
}

std::string arity(const RoleSpec& role) {
  if (!role.max) return fmt::format("{}..n", role.min);
  return *role.max == role.min ? std::to_string(role.min) : fmt::format("{}..{}", role.min, *role.max);
}

std::string with_summary(const std::string& text, const std::string& summary) {
  return summary.empty() ? text : text + ": " + summary;
}

std::string role_row(const RoleSpec& role) {
  const std::string interface = role.interface == "any" ? "any device" : "`" + role.interface + "`";
  return row({"role `" + role.name + "`", with_summary(fmt::format("{} × {}", arity(role), interface), role.summary)});
}

std::string use_row(const UseSpec& use) {
  std::string what = joined(bus_kind_names(use.buses), " or ");
  if (takes(use.buses, is_of_pins)) what += " (" + use.function + ")";
  what += use.required ? ", required" : ", optional";
  return row({"use `" + use.role + "`", with_summary(what, use.summary)});
}

std::string wcet_text(const WcetDefault& wcet) {
  std::string update = "update " + time_text(wcet.update);
  if (wcet.per_frame > Duration::zero()) update += " and " + time_text(wcet.per_frame) + " for each frame received";
  std::string text = update + ", handle " + time_text(wcet.handle);
  const Duration in_update = wcet.update_per_child, in_handle = wcet.handle_per_child;
  if (in_update == in_handle && in_update > Duration::zero())
    text += "; each " + time_text(in_update) + " more for every child";
  if (in_update != in_handle)
    text += "; " + time_text(in_update) + " and " + time_text(in_handle) + " more for every child";
  return text;
}

std::string sample_text(const Acquisition& acquisition) {
  const bool is_streamed = acquisition.model == Acquisition::Model::streamed;
  std::string text = is_streamed ? "sent by the part" : "requested by update()";
  const std::string off = fmt::format("up to {:g} % off", static_cast<double>(acquisition.tolerance_ppm) / 1e4);
  const std::string& param = acquisition.interval_param;
  if (acquisition.interval) text += fmt::format(", every {} ({})", time_text(*acquisition.interval), off);
  if (!param.empty()) text += fmt::format(", every `{}` ({})", param, off);
  if (!acquisition.interval && param.empty() && acquisition.tolerance_ppm != kUsualTolerancePpm)
    text += ", by a clock " + off;
  if (acquisition.periods) text += fmt::format(", published {} period(s) later", *acquisition.periods);
  if (acquisition.latency > Duration::zero()) text += ", with a delay of up to " + time_text(acquisition.latency);
  return text;
}

std::string frame_text(const Frame& frame) {
  std::vector<std::string> parts;
  if (frame.write_bytes > 0) parts.push_back(fmt::format("{} bytes out", frame.write_bytes));
  if (frame.read_bytes > 0) parts.push_back(fmt::format("{} bytes in", frame.read_bytes));
  std::string when = to_string(frame.stage);
  if (!frame.use.empty()) when += ", over the use `" + frame.use + "`";
  if (frame.min_interval) when += ", at least " + time_text(*frame.min_interval) + " apart";
  return with_summary(fmt::format("{}: {}", when, joined(parts)), frame.summary);
}

std::string interrupt_text(const Interrupt& interrupt) {
  std::string text = interrupt.source;
  if (!interrupt.use.empty()) text += ", with the use `" + interrupt.use + "`";
  if (interrupt.min_interval) text += ", at least " + time_text(*interrupt.min_interval) + " apart";
  return text;
}

/// The kind, with what the type asks of it: docs/reference/geometry.md says the rest.
std::string geometry_text(const GeometrySpec& geometry) {
  std::string text = fmt::format("[{0}](../geometry.md#{0})", geometry.kind);
  if (geometry.kind == "mount") return text + ": how its `link` is turned";
  const std::string tolerance =
      fmt::format("; tolerance {:g} degree{}", geometry.tolerance_deg, geometry.tolerance_deg == 1 ? "" : "s");
  if (geometry.kind == "range" && geometry.role.empty()) return text + ": how far its `joint` may turn" + tolerance;
  text += fmt::format(" of `{}`", geometry.role);
  if (geometry.optional) text += ", where their joints are given";
  if (!geometry.along.empty()) text += fmt::format("; along {}", geometry.along);
  if (!geometry.behind.empty()) text += fmt::format(", behind `{}`", geometry.behind);
  if (!geometry.commands.empty()) text += "; commands " + joined(geometry.commands, ", ");
  if (!geometry.lowest.empty()) text += fmt::format(", within `{}` and `{}`", geometry.lowest, geometry.highest);
  return geometry.kind == "chain" ? text : text + tolerance;
}

}  // namespace

std::string device_page(const DeviceType& type) {
  std::string text = sentence(type.summary) + "\n\n" + table({"", ""});
  text += row({"class", fmt::format("`{}` in `<{}>`", type.cpp_class, type.include)});
  text += row({"bus", bus_text(type)});
  text += row({"provides", provides_text(type)});
  for (const RoleSpec& role : type.roles) text += role_row(role);
  for (const UseSpec& use : type.uses) text += use_row(use);
  for (const GeometrySpec& geometry : type.geometry) text += row({"geometry", geometry_text(geometry)});
  if (!type.link_role.empty()) text += row({"link", "states and commands of `" + type.link_role + "`, to a computer"});
  if (type.actuator) text += row({"actuator", "yes: has `safe()`"});
  if (type.acquisition) text += row({"sample", sample_text(*type.acquisition)});
  for (const Frame& frame : type.frames.value_or(std::vector<Frame>())) text += row({"on the wire", frame_text(frame)});
  for (const Interrupt& interrupt : type.interrupts) text += row({"interrupt", interrupt_text(interrupt)});
  if (type.wcet) text += row({"assumed without `<wcet>`", wcet_text(*type.wcet)});
  return text + param_table(type.params);
}

}  // namespace finemote::gen
