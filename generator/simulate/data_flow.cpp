#include "generator/simulate/data_flow.hpp"

#include <set>

namespace finemote::gen {

DataFlow::DataFlow(const timing::Model& model, const timing::Topology& topology, const std::vector<ChainEnds>& chains)
    : model_(model),
      leads_(model.devices.size()),
      inputs_(model.devices.size()),
      seen_(model.devices.size()),
      decided_(model.devices.size()),
      state_time_(model.devices.size(), kNothing),
      command_time_(model.devices.size(), kNothing),
      ends_(model.devices.size()) {
  find_leads(topology, chains);
  for (const Rank d : model.devices.ids()) {
    seen_[d].assign(leads_[d].size(), kNothing);
    decided_[d].assign(leads_[topology.root_of[d]].size(), kNothing);
    std::vector<Rank> producers = topology.children[d];
    producers.insert(producers.end(), model.devices[d].reads.begin(), model.devices[d].reads.end());
    for (const Rank p : producers) {
      for (std::size_t i = 0; i < leads_[p].size(); ++i) inputs_[d].push_back({p, i, place(d, leads_[p][i])});
    }
  }
  state_ = seen_;
  command_ = decided_;
  for (std::size_t c = 0; c < chains.size(); ++c) {
    const auto& [from, to] = chains[c];
    const Rank root = topology.root_of[to];
    if (std::binary_search(leads_[root].begin(), leads_[root].end(), from)) ends_[to].push_back({c, place(root, from)});
  }
}

void DataFlow::find_leads(const timing::Topology& topology, const std::vector<ChainEnds>& chains) {
  Table<Rank, std::vector<Rank>> consumers(model_.devices.size());
  for (const Rank d : model_.devices.ids()) {
    for (const Rank child : topology.children[d]) consumers[child].push_back(d);
    for (const Rank read : model_.devices[d].reads) consumers[read].push_back(d);
  }
  std::set<Rank> sources;
  for (const ChainEnds& chain : chains) sources.insert(chain.from);
  for (const Rank source : sources) {
    std::vector<Rank> reached{source};
    while (!reached.empty()) {
      const Rank d = reached.back();
      reached.pop_back();
      if (!leads_[d].empty() && leads_[d].back() == source) continue;
      leads_[d].push_back(source);
      reached.insert(reached.end(), consumers[d].begin(), consumers[d].end());
    }
  }
}

std::size_t DataFlow::place(Rank device, Rank source) const {
  const std::vector<Rank>& leads = leads_[device];
  return static_cast<std::size_t>(std::lower_bound(leads.begin(), leads.end(), source) - leads.begin());
}

void DataFlow::begin_update(Rank device, Duration now) {
  Origins& seen = seen_[device];
  std::fill(seen.begin(), seen.end(), now);
  for (const Input& input : inputs_[device])
    seen[input.to] = std::min(seen[input.to], state_[input.producer][input.from]);
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
