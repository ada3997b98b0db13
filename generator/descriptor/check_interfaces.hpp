// Interfaces that a descriptor names and nobody has: FM3103.
#pragma once

#include "generator/descriptor/contradictions.hpp"
#include "generator/descriptor/device_type.hpp"
#include "generator/descriptor/link_fields.hpp"

namespace finemote::gen {

/// Names without a namespace are those of finemote, whose sizes the analysis knows: each has to be among `shipped`, or
/// `any`.
void check_interfaces(const DeviceType& type, const InterfaceTable& shipped, const Contradictions& found);

}  // namespace finemote::gen
