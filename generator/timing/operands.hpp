// Ends of a chain as people name them, to devices of the model.
#pragma once

#include <string>
#include <vector>

#include "generator/timing/analyse.hpp"
#include "generator/timing/topology.hpp"

namespace finemote::gen::timing {

/// Where commands of `device` come out: the actuators at and below it, in registration order; `device` itself where
/// there is none.
std::vector<Rank> actuators_of(const Model& model, const Topology& topology, Rank device);

/// The requirements with every latency that ends in a composite asked of the composite's actuators instead.
std::vector<Requirement> reach_actuators(std::vector<Requirement> requirements, const Model& model,
                                         const Topology& topology);

/// Each text `a -> b`, blanks allowed: device names, or `parent.role` for all children in that role; after the arrow a
/// role stands for the actuators of its children. Reports FM4018 for ends that do not exist.
std::vector<ChainRequest> parse_chains(const Model& model, const std::vector<std::string>& texts,
                                       Diagnostics& diagnostics);

}  // namespace finemote::gen::timing
