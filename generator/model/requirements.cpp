// The <require> elements: FM3081 (an operand that names nothing) and FM3082 (not exactly one question).
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "generator/model/attributes.hpp"
#include "generator/model/no_segment.hpp"
#include "generator/model/reading.hpp"
#include "generator/units/operand_text.hpp"
#include "generator/units/units.hpp"

namespace finemote::gen {
namespace {

/// A part of an attribute's value, with its place.
struct Operand {
  std::string_view text;
  Position at;
};

Operand operand_at(const xml::Attribute& attribute, std::string_view part) {
  const std::string_view inner = trim(part);
  Position at = attribute.value_at;
  if (at.column > 0 && !inner.empty()) at.column += static_cast<std::uint32_t>(inner.data() - attribute.value.data());
  return {inner, at};
}

class RequirementReader {
 public:
  RequirementReader(Reading& reading, const xml::Node& tag)
      : reading_(reading), diagnostics_(reading.diagnostics), tag_(tag) {}

  void read() {
    requirement_.at = tag_.at;
    const xml::Attribute* latency = tag_.attribute("latency");
    const xml::Attribute* utilization = tag_.attribute("utilization");
    const xml::Attribute* jitter = tag_.attribute("jitter");
    const int questions = (latency != nullptr) + (utilization != nullptr) + (jitter != nullptr);
    const auto is_misspelt = [&](const char* name) { return reading_.tags.is_misspelt(tag_, name); };
    if (questions == 0 && (is_misspelt("latency") || is_misspelt("utilization") || is_misspelt("jitter"))) return;
    if (questions != 1) {
      at_tag(diagnostics_, code::require_shape, tag_, "<require> takes exactly one of latency, utilization and jitter")
          .note(fmt::format("it has {} of them", questions))
          .hint("for example <require latency=\"imu -> thruster_1\" max=\"20ms\"/>");
      return;
    }
    if (latency == nullptr) refuse_of();
    const std::size_t findings = diagnostics_.size();
    if (latency != nullptr) read_latency(*latency);
    if (utilization != nullptr) read_utilization(*utilization);
    if (jitter != nullptr) read_jitter(*jitter);
    if (diagnostics_.size() == findings) reading_.robot.requirements.push_back(std::move(requirement_));
  }

 private:
  void refuse_of() {
    const xml::Attribute* of = tag_.attribute("of");
    if (of == nullptr) return;
    diagnostics_.error(code::attribute_unused, of->at, "'of' belongs to latency only")
        .underline(2)
        .hint(fmt::format("remove of=\"{}\"", of->value));
  }
  void read_latency(const xml::Attribute& attribute) {
    requirement_.text = attribute.value;
    const auto of = read_choice(tag_, "of", {"end-to-end", "decision"}, diagnostics_);
    requirement_.kind = of == "decision" ? Requirement::Kind::latency_decision : Requirement::Kind::latency_end_to_end;
    const std::string_view text = attribute.value;
    const std::size_t arrow = text.find("->");
    if (arrow == std::string_view::npos) {
      at_value(diagnostics_, code::require_operand, attribute, "latency needs two devices").hint(example());
    } else {
      requirement_.from = read_devices(operand_at(attribute, text.substr(0, arrow)), attribute);
      requirement_.to = read_devices(operand_at(attribute, text.substr(arrow + 2)), attribute);
    }
    read_max_time();
  }
  void read_jitter(const xml::Attribute& attribute) {
    requirement_.kind = Requirement::Kind::jitter;
    requirement_.text = attribute.value;
    const auto device = find_device(operand_at(attribute, attribute.value), attribute);
    if (device) requirement_.to = {*device};
    read_max_time();
  }
  void read_utilization(const xml::Attribute& attribute) {
    requirement_.kind = Requirement::Kind::utilization;
    requirement_.text = attribute.value;
    if (attribute.value != "cpu") requirement_.bus = find_bus(attribute);
    requirement_.max_text = value_of(tag_, "max");
    requirement_.max_fraction = read_quantity(tag_, "max", units::parse_percent, diagnostics_).value_or(0);
  }
  void read_max_time() {
    requirement_.max_text = value_of(tag_, "max");
    requirement_.max = read_quantity(tag_, "max", units::parse_duration, diagnostics_).value_or(Duration::zero());
  }

