#include "generator/timing/cost_labels.hpp"

namespace finemote::gen::timing {

std::vector<CostLabel> cost_labels(const Model& model) {
  std::vector<CostLabel> labels{{"release and jobs", model.costs.source}};
  for (const Bus& bus : model.buses) {
    if (!bus.sources) continue;
    for (const InterruptSource& source : *bus.sources) labels.push_back({bus.name + "." + source.name, source.source});
  }
  return labels;
}

}  // namespace finemote::gen::timing
