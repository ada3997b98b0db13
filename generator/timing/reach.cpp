#include "generator/timing/reach.hpp"

#include <algorithm>
#include <set>

namespace finemote::gen::timing {

Reach::Reach(const Model& model, const Topology& topology)
    : model_(model), topology_(topology), consumers_(model.devices.size()), reads_in_tree_of_(model.devices.size()) {
  for (const Rank d : model.devices.ids()) {
    const Device& device = model.devices[d];
    if (device.parent) consumers_[d].push_back(*device.parent);
    for (const Rank observed : device.reads) consumers_[observed].push_back(d);
    if (!device.reads.empty()) reads_in_tree_of_[topology.root_of[d]] = true;
  }
}

bool Reach::ends_at(Rank producer, Rank consumer) const {
  const auto& ends = model_.devices[consumer].ends_here;
  return std::find(ends.begin(), ends.end(), producer) != ends.end();
}

bool Reach::connected(Rank from, Rank to) const {
  std::set<Rank> goals{to};  // every device whose handle() has a part in the command of `to`
  for (Rank d = to; model_.devices[d].parent; d = *model_.devices[d].parent) goals.insert(*model_.devices[d].parent);
  std::vector<Rank> stack{from};
  std::set<Rank> seen{from};
  while (!stack.empty()) {
    const Rank device = stack.back();
    stack.pop_back();
    if (goals.contains(device)) return true;
    for (const Rank consumer : consumers_[device]) {
      if (consumer != to && ends_at(device, consumer)) continue;
      if (seen.insert(consumer).second) stack.push_back(consumer);
    }
  }
  return false;
}

Reach::Turns Reach::turns_above(Rank to) const {
  Turns turns;
  if (!model_.devices[to].ends_here.empty()) turns.end = to;
  add_turns(to, turns);
  return turns;
}

Reach::Turns Reach::turns_into_command(Rank to) const {
  Turns turns;
  add_turns(*model_.devices[to].parent, turns);
  return turns;
}

void Reach::add_turns(Rank from, Turns& turns) const {
  Rank d = from;
  for (; model_.devices[d].parent; d = *model_.devices[d].parent) {
    if (ends_at(d, *model_.devices[d].parent) || turns.end == d) turns.devices.push_back(d);
  }
  turns.devices.push_back(d);
}

std::vector<Rank> Reach::sources_of(const Turns& turns) const {
  std::vector<Rank> stack = turns.devices, sources;
  std::set<Rank> seen(stack.begin(), stack.end());
  while (!stack.empty()) {
    const Rank device = stack.back();
    stack.pop_back();
    if (topology_.children[device].empty() || model_.devices[device].acquisition) sources.push_back(device);
    std::vector<Rank> producers = topology_.children[device];
    producers.insert(producers.end(), model_.devices[device].reads.begin(), model_.devices[device].reads.end());
    for (const Rank producer : producers) {
      if (device != turns.end && ends_at(producer, device)) continue;
      if (seen.insert(producer).second) stack.push_back(producer);
    }
  }
  std::sort(sources.begin(), sources.end());
  return sources;
}

}  // namespace finemote::gen::timing
