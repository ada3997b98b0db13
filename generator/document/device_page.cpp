#include "generator/document/device_page.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "generator/document/markdown.hpp"
#include "generator/document/param_table.hpp"

namespace finemote::gen {
namespace {

using Json = nlohmann::ordered_json;

const Json& list(const Json& value, const char* key) {
  static const Json none = Json::array();
  const auto found = value.find(key);
  return found == value.end() ? none : *found;
}

std::vector<std::string> texts(const Json& values) {
  std::vector<std::string> result;
  for (const Json& value : values) result.push_back(value.get<std::string>());
  return result;
}

std::string range_of(const Json& value) {
  const auto bound = [&](const char* key) { return value.contains(key) ? value.at(key).dump() : std::string(); };
  return value.contains("min") || value.contains("max") ? fmt::format("{}..{}", bound("min"), bound("max"))
                                                        : "required";
}

std::string bus_text(const Json& device) {
  const auto bus = device.find("bus");
  if (bus == device.end()) return "none";
  std::vector<std::string> parts{joined(texts(bus->at("types")), " or ")};
  if (!bus->value("required", true)) parts.emplace_back("may be left out");
  if (bus->contains("address")) {
    const Json& address = bus->at("address");
    parts.push_back(address.contains("default") ? "`address` default " + address["default"].get<std::string>()
                                                : "`address` required");
    if (address.contains("allowed")) parts.push_back("one of " + joined(texts(address["allowed"])));
  }
  if (bus->contains("channel")) parts.push_back("`channel` " + range_of(bus->at("channel")));
  if (bus->contains("id")) parts.push_back("`id` " + range_of(bus->at("id")));
  std::vector<std::string> rates;
  for (const Json& rate : list(*bus, "rates")) rates.push_back(rate.dump());
  if (!rates.empty()) parts.push_back(joined(rates, " or ") + " bit/s");
  if (bus->contains("format")) parts.push_back(bus->at("format").get<std::string>());
  if (bus->contains("mode")) parts.push_back("mode " + bus->at("mode").dump());
  if (bus->contains("max_clock_hz")) parts.push_back("at most " + bus->at("max_clock_hz").dump() + " Hz");
  if (bus->contains("receives")) {
    parts.push_back(
        fmt::format("its frames have the identifier {:#05x} + `id`", bus->at("receives").at("base").get<int>()));
  }
  return joined(parts, "; ");
}

std::string provides_text(const Json& device) {
  std::vector<std::string> parts;
  for (const Json& it : list(device, "provides"))
    parts.push_back("`" + it["interface"].get<std::string>() + "`" +
                    (it.value("command", false) ? " with command" : ""));
  return joined(parts, ", ", "its age, to roles that take any device");
}

std::string arity(const Json& role) {
  const auto least = role.value("min", 0);
  const auto most = role.find("max");
  if (most == role.end() || most->is_null()) return fmt::format("{}..n", least);
  return most->get<int>() == least ? std::to_string(least) : fmt::format("{}..{}", least, most->get<int>());
}

std::string with_summary(std::string text, const Json& value) {
  return value.contains("summary") ? text + ": " + value["summary"].get<std::string>() : text;
}

std::string role_row(const Json& role) {
  const std::string interface =
      role["interface"] == "any" ? "any device" : "`" + role["interface"].get<std::string>() + "`";
  return row({"role `" + role["name"].get<std::string>() + "`",
              with_summary(fmt::format("{} × {}", arity(role), interface), role)});
}

std::string use_row(const Json& use) {
  std::string what = joined(texts(use["types"]), " or ");
  if (use.contains("function")) what += " (" + use["function"].get<std::string>() + ")";
  what += use.value("min", 0) > 0 ? ", required" : ", optional";
  return row({"use `" + use["name"].get<std::string>() + "`", with_summary(what, use)});
}

std::string sample_text(const Json& acquisition) {
  std::string text = acquisition["model"] == "streamed" ? "sent by the part" : "requested by update()";
  if (acquisition.contains("interval_ns"))
    text += ", every " + time_text(acquisition["interval_ns"].get<std::int64_t>());
  if (acquisition.contains("periods"))
    text += fmt::format(", published {} period(s) later", acquisition["periods"].get<int>());
  if (acquisition.value("latency_ns", std::int64_t{0}) > 0)
    text += ", up to " + time_text(acquisition["latency_ns"].get<std::int64_t>()) + " old inside the part";
  return text;
}

std::string frame_text(const Json& frame) {
  std::vector<std::string> parts;
  if (frame.value("write", 0) > 0) parts.push_back(fmt::format("{} bytes out", frame["write"].get<int>()));
  if (frame.value("read", 0) > 0) parts.push_back(fmt::format("{} bytes in", frame["read"].get<int>()));
  std::string when = frame["stage"].get<std::string>();
  if (frame.contains("use")) when += ", over the use `" + frame["use"].get<std::string>() + "`";
  if (frame.contains("min_interval_ns"))
    when += ", at least " + time_text(frame["min_interval_ns"].get<std::int64_t>()) + " apart";
  return with_summary(fmt::format("{}: {}", when, joined(parts)), frame);
}

std::string interrupt_text(const Json& interrupt) {
  std::string text = interrupt["source"].get<std::string>();
  if (interrupt.contains("use")) text += ", with the use `" + interrupt["use"].get<std::string>() + "`";
  if (interrupt.contains("min_interval_ns"))
    text += ", at least " + time_text(interrupt["min_interval_ns"].get<std::int64_t>()) + " apart";
  return text;
}

/// The kind, with what the type asks of it: docs/reference/geometry.md says the rest.
std::string geometry_text(const Json& geometry) {
  const auto kind = geometry["kind"].get<std::string>();
  std::string text = fmt::format("[{0}](../geometry.md#{0})", kind);
  if (kind == "mount") return text + ": how its `link` is turned";
  const std::string tolerance = fmt::format("; tolerance {:g} degree{}", geometry.value("tolerance", 1.0),
                                            geometry.value("tolerance", 1.0) == 1 ? "" : "s");
  if (kind == "range" && !geometry.contains("role")) return text + ": how far its `joint` may turn" + tolerance;
  text += fmt::format(" of `{}`", geometry["role"].get<std::string>());
  if (geometry.value("optional", false)) text += ", where their joints are given";
  if (geometry.contains("along")) text += fmt::format("; along {}", geometry["along"].get<std::string>());
  if (geometry.contains("behind")) text += fmt::format(", behind `{}`", geometry["behind"].get<std::string>());
  if (geometry.contains("commands")) text += "; commands " + joined(texts(geometry["commands"]), ", ");
  if (geometry.contains("lowest"))
    text += fmt::format(", within `{}` and `{}`", geometry["lowest"].get<std::string>(),
                        geometry["highest"].get<std::string>());
  return kind == "chain" ? text : text + tolerance;
}

}  // namespace

std::string device_page(const Json& device, const std::string& include) {
  std::string text = sentence(device["summary"].get<std::string>()) + "\n\n" + table({"", ""});
  text += row({"class", fmt::format("`{}` in `<{}>`", device["class"].get<std::string>(), include)});
  text += row({"bus", bus_text(device)});
  text += row({"provides", provides_text(device)});
  for (const Json& role : list(device, "roles")) text += role_row(role);
  for (const Json& use : list(device, "uses")) text += use_row(use);
  for (const Json& geometry : list(device, "geometry")) text += row({"geometry", geometry_text(geometry)});
  if (device.contains("link"))
    text += row({"link", "states and commands of `" + device["link"]["role"].get<std::string>() + "`, to a computer"});
  if (device.value("actuator", false)) text += row({"actuator", "yes: has `safe()`"});
  if (device.contains("acquisition")) text += row({"sample", sample_text(device["acquisition"])});
  for (const Json& frame : list(device, "frames")) text += row({"on the wire", frame_text(frame)});
  for (const Json& interrupt : list(device, "interrupts")) text += row({"interrupt", interrupt_text(interrupt)});
  if (device.contains("wcet")) {
    text += row({"assumed without `<wcet>`",
                 fmt::format("update {}, handle {}", time_text(device["wcet"]["update_ns"].get<std::int64_t>()),
                             time_text(device["wcet"]["handle_ns"].get<std::int64_t>()))});
  }
  return text + param_table(device);
}

}  // namespace finemote::gen
