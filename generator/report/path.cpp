#include "generator/report/path.hpp"

#include <algorithm>
#include <deque>
#include <optional>

namespace finemote::gen::report {
namespace {

std::vector<Rank> to_root(const timing::Model& model, Rank device) {
  std::vector<Rank> all{device};
  while (model.devices[all.back()].parent) all.push_back(*model.devices[all.back()].parent);
  return all;
}

Table<Rank, std::vector<Rank>> readers_of(const timing::Model& model) {
  Table<Rank, std::vector<Rank>> readers(model.devices.size());
  for (const Rank d : model.devices.ids()) {
    for (const Rank read : model.devices[d].reads) readers[read].push_back(d);
  }
  return readers;
}

/// From `from` to `to`, breadth first; empty where no data lead there.
std::vector<Rank> way(const timing::Model& model, Rank from, Rank to) {
  const auto readers = readers_of(model);
  Table<Rank, std::optional<Rank>> came_from(model.devices.size());
  std::deque<Rank> waiting{from};
  came_from[from] = from;
  while (!waiting.empty() && !came_from[to]) {
    const Rank here = waiting.front();
    waiting.pop_front();
    std::vector<Rank> next = readers[here];
    if (const auto parent = model.devices[here].parent) next.insert(next.begin(), *parent);
    for (const Rank one : next) {
      if (came_from[one]) continue;
      came_from[one] = here;
      waiting.push_back(one);
    }
  }
  if (!came_from[to]) return {};
  std::vector<Rank> all{to};
  while (all.back() != from) all.push_back(*came_from[all.back()]);
  std::reverse(all.begin(), all.end());
  return all;
}

}  // namespace

Path path_of(const timing::Model& model, Rank from, Rank to) {
  Path path;
  path.down = to_root(model, to);
  std::reverse(path.down.begin(), path.down.end());
  path.up = way(model, from, path.down.front());
  return path;
}

}  // namespace finemote::gen::report
