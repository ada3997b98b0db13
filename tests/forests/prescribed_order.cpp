#include "forests/prescribed_order.hpp"

#include <algorithm>

namespace finemote::test {
namespace {

/// Children first, in the order of their tags, the device last.
void leaf_to_root(const RandomForest& forest, const std::vector<std::size_t>& tags, std::size_t device,
                  std::vector<std::size_t>& sequence) {
  for (std::size_t candidate : tags) {
    if (forest.devices[candidate].parent == device) leaf_to_root(forest, tags, candidate, sequence);
  }
  sequence.push_back(device);
}

}  // namespace

std::map<int, std::vector<std::string>> prescribed_order(const RandomForest& forest) {
  const std::vector<std::size_t> tags = tag_order(forest);
  std::vector<std::size_t> sequence;
  for (std::size_t device : tags) {
    if (!forest.devices[device].parent) leaf_to_root(forest, tags, device, sequence);
  }
  std::map<int, std::vector<std::string>> jobs;
  for (std::size_t device : sequence)
    jobs[forest.devices[device].period_ms].push_back("+" + forest.devices[device].name);
  std::reverse(sequence.begin(), sequence.end());
  for (std::size_t device : sequence)
    jobs[forest.devices[device].period_ms].push_back("-" + forest.devices[device].name);
  return jobs;
}

}  // namespace finemote::test
