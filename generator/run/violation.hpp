// What a scenario does to the assumptions of the bounds, and which figures rest on them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/run/chains.hpp"

namespace finemote::gen {

/// @param part, port  that an event of a scenario names; empty: none
Violation violation_of(const std::string& assumption, const std::string& part, const std::string& port,
                       const Robot& robot);

/// Each once, in their order.
std::vector<std::string> assumptions_of(const std::vector<Violation>& violations);

/// Over whose buses the data of a figure go: from the part of one device, to that of another.
struct Journey {
  std::optional<DeviceId> sampled, commanded;
};
/// @param figure  one of kChainFigures
Journey journey_of(const MeasuredChain& chain, Measured MeasuredChain::*figure);

/// The violated assumption that the bound of a figure rests on; none: it has to hold. Errors on a serial line touch
/// what goes over it, and nothing that the processor does; other buses may have to be recovered, which jobs do.
std::optional<std::string> violated_assumption(const Robot& robot, const std::vector<Violation>& violations,
                                               const Journey& journey);

}  // namespace finemote::gen
