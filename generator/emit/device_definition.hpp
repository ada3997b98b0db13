// One device as C++: its inline object, and the ports, latches and arrays its constructor binds to.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "generator/emit/constants.hpp"
#include "generator/emit/names.hpp"

namespace finemote::gen {

/// `FINEMOTE_CONSTINIT inline finemote::Ms5837 baro_1{...};`, arguments in the order of the device contract.
std::string device_definition(const Plan& plan, DeviceId device, const std::vector<Constant>& constants);

/// Lines of namespace `ports` that must stand before the device: copies, latches, sinks, arrays.
std::vector<std::string> port_lines(const Plan& plan, DeviceId device);

}  // namespace finemote::gen
