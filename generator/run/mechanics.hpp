// Links, joints and inertials of the URDF to what the emulated board's plants need: bodies, ways to sensors, loads of
// motors.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "generator/model/robot.hpp"

namespace finemote::gen {

/// The link that moves as the plant's body: Mechanism::base(); empty when the robot has no links.
std::string body_link(const Robot& robot);

/// `mass` [kg] and `inertia` (xx xy xz yy yz zz, about the body link's origin [kg m^2]) of the whole robot with every
/// joint at zero. Nothing where no link has a mass.
nlohmann::ordered_json whole_inertia(const Robot& robot);

/// The joints from the body link to `link`, outermost first: `xyz`, `rpy`, and `axis` with the `part` that turns it
/// where an actuator drives it.
nlohmann::ordered_json way_to(const Robot& robot, const std::string& link);

/// What an actuator turns: `load_inertia` [kg m^2] of everything behind its joint about the joint's axis with every
/// further joint at zero, and `viscous` [N m s], `coulomb` [N m], `lower`, `upper` [rad] where the URDF gives them.
nlohmann::ordered_json load_of(const Robot& robot, const std::string& joint);

/// The joints that parts turn, each after those that carry it: `part`, the part `before` it, the `way` from there or
/// from the body link, `axis`, and `mass` [kg] and `centre` [m] of what moves with it but not with those after it.
/// Without the last of a row where they are balanced: a wheel does not pull at itself.
nlohmann::ordered_json hanging_joints(const Robot& robot);

}  // namespace finemote::gen
