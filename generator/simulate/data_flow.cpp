#include "generator/simulate/data_flow.hpp"

#include <algorithm>
#include <map>

namespace finemote::gen {

DataFlow::DataFlow(const timing::Model& model, const timing::Topology& topology, const std::vector<ChainEnds>& chains)
    : model_(model),
      producers_(topology.children),
      state_time_(model.devices.size(), kNothing),
      command_time_(model.devices.size(), kNothing),
      ends_(model.devices.size()) {
  std::map<Rank, std::size_t> known;
  for (std::size_t c = 0; c < chains.size(); ++c) {
    const auto [entry, fresh] = known.emplace(chains[c].from, sources_.size());
    if (fresh) sources_.push_back(chains[c].from);
    ends_[chains[c].to].emplace_back(c, entry->second);
  }
  const std::size_t count = model.devices.size();
  for (const Rank d : model.devices.ids()) {
    const auto& reads = model.devices[d].reads;
    producers_[d].insert(producers_[d].end(), reads.begin(), reads.end());
  }
  const Origins none(sources_.size(), kNothing);
  seen_ = state_ = decided_ = command_ = Table<Rank, Origins>(count, none);
  leads_.assign(count, std::vector<char>(sources_.size(), 0));
  for (std::size_t s = 0; s < sources_.size(); ++s) leads_[sources_[s]][s] = 1;
  // Observed devices may be registered later, so one pass is not enough; the graph has no cycle.
  for (bool changed = true; changed;) {
    changed = false;
    for (const Rank d : model.devices.ids()) {
      for (const Rank p : producers_[d]) {
        for (std::size_t s = 0; s < sources_.size(); ++s) {
          if (leads_[p][s] && !leads_[d][s]) leads_[d][s] = 1, changed = true;
        }
      }
    }
  }
}

void DataFlow::begin_update(Rank device, Duration now) {
  Origins& seen = seen_[device];
  for (std::size_t s = 0; s < sources_.size(); ++s) {
    if (sources_[s] == device) {
      seen[s] = now;
      continue;
    }
    if (!leads_[device][s]) continue;
    Duration oldest = now;
    for (const Rank p : producers_[device]) {
      if (leads_[p][s]) oldest = std::min(oldest, state_[p][s]);
    }
    seen[s] = oldest;
  }
}

void DataFlow::end_update(Rank device, Duration now) {
  state_[device] = seen_[device];
  state_time_[device] = now;
}

void DataFlow::begin_handle(Rank device, Duration) {
  const auto parent = model_.devices[device].parent;
  decided_[device] = parent ? command_[*parent] : seen_[device];
}

void DataFlow::end_handle(Rank device, Duration now, std::vector<Simulation::ChainWorst>& chains) {
  command_[device] = decided_[device];
  command_time_[device] = now;
  for (const auto& [chain, source] : ends_[device]) {
    const Duration origin = decided_[device][source];
    if (origin != kNothing) chains[chain].latency = std::max(chains[chain].latency, now - origin);
  }
}

}  // namespace finemote::gen
