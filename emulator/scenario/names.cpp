#include "emulator/scenario/names.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/diagnostic/code_scenario.hpp"
#include "generator/diagnostic/suggest.hpp"

namespace finemote::scenario {

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

gen::Diagnostic& Names::unknown(const Value& name, std::string message) {
  return diagnostics_.error(gen::code::scenario_name, name.at, std::move(message)).underline(name.length);
}

const World::Part* Names::find(const std::string& name) const {
  const auto found = std::find_if(parts_.begin(), parts_.end(), [&](const auto& part) { return part.name == name; });
  return found == parts_.end() ? nullptr : &*found;
}

bool Names::add(const World::Part& part) {
  const auto known =
      std::find_if(parts_.begin(), parts_.end(), [&](const auto& other) { return other.name == part.name; });
  if (known == parts_.end()) {
    parts_.push_back(part);
    return true;
  }
  const bool stands_in = known->type.empty();
  if (stands_in) *known = part;
  return stands_in;
}

const Model* Names::model_of(const Value& name) {
  const World::Part* part = find(name.text);
  if (part != nullptr && !part->type.empty()) return find_model(part->type);
  if (part != nullptr) {
    unknown(name, fmt::format("'{}' has no model on the emulated board", name.text))
        .note("a scenario names parts: devices on buses, expanders and bodies");
    return nullptr;
  }
  std::vector<std::string> with_model;
  for (const World::Part& it : parts_) {
    if (!it.type.empty()) with_model.push_back(it.name);
  }
  unknown(name, fmt::format("there is no part '{}'", name.text)).hint(gen::did_you_mean(name.text, with_model));
  return nullptr;
}

void Names::reference(const Member& row, const Value& name) {
  const Model* model = model_of(name);
  if (model == nullptr || row.choices.empty() || contains(model->is, row.choices[0])) return;
  std::vector<std::string> names;
  for (const World::Part& it : parts_) {
    const Model* other = find_model(it.type);
    if (other != nullptr && contains(other->is, row.choices[0])) names.push_back(it.name);
  }
  auto& finding =
      unknown(name, fmt::format("'{}' is a '{}', which cannot be a '{}'", name.text, model->type, row.name));
  if (!names.empty()) finding.hint(gen::did_you_mean(name.text, names));
}

bool Names::has_bus(const std::string& port) const { return !ports_ || contains(*ports_, port); }

std::vector<std::string> Names::ports_in_use(const PortKind* kind) const {
  std::vector<std::string> ports;
  if (ports_) {
    for (const std::string& port : *ports_) {
      if (kind == nullptr || kind_of_port(port) == kind) ports.push_back(port);
    }
    return ports;
  }
  for (const PortKind& it : port_kinds()) {
    if (kind == nullptr || kind == &it) ports.insert(ports.end(), it.ports.begin(), it.ports.end());
  }
  return ports;
}

void Names::port(const Member& row, const Value& name) {
  const PortKind* kind = kind_of_port(name.text);
  if (kind == nullptr || kind->name != row.choices[0]) {
    for (const PortKind& wanted : port_kinds()) {
      if (wanted.name != row.choices[0]) continue;
      unknown(name, fmt::format("the board has no {} '{}'", wanted.title, name.text))
          .hint(gen::did_you_mean(name.text, wanted.ports));
    }
  } else if (!has_bus(name.text)) {
    const auto ports = ports_in_use(kind);
    auto& finding = unknown(name, fmt::format("the robot has no bus at port '{}'", name.text));
    if (!ports.empty()) finding.hint(gen::did_you_mean(name.text, ports));
  }
}

const PortKind* Names::port_in_use(const Value& name) {
  const PortKind* kind = kind_of_port(name.text);
  if (kind != nullptr && has_bus(name.text)) return kind;
  const auto ports = ports_in_use(nullptr);
  auto& finding =
      unknown(name, kind == nullptr       ? fmt::format("the board has no port '{}'", name.text)
                    : kind->name == "adc" ? fmt::format("no device of the robot uses the converter '{}'", name.text)
                                          : fmt::format("the robot has no bus at port '{}'", name.text));
  if (!ports.empty()) finding.hint(gen::did_you_mean(name.text, ports));
  return nullptr;
}

}  // namespace finemote::scenario
