// What a descriptor passes on to the model of its part, against what only the robot says of it.
#pragma once

#include <string>
#include <vector>

#include "generator/descriptor/contradictions.hpp"
#include "generator/descriptor/emulation.hpp"
#include "generator/descriptor/param.hpp"

namespace finemote::gen {

/// Reports params that do not exist, and params and values that take the place of what the robot says of a part: its
/// type, name, bus and address.
void check_emulation(const Emulation& emulation, const std::vector<ParamSpec>& params, const Contradictions& found);

/// The same for one member of the part that gets its name from elsewhere in the descriptor, at `path`.
void check_part_member(const std::string& name, const JsonPath& path, const Contradictions& found);

}  // namespace finemote::gen
