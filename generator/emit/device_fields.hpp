// One device as templates/device.mustache and templates/ports.mustache spell it: its object, and the ports, latches and
// arrays its constructor binds to.
#pragma once

#include <vector>

#include "generator/emit/constants.hpp"
#include "generator/emit/scope.hpp"

namespace finemote::gen {

/// Sets what templates/device.mustache names: arguments in the order of the device contract.
void set_device(const Plan& plan, const Scope& scope, DeviceId device, const std::vector<Constant>& constants,
                Data& data);

/// Sets what templates/ports.mustache names: what stands in namespace `ports` before the device, and `has_ports`.
void set_ports(const Plan& plan, const Scope& scope, DeviceId device, const std::vector<Constant>& constants,
               Data& data);

}  // namespace finemote::gen
