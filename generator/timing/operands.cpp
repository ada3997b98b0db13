#include "generator/timing/operands.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/diagnostic/suggest.hpp"
#include "generator/units/operand_text.hpp"

namespace finemote::gen::timing {
namespace {

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

bool is_actuator(const Device& device) {
  return device.actuator ||
         std::any_of(device.transfers.begin(), device.transfers.end(), [](const Transfer& t) { return t.command; });
}

/// One end of a chain: whom it names, and whether it did so by role.
struct Operand {
  std::vector<Rank> devices;
  bool is_role = false;
};

class OperandReader {
 public:
  OperandReader(const Model& model, Diagnostics& diagnostics) : model_(model), diagnostics_(diagnostics) {}

  Operand read(std::string_view text) {
    const OperandText words = split_operand(text, [&](std::string_view name) { return find(name).has_value(); });
    const auto device = find(words.device);
    if (!device) return report_unknown(words.device), Operand{};
    if (words.is_role) return {children_in(*device, words.role), true};
    return {{*device}, false};
  }

 private:
  [[nodiscard]] std::optional<Rank> find(std::string_view name) const {
    for (const Rank d : model_.devices.ids()) {
      if (model_.devices[d].name == name) return d;
    }
    return std::nullopt;
  }

  std::vector<Rank> children_in(Rank parent, std::string_view role) {
    std::vector<Rank> found;
    std::vector<std::string> roles;
    for (const Rank d : model_.devices.ids()) {
      const Device& device = model_.devices[d];
      if (device.parent != parent || device.role.empty()) continue;
      if (device.role == role) found.push_back(d);
      if (std::find(roles.begin(), roles.end(), device.role) == roles.end()) roles.push_back(device.role);
    }
    if (found.empty()) {
      suggest(diagnostics_.error(
                  code::timing_chain, model_.devices[parent].at,
                  fmt::format("device '{}' has no child in the role '{}'", model_.devices[parent].name, role)),
              role, roles);
    }
    return found;
  }

  void report_unknown(std::string_view name) {
    std::vector<std::string> names;
    for (const Device& device : model_.devices) names.push_back(device.name);
    suggest(diagnostics_.error(code::timing_chain, {}, fmt::format("there is no device '{}'", name)), name, names);
  }

  const Model& model_;
  Diagnostics& diagnostics_;
};

std::vector<Rank> actuators_of_all(const Model& model, const std::vector<Rank>& devices) {
  const Topology topology = make_topology(model);
  std::vector<Rank> all;
  for (const Rank d : devices) {
    const auto reached = actuators_of(model, topology, d);
    all.insert(all.end(), reached.begin(), reached.end());
  }
  return all;
}

std::vector<ChainRequest> parse_chain(const Model& model, std::string_view text, Diagnostics& diagnostics) {
  const auto arrow = text.find("->");
  if (arrow == std::string_view::npos) {
    diagnostics.error(code::timing_chain, {}, fmt::format("'{}' is not a chain", text))
        .hint("--chain 'sensor->actuator'");
    return {};
  }
  OperandReader reader(model, diagnostics);
  const Operand from = reader.read(trimmed(text.substr(0, arrow)));
  Operand to = reader.read(trimmed(text.substr(arrow + 2)));
  if (to.is_role) to.devices = actuators_of_all(model, to.devices);
  std::vector<ChainRequest> chains;
  for (const Rank a : from.devices) {
    for (const Rank b : to.devices) chains.push_back({a, b});
  }
  return chains;
}

}  // namespace

std::vector<Rank> actuators_of(const Model& model, const Topology& topology, Rank device) {
  std::vector<Rank> found, stack{device};
  while (!stack.empty()) {
    const Rank d = stack.back();
    stack.pop_back();
    if (is_actuator(model.devices[d])) found.push_back(d);
    for (const Rank child : topology.children[d]) {
      if (model.devices[child].takes_command) stack.push_back(child);
    }
  }
  if (found.empty()) found.push_back(device);
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<Requirement> reach_actuators(std::vector<Requirement> requirements, const Model& model,
                                         const Topology& topology) {
  for (Requirement& requirement : requirements) {
    if (!requirement.is_latency()) continue;
    std::vector<Rank> ends;
    for (const Rank to : requirement.to) {
      const auto reached = actuators_of(model, topology, to);
      ends.insert(ends.end(), reached.begin(), reached.end());
    }
    requirement.to = std::move(ends);
  }
  return requirements;
}

std::vector<ChainRequest> parse_chains(const Model& model, const std::vector<std::string>& texts,
                                       Diagnostics& diagnostics) {
  std::vector<ChainRequest> chains;
  for (const std::string& text : texts) {
    const auto named = parse_chain(model, text, diagnostics);
    chains.insert(chains.end(), named.begin(), named.end());
  }
  return chains;
}

}  // namespace finemote::gen::timing
