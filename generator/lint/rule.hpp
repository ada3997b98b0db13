// A rule of lint: a number, what it says in words, and the function that looks for it in one part of a robot.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "generator/geometry/mechanism.hpp"
#include "generator/lint/findings.hpp"
#include "generator/units/duration.hpp"

namespace finemote::gen {

/// The oldest data behind a device's command, at the end of its handle().
struct CommandAge {
  Duration value;          ///< by time stamps, which devices look at; the true age where those have no bound
  DeviceId source;         ///< whose sample
  bool is_stamped = true;  ///< it is by time stamps
};

/// A bus, with what the timing analysis says of it.
struct CheckedBus {
  const Robot& robot;
  BusId id;
  double load;                 ///< from 0 on, of the bus's capacity; 0: not known
  double most_load;            ///< 0..1: what it may be
  const Diagnostic* overload;  ///< FM4021; null: it has time for all

  [[nodiscard]] const Bus& bus() const { return robot.buses[id]; }
  [[nodiscard]] bool is_busy() const { return load > most_load; }
};

/// A device, with what the timing analysis says of it.
struct CheckedDevice {
  const Robot& robot;
  const Device& device;
  std::optional<CommandAge> command_age;  ///< proven; none: not known
};

/// One geometry entry of a device.
struct CheckedGeometry {
  const Robot& robot;
  const Device& device;
  const GeometrySpec& geometry;
  Mechanism mechanism;
  std::vector<std::string> joints;  ///< those it is computed of; empty: none
  std::string link;                 ///< in whose frame its constants are; empty without joints

  [[nodiscard]] const Joint& joint(const std::string& name) const { return *mechanism.joint(name); }
  /// The child on one of `joints`.
  [[nodiscard]] const Device& child_of(const std::string& name) const;
};

/// Looks at one part of a robot.
template <typename Part>
using Check = void (*)(const Part&, Findings&);

struct Rule {
  Code code;
  std::string_view finding;  ///< what is wrong: `a bus is unused`
  std::variant<Check<CheckedBus>, Check<CheckedDevice>, Check<CheckedGeometry>, Check<Robot>> check;
};

}  // namespace finemote::gen
