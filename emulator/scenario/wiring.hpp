// Parts at their places to where they stand in each other's way.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "emulator/scenario/names.hpp"

namespace finemote::scenario {

/// Judges nothing in a world that does not judge wiring.
class Wiring {
 public:
  using Value = gen::json::Value;
  Wiring(const World& world, const Names& names, gen::Diagnostics& diagnostics)
      : world_(world), names_(names), diagnostics_(diagnostics) {}

  /// Reports FM6004 for what only one part can have, an address that is taken, and an expander of the scenario's own
  /// (`later`: names that are still to come) that is not there yet.
  void judge(const Value& entry, const Place& place, const std::set<std::string>& later);
  /// Reports FM6007 for a `nack` of an address that no part behind the port has.
  void is_heard(const Value& event);

 private:
  gen::Diagnostic& at(gen::Code code, const Value& value, std::string message);
  void wired_in_order(const Value& entry, const std::set<std::string>& later);
  void same_address(const Value& entry, const Place& place);
  [[nodiscard]] std::vector<std::string> buses_above(const Place& place) const;

  const World& world_;
  const Names& names_;
  gen::Diagnostics& diagnostics_;
};

}  // namespace finemote::scenario
