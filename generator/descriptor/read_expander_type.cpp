#include "generator/descriptor/read_expander_type.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/bus/bus_type.hpp"
#include "generator/descriptor/check_class.hpp"
#include "generator/descriptor/check_emulation.hpp"
#include "generator/descriptor/member.hpp"
#include "generator/descriptor/read_device_type.hpp"
#include "generator/descriptor/read_param.hpp"

namespace finemote::gen {
namespace {

RepeatSpec read_repeats(const Json& value) {
  const Json& dividers = value.at("dividers");
  return {value.at("frequency").get<std::string>(), value.at("clock").get<std::string>(),
          value.at("counts").get<std::int64_t>(), dividers.at(0).get<std::int64_t>(),
          dividers.at(1).get<std::int64_t>()};
}

/// What no JSON Schema can see: which members go with which kind.
class ExpanderCheck {
 public:
  ExpanderCheck(const Json& value, const Contradictions& found) : value_(value), found_(found) {}

  void check(const ExpanderType& type) {
    if (type.is_mux())
      check_mux(type);
    else
      check_driver(type);
  }

 private:
  void check_mux(const ExpanderType& type) {
    for (const char* member : {"class", "header", "params", "frames", "wcet"}) {
      if (value_.contains(member)) contradiction({member}, fmt::format("a mux is no object: it has no \"{}\"", member));
    }
    if (type.repeats) contradiction({"provides", "repeats"}, "a mux makes no pulses: it has no \"repeats\"");
    if (!bus_type(type.provides).carries_expanders)
      contradiction({"provides", "bus"},
                    fmt::format("a mux provides segments of its {} bus", expander_bus_type().name));
    if (type.select == nullptr) return contradiction({"kind"}, "a mux needs a \"select\"");
    if (type.channels > type.select->channels) {
      contradiction({"provides", "channels"},
                    fmt::format("\"{}\" tells {} channels apart", type.select->name, type.select->channels));
    }
  }
  void check_driver(const ExpanderType& type) {
    if (type.select != nullptr) contradiction({"select"}, "only a mux has a \"select\"");
    if (type.cpp_class.empty() || type.header.empty())
      contradiction({"kind"}, "a driver needs a \"class\" and a \"header\"");
    if (bus_type(type.provides).channels != BusType::Channels::outputs)
      contradiction({"provides", "bus"}, "a driver provides a pwm bus");
    if (type.repeats) {
      if (type.repeats->least_divider > type.repeats->most_divider)
        contradiction({"provides", "repeats", "dividers", "0"}, "the smallest divider is above the largest");
      check_param(type, type.repeats->frequency, Unit::frequency_hz, {"provides", "repeats", "frequency"});
      check_param(type, type.repeats->clock, Unit::frequency_hz, {"provides", "repeats", "clock"});
    }
    const bool sends = type.frames.per_flush.write_bytes > 0 || type.frames.per_channel.write_bytes > 0;
    if (!sends) contradiction({"kind"}, "a driver needs \"frames\": what a flush sends");
    const bool is_shipped = type.header.find("runtime/include/") != std::string::npos;
    if (!type.flush && !is_shipped) contradiction({"kind"}, "a driver needs \"wcet\": how long its flush() takes");
    check_param(type, type.frames.checked_every, Unit::none, {"frames", "check", "every"});
  }
  void check_param(const ExpanderType& type, const std::string& name, Unit unit, const JsonPath& path) {
    const bool exists = std::any_of(type.params.begin(), type.params.end(), [&](const ParamSpec& spec) {
      return spec.name == name && spec.kind == ParamKind::integer && spec.unit == unit;
    });
    if (!name.empty() && !exists)
      contradiction(path, fmt::format("there is no int param '{}'{}", name, unit == Unit::none ? "" : " of unit Hz"));
  }
  void contradiction(const JsonPath& path, std::string message) { found_.add(path, std::move(message)); }

  const Json& value_;
  const Contradictions& found_;
};

}  // namespace

ExpanderType read_expander_type(const Json& value, const Origin& origin, Diagnostics& diagnostics) {
  ExpanderType type;
  type.name = value.at("model").get<std::string>();
  type.summary = value.at("summary").get<std::string>();
  type.kind = value.at("kind") == "mux" ? ExpanderType::Kind::mux : ExpanderType::Kind::driver;
  type.select = find_mux_select(value.value("select", std::string()));
  type.cpp_class = value.value("class", "");
  type.header = value.value("header", std::string());
  type.include = include_name(type.header);
  const Json& bus = value.at("bus");
  type.addresses = read_addresses(bus.at("address"));
  type.max_clock_hz = optional_member<std::int64_t>(bus, "max_clock_hz");
  const Json& provides = value.at("provides");
  type.provides = bus_kind(provides.at("bus").get<std::string>()).value_or(BusKind{});
  type.channels = provides.at("channels").get<std::uint32_t>();
  if (const auto repeats = provides.find("repeats"); repeats != provides.end()) type.repeats = read_repeats(*repeats);
  type.is_suggested = value.value("suggested", false);
  type.params = read_params(value, origin, diagnostics);
  if (const auto it = value.find("frames"); it != value.end()) type.frames = read_expander_frames(*it);
  if (const auto it = value.find("wcet"); it != value.end()) {
    type.flush = FlushTime{duration_member(*it, "flush_ns").value_or(Duration::zero()),
                           duration_member(*it, "per_channel_ns").value_or(Duration::zero())};
  }
  if (const auto it = value.find("emulation"); it != value.end()) type.emulation = read_emulation(*it);
  const Contradictions found(origin, diagnostics);
  check_class(type.cpp_class, found);
  check_include(type.include, found);
  check_emulation(type.emulation, type.params, found);
  ExpanderCheck(value, found).check(type);
  return type;
}

}  // namespace finemote::gen
