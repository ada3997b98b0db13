// The model of a part on the emulated board: `emulation` of a device descriptor.
#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace finemote::gen {

struct Emulation {
  std::string part;                 ///< type of the part in a scenario; empty: the device has none of its own
  std::vector<std::string> params;  ///< params of the device passed on by their names
  /// Figures of the part itself, passed on as they are: the emulator reads them. Null: none.
  std::shared_ptr<const nlohmann::ordered_json> values;
  std::string body;    ///< what the device makes of the robot's body; empty: nothing
  std::string wheels;  ///< the role whose children turn the wheels
};

/// Reads a member that the schema accepts.
Emulation read_emulation(const nlohmann::ordered_json& value);

}  // namespace finemote::gen
