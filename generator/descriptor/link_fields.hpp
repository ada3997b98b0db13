// What a link to a computer carries of a State or Command: `state_fields` and `command_fields` of a device descriptor,
// and `schemas/interfaces.json` for the interfaces that are shipped.
#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace finemote::gen {

/// One value.
struct LinkField {
  std::string name;
  std::string type;    ///< `float`, `uint16`
  unsigned count = 0;  ///< of an array; 0: a single value
};

/// Of one interface; none: only its Stamp is known.
struct InterfaceFields {
  std::optional<std::vector<LinkField>> state, command;
};

/// By the name of the interface: `Imu`.
using InterfaceTable = std::map<std::string, InterfaceFields>;

/// Reads the named member of `owner`; none where it is absent.
std::optional<std::vector<LinkField>> read_link_fields(const nlohmann::ordered_json& owner, const char* member);

/// What `interfaces.json` in the folder of the shipped schemas says. Throws std::runtime_error without the file.
InterfaceTable shipped_interfaces(const std::string& schema_dir);

}  // namespace finemote::gen
