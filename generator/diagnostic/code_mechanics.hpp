// The numbers of what lint says of joints, masses and places; the others are in code.hpp.
#pragma once

#include "generator/diagnostic/code.hpp"

namespace finemote::gen::code {

inline constexpr Code lint_sensor_place{3163};   // a sensor is not on what its user moves, or moves against it
inline constexpr Code lint_wheel_limits{3164};   // a wheel or thruster on a joint that cannot turn round
inline constexpr Code lint_moved_joint{3165};    // constants that hold only while another driven joint is at zero
inline constexpr Code lint_no_mass{3166};        // an arm without mass whose weight is to be carried
inline constexpr Code lint_same_place{3167};     // two thrusters in one place, along one line
inline constexpr Code lint_param_range{3168};    // a param allows angles beyond the limits of the joint
inline constexpr Code lint_other_command{3169};  // ROS commands a joint what its device does not take
inline constexpr Code lint_half_actuator{3170};  // takes no commands, or takes some and is never made safe

}  // namespace finemote::gen::code
