// What a robot's parts have to show before its bounds hold, and how long that may take.
#pragma once

#include <nlohmann/json.hpp>

#include "generator/model/robot.hpp"

namespace finemote::gen {

/// `{part, output}` of parts that are up when they have been seen: sensors by their first sample, expanders by their
/// first output.
nlohmann::ordered_json awaited_parts(const Robot& robot);

/// The longest `bring_up_ns` of a type whose part nobody can see to be up.
Duration shortest_bring_up(const Robot& robot);

/// The longest `bring_up_ns` of a descriptor, or what is usual; more where slow jobs set a part up.
Duration longest_bring_up(const Robot& robot);

}  // namespace finemote::gen
