// What the times beside those of the stages rest on.
#pragma once

#include <string>
#include <vector>

#include "generator/timing/model.hpp"

namespace finemote::gen::timing {

struct CostLabel {
  std::string what;  ///< `release and jobs`, an interrupt as `bus.source`
  WcetSource source = WcetSource::unknown;
};

/// Of the scheduler, then of the interrupts in the order of the model.
std::vector<CostLabel> cost_labels(const Model& model);

}  // namespace finemote::gen::timing
