#include "generator/simulate/data_flow.hpp"

#include <algorithm>
#include <map>

namespace finemote::gen {

using timing::Ns;

DataFlow::DataFlow(const timing::Model& model, const timing::Topology& topology, const std::vector<ChainEnds>& chains)
    : model_(model),
      producers_(topology.children),
      state_time_(model.devices.size(), kNothing),
      command_time_(model.devices.size(), kNothing),
      ends_(model.devices.size()) {
  std::map<std::size_t, std::size_t> known;
  for (std::size_t c = 0; c < chains.size(); ++c) {
    const auto [entry, fresh] = known.emplace(chains[c].from, sources_.size());
    if (fresh) sources_.push_back(chains[c].from);
    ends_[chains[c].to].emplace_back(c, entry->second);
  }
  const std::size_t n = model.devices.size();
  for (std::size_t d = 0; d < n; ++d) {
    const auto& reads = model.devices[d].reads;
    producers_[d].insert(producers_[d].end(), reads.begin(), reads.end());
  }
  const Origins none(sources_.size(), kNothing);
  seen_ = state_ = decided_ = command_ = std::vector<Origins>(n, none);
  leads_.assign(n, std::vector<char>(sources_.size(), 0));
  for (std::size_t s = 0; s < sources_.size(); ++s) leads_[sources_[s]][s] = 1;
  // Observed devices may be registered later, so one pass is not enough; the graph has no cycle.
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t d = 0; d < n; ++d) {
      for (const std::size_t p : producers_[d]) {
        for (std::size_t s = 0; s < sources_.size(); ++s) {
          if (leads_[p][s] && !leads_[d][s]) leads_[d][s] = 1, changed = true;
        }
      }
    }
  }
}

void DataFlow::begin_update(std::size_t device, Ns now) {
  Origins& seen = seen_[device];
  for (std::size_t s = 0; s < sources_.size(); ++s) {
    if (sources_[s] == device) {
      seen[s] = now;
      continue;
    }
    if (!leads_[device][s]) continue;
    Ns oldest = now;
    for (const std::size_t p : producers_[device]) {
      if (leads_[p][s]) oldest = std::min(oldest, state_[p][s]);
    }
    seen[s] = oldest;
  }
}

void DataFlow::end_update(std::size_t device, Ns now) {
  state_[device] = seen_[device];
  state_time_[device] = now;
}

void DataFlow::begin_handle(std::size_t device, Ns) {
  const auto parent = model_.devices[device].parent;
  decided_[device] = parent ? command_[*parent] : seen_[device];
}

void DataFlow::end_handle(std::size_t device, Ns now, std::vector<Simulation::ChainWorst>& chains) {
  command_[device] = decided_[device];
  command_time_[device] = now;
  for (const auto& [chain, source] : ends_[device]) {
    const Ns origin = decided_[device][source];
    if (origin != kNothing) chains[chain].latency = std::max(chains[chain].latency, now - origin);
  }
}

}  // namespace finemote::gen
