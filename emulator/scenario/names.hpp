// Names of parts and ports in a scenario to what they stand for, or to what was likely meant.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "emulator/scenario/check.hpp"

namespace finemote::scenario {

/// The list has this name.
bool contains(const std::vector<std::string>& names, const std::string& name);

/// Reports FM6007 at a name that stands for nothing, or not for what it has to.
class Names {
 public:
  using Value = gen::json::Value;
  Names(const World& world, gen::Diagnostics& diagnostics)
      : parts_(world.parts), ports_(world.ports), diagnostics_(diagnostics) {}

  /// The world's parts, then the scenario's own.
  [[nodiscard]] const std::vector<World::Part>& parts() const { return parts_; }
  [[nodiscard]] const World::Part* find(const std::string& name) const;
  /// Adds a part, or puts it in place of a device without a model. @return false: there is one of this name already
  bool add(const World::Part& part);

  /// The model of the part that is named; null after a report.
  const Model* model_of(const Value& name);
  /// A `name` that has to be what the row says: one of its `choices`.
  void reference(const Member& row, const Value& name);
  /// A port of the row's kind that a part can hang at.
  void port(const Member& row, const Value& name);
  /// A port that something can happen to; null after a report.
  const PortKind* port_in_use(const Value& name);

 private:
  gen::Diagnostic& unknown(const Value& name, std::string message);
  [[nodiscard]] bool has_bus(const std::string& port) const;
  /// Those of a kind (null: of all) that are in use, for hints.
  [[nodiscard]] std::vector<std::string> ports_in_use(const PortKind* kind) const;

  std::vector<World::Part> parts_;
  std::optional<std::vector<std::string>> ports_;
  gen::Diagnostics& diagnostics_;
};

}  // namespace finemote::scenario
