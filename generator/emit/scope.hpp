// A thing of the robot to how generated code names it: as short as the place allows, by its whole name where a shorter
// one would be another thing.
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>

#include "generator/emit/names.hpp"

namespace finemote::gen {

/// The namespace from inside of which things are named, that of a tree for one.
///
/// C++ looks outwards: a name of the robot's namespace can be written alone unless the tree declares the same one: a
/// device, or what is generated beside devices (`ports`, `update_5ms`, `Stage`).
class Scope {
 public:
  /// The namespace of the tree of `inside`.
  Scope(const Plan& plan, DeviceId inside);

  /// Namespace `slots` of the robot.
  static Scope in_slots(const Plan& plan);

  /// The same, from inside of the tree's namespace `ports`, whose names all begin with that of a device: `imu_to_rov`.
  [[nodiscard]] Scope ports() const;

  /// A bus, slot or constant: `imu_uart`, `slots::imu`, or `::FinsROV::imu_uart` where a device is called so.
  [[nodiscard]] std::string of_robot(const std::string& cpp_name) const;

  /// `imu` inside its own tree, `rov::imu` from another.
  [[nodiscard]] std::string device(DeviceId device) const;

  /// A name of namespace `ports` of the tree of `home`: `ports::imu_to_rov`, `rov::ports::imu_to_rov` from another
  /// tree.
  [[nodiscard]] std::string port(DeviceId home, const std::string& name) const;

 private:
  using Names = std::set<std::string>;
  explicit Scope(const Plan& plan) : plan_(plan) {}
  [[nodiscard]] bool hides(const std::string& name) const;
  [[nodiscard]] const Tree& tree_of(DeviceId device) const;
  [[nodiscard]] bool is_here(DeviceId device) const;

  const Plan& plan_;
  std::optional<std::size_t> tree_;        ///< none: outside of all
  std::shared_ptr<const Names> declared_;  ///< one for a scope and its ports()
  bool in_ports_ = false;
};

}  // namespace finemote::gen
