// The bounds of the timing analysis as constants and comments of the generated files.
#pragma once

#include <string>
#include <vector>

#include "generator/emit/names.hpp"
#include "generator/timing/bounds.hpp"

namespace finemote::gen {

/// What is proven of the robot as it is written, and of the same robot with monitor and trace built in.
struct ProvenBounds {
  timing::RobotBounds plain, monitored;
};

/// A time that is not below `ns`: `187.31 us` exactly, from a millisecond on `12.146 ms`, rounded up.
std::string bound_text(std::int64_t ns);

/// `response <= 187.31 us; data age <= 12.146 ms when handle() ends, <= 14.02 ms at the output (oldest: imu)`, or why
/// there is no bound.
std::string bound_comment(const Plan& plan, const timing::RobotBounds& bounds, DeviceId device);

/// `jobs end within 187.31 us`, or why there is no bound.
std::string job_comment(const timing::RobotBounds& bounds, std::size_t bucket);

/// `inline constexpr finemote::Bounds imu{...};` for every device, in schedule order.
std::vector<std::string> bound_constants(const Plan& plan, const timing::RobotBounds& bounds);

/// Initialisers of finemote::Monitored for every device, in schedule order.
std::vector<std::string> monitored_lines(const Plan& plan, const timing::RobotBounds& bounds);

}  // namespace finemote::gen