  std::optional<BusId> find_bus(const xml::Attribute& attribute) {
    std::vector<std::string> names{"cpu"};
    for (const BusId i : reading_.robot.buses.ids()) {
      if (reading_.robot.buses[i].name.text == attribute.value) return i;
      names.push_back(reading_.robot.buses[i].name.text);
    }
    const auto& lost = reading_.tags.lost_buses;
    if (std::find(lost.begin(), lost.end(), attribute.value) != lost.end()) return {};
    auto& finding =
        at_value(diagnostics_, code::require_operand, attribute, fmt::format("there is no bus '{}'", attribute.value));
    const auto segment = reading_.segment_named(attribute.value);
    if (segment) {
      finding.message = fmt::format("'{}' is not a bus of the board", attribute.value);
      const BusId bus = reading_.robot.segments[*segment].bus;
      if (bus != kNoBus) finding.hint(fmt::format("its transfers run on '{}'", reading_.robot.buses[bus].name.text));
    } else {
      suggest(finding, attribute.value, names);
    }
    return {};
  }
  Diagnostic& at_operand(const Operand& operand, const xml::Attribute& attribute, std::string message) {
    if (operand.text.empty()) return at_value(diagnostics_, code::require_operand, attribute, std::move(message));
    return diagnostics_.error(code::require_operand, operand.at, std::move(message)).underline(operand.text.size());
  }
  /// A latency between two devices there are: the first and the last.
  std::string example() {
    const std::vector<std::string> names = reading_.device_names();
    if (names.empty()) return "declare devices first";
    return fmt::format("write for example latency=\"{} -> {}\"", names.front(), names.back());
  }
  std::optional<DeviceId> find_device(const Operand& operand, const xml::Attribute& attribute) {
    if (operand.text.empty()) {
      at_operand(operand, attribute, "a device is missing").hint(example());
      return {};
    }
    const auto device = reading_.device_named(operand.text);
    if (!device)
      suggest(at_operand(operand, attribute, fmt::format("there is no device '{}'", operand.text)), operand.text,
              reading_.device_names());
    return device;
  }
  /// A device, or `root.role`: all children in that role.
  std::vector<DeviceId> read_devices(const Operand& operand, const xml::Attribute& attribute) {
    const OperandText words =
        split_operand(operand.text, [&](std::string_view name) { return reading_.device_named(name).has_value(); });
    const auto device = find_device({words.device, operand.at}, attribute);
    if (!device) return {};
    if (!words.is_role) return {*device};
    if (reading_.robot.devices[*device].type == nullptr) return {};
    return children_in(*device, words.role, operand, attribute);
  }
  std::vector<DeviceId> children_in(DeviceId owner, std::string_view role, const Operand& operand,
                                    const xml::Attribute& attribute) {
    const Device& device = reading_.robot.devices[owner];
    std::vector<std::string> filled;  // operands with roles that have children
    std::vector<DeviceId> children;
    bool exists = false;
    for (std::size_t i = 0; i < device.type->roles.size(); ++i) {
      const std::string& name = device.type->roles[i].name;
      const auto has_role = [&](DeviceId child) { return reading_.robot.devices[child].role == i; };
      if (std::any_of(device.children.begin(), device.children.end(), has_role))
        filled.push_back(device.name.text + "." + name);
      if (name != role) continue;
      exists = true;
      std::copy_if(device.children.begin(), device.children.end(), std::back_inserter(children), has_role);
    }
    if (!exists) {
      auto& finding =
          at_operand(operand, attribute, fmt::format("device '{}' has no role '{}'", device.name.text, role));
      suggest(finding, operand.text, filled);
      if (filled.empty()) finding.note("it has no children; name the device itself, or another one");
    } else if (children.empty() && !reading_.devices[owner].is_incomplete) {
      at_operand(operand, attribute, fmt::format("device '{}' has no child in the role '{}'", device.name.text, role));
    }
    return children;
  }

  Reading& reading_;
  Diagnostics& diagnostics_;
  const xml::Node& tag_;
  Requirement requirement_;
};

}  // namespace

void read_requirements(Reading& reading) {
  for (const xml::Node* tag : reading.tags.requirements) RequirementReader(reading, *tag).read();
}

}  // namespace finemote::gen
