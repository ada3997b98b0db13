#include "generator/lint/lint.hpp"

#include <algorithm>
#include <span>

#include "generator/geometry/frame.hpp"
#include "generator/lint/rules.hpp"
#include "generator/model/device_frames.hpp"

namespace finemote::gen {
namespace {

bool contains(const std::vector<Code>& codes, Code code) {
  return std::find(codes.begin(), codes.end(), code) != codes.end();
}

CheckedBus checked_bus(const Robot& robot, BusId index, const LintOptions& options) {
  const Position& at = robot.buses[index].at;
  const auto overload = std::find_if(options.overloads.begin(), options.overloads.end(),
                                     [&](const Diagnostic& finding) { return finding.at == at; });
  return {robot, index, options.bus_load.contains(index) ? options.bus_load[index] : 0, options.most_bus_load,
          overload == options.overloads.end() ? nullptr : &*overload};
}

CheckedDevice checked_device(const Robot& robot, DeviceId index, const LintOptions& options) {
  const bool is_known = options.command_ages.contains(index);
  return {robot, robot.devices[index], is_known ? options.command_ages[index] : std::nullopt};
}

std::vector<CheckedGeometry> checked_geometries(const Robot& robot, const Device& device) {
  std::vector<CheckedGeometry> all;
  for (const GeometrySpec& geometry : device.type->geometry) {
    const Mechanism mechanism(robot.links, robot.joints);
    const std::vector<std::string> joints = role_joints(robot, device, geometry);
    const std::string link = joints.empty() ? "" : geometry_link(mechanism, device.link, geometry, joints);
    all.push_back({robot, device, geometry, mechanism, joints, link});
  }
  return all;
}

/// The rules that are not allowed, each with the parts of a robot that it looks at.
class Linter {
 public:
  Linter(const LintOptions& options, Diagnostics& diagnostics) : options_(options), diagnostics_(diagnostics) {}

  /// Runs the rules for parts of this kind, one after the other.
  template <typename Part>
  void check(std::span<const Part> parts) {
    for (const Rule& rule : lint_rules()) {
      const auto* looks_at = std::get_if<Check<Part>>(&rule.check);
      if (looks_at == nullptr || contains(options_.allow, rule.code)) continue;
      Findings findings(rule.code, is_denied(rule.code), diagnostics_, fixes_);
      for (const Part& part : parts) (*looks_at)(part, findings);
    }
  }
  template <typename Part>
  void check(const Part& part) {
    check(std::span(&part, 1));
  }

  std::vector<Fix> take_fixes() { return std::move(fixes_); }

 private:
  /// Denying a busy bus (FM3155) also denies an overloaded one.
  [[nodiscard]] bool is_denied(Code code) const {
    return contains(options_.deny, code) ||
           (code == code::timing_bus_overload && contains(options_.deny, code::lint_bus_load));
  }

  const LintOptions& options_;
  Diagnostics& diagnostics_;
  std::vector<Fix> fixes_;
};

}  // namespace

std::vector<Fix> lint(const Robot& robot, const LintOptions& options, Diagnostics& diagnostics) {
  Linter linter(options, diagnostics);
  for (const BusId i : robot.buses.ids()) linter.check(checked_bus(robot, i, options));
  for (const DeviceId i : robot.devices.ids()) {
    linter.check(checked_device(robot, i, options));
    linter.check(std::span<const CheckedGeometry>(checked_geometries(robot, robot.devices[i])));
  }
  linter.check(robot);
  return linter.take_fixes();
}

}  // namespace finemote::gen
