// The bounds of the timing analysis as constants and comments of the generated files.
#pragma once

#include <string>

#include "generator/emit/names.hpp"
#include "generator/tasks/bounds.hpp"

namespace finemote::gen {

/// What is proven of the robot as it is written, and of the same robot with monitor and trace built in.
struct ProvenBounds {
  timing::RobotBounds plain, monitored;
};

/// A time that is not below `bound`: `187.31 us` exactly, from a millisecond on `12.146 ms`, rounded up.
std::string bound_text(Duration bound);

/// Sets what templates/device_bound.mustache names.
void set_device_bound(const Plan& plan, const timing::RobotBounds& bounds, DeviceId device, Data& data);

/// Sets what templates/job_bound.mustache names.
void set_job_bound(const timing::RobotBounds& bounds, std::size_t bucket, Data& data);

/// `device`, `response`, `age` and `output` of every device, in schedule order: values of finemote::Bounds.
Data bound_list(const Plan& plan, const timing::RobotBounds& bounds);

/// What finemote::Monitored is made from, for every device, in schedule order.
Data monitored_list(const Plan& plan, const timing::RobotBounds& bounds);

}  // namespace finemote::gen
