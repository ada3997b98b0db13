// A device descriptor to what the generator needs of it, and what descriptors of expanders have in common with it.
#pragma once

#include "generator/descriptor/device_type.hpp"
#include "generator/descriptor/json_file.hpp"

namespace finemote::gen {

/// Reads a descriptor that its schema accepts. Reports FM3103 for what contradicts itself: a role or use twice, max
/// below min, geometry of a role that does not exist, a WCET param that does not exist, and what read_params() finds.
DeviceType read_device_type(const Json& value, const Origin& origin, Diagnostics& diagnostics);

/// The 7-bit address a descriptor writes as `0x76`.
std::uint32_t parse_hex(const std::string& text);

/// The addresses that `address` of a bus allows; empty: any.
std::vector<std::uint32_t> read_addresses(const Json& address);

/// How generated code includes a header: what stands after `runtime/include/`, else the file's name.
std::string include_name(const std::string& header);

}  // namespace finemote::gen
