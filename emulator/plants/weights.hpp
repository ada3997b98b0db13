// What hangs at driven joints to the torques it pulls at them with.
#pragma once

#include <optional>
#include <vector>

#include "emulator/plants/motor_shaft.hpp"
#include "emulator/plants/mount.hpp"

namespace finemote::emulator {

/// Joints on a body, each with the mass it moves and the joints after it do not. Weight, and the body's acceleration,
/// pull at every joint in the pose of the moment; that joints accelerate does not pull at others.
class Weights {
 public:
  struct Node {
    MotorShaft* shaft = nullptr;        ///< null: the joint stands at zero
    std::optional<std::size_t> before;  ///< the joint that carries this one; none: the body does
    std::vector<JointStep> way;         ///< from the frame of the joint before, turned with it, to this joint's
    Eigen::Vector3d axis = Eigen::Vector3d::UnitX(), centre = Eigen::Vector3d::Zero();  ///< in the joint's frame [m]
    double mass = 0;                                                                    ///< kg
  };
  static constexpr Time kStep = from_ns(1'000'000);

  explicit Weights(Body& body) : body_(body) {}
  /// After the joint that carries it. @return its number
  std::size_t add(const Node& node) {
    nodes_.push_back(node);
    standing_.emplace_back();
    return nodes_.size() - 1;
  }
  /// Finds the torques until the next step. To be called every kStep.
  void step(Time now);

 private:
  /// A joint as it stands, with what hangs at it.
  struct Standing {
    Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();  ///< the joint's, turned, in the body's
    double mass = 0;                                          ///< kg
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();         ///< kg m, in the body's axes
  };

  Body& body_;
  std::vector<Node> nodes_;
  std::vector<Standing> standing_;  ///< one per node
};

}  // namespace finemote::emulator
