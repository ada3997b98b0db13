#include "forests/random_forest.hpp"

#include <algorithm>

#include "generator/simulate/random.hpp"

namespace finemote::test {
namespace {

using gen::Random;

std::size_t depth_of(const RandomForest& forest, std::size_t device) {
  std::size_t depth = 0;
  for (auto up = forest.devices[device].parent; up; up = forest.devices[*up].parent) ++depth;
  return depth;
}

bool is_above(const RandomForest& forest, std::size_t upper, std::size_t device) {
  for (std::optional<std::size_t> up = device; up; up = forest.devices[*up].parent) {
    if (*up == upper) return true;
  }
  return false;
}

int pick(Random& random, const std::vector<int>& values) {
  return values[static_cast<std::size_t>(random.between(0, static_cast<std::int64_t>(values.size()) - 1))];
}

/// Reads only of devices that come earlier in creation and are not in the reader's own subtree or above it: with tree
/// edges from later to earlier this could still close a cycle through a tree, so the observed tree must be another one
/// with a smaller root.
void add_reads(RandomForest& forest, Random& random) {
  const auto root_of = [&](std::size_t device) {
    while (forest.devices[device].parent) device = *forest.devices[device].parent;
    return device;
  };
  for (std::size_t reader = 0; reader < forest.devices.size(); ++reader) {
    if (!random.one_in(4)) continue;
    const auto seen = static_cast<std::size_t>(random.between(0, static_cast<std::int64_t>(forest.devices.size()) - 1));
    if (root_of(seen) < root_of(reader) && !is_above(forest, seen, reader))
      forest.devices[reader].reads.push_back(seen);
  }
}

void write_device(const RandomForest& forest, std::size_t index, const std::string& indent, std::string& text) {
  const RandomDevice& device = forest.devices[index];
  text += indent + "<device name=\"" + device.name + "\" type=\"sim_load\" period=\"" +
          std::to_string(device.period_ms) + "ms\"";
  if (device.by_attribute) text += " parent=\"" + forest.devices[*device.parent].name + "\" role=\"children\"";
  text += ">\n" + indent + "  <param name=\"update\">" + std::to_string(device.update_us) + "us</param>\n" + indent +
          "  <param name=\"handle\">" + std::to_string(device.handle_us) + "us</param>\n";
  for (std::size_t child = index + 1; child < forest.devices.size(); ++child) {
    const RandomDevice& c = forest.devices[child];
    if (c.parent == index && !c.by_attribute) write_device(forest, child, indent + "  ", text);
  }
  for (std::size_t seen : device.reads) {
    text += indent + "  <reads device=\"" + forest.devices[seen].name + "\" role=\"children\"/>\n";
  }
  text += indent + "</device>\n";
}

/// Devices that are written at the top: roots, and those with parent=.
std::vector<std::size_t> top_level(const RandomForest& forest) {
  std::vector<std::size_t> tops;
  for (std::size_t i = 0; i < forest.devices.size(); ++i) {
    if (!forest.devices[i].parent || forest.devices[i].by_attribute) tops.push_back(i);
  }
  // Every third forest backwards: a parent that stands after its child.
  if (forest.devices.size() % 3 == 0) std::reverse(tops.begin(), tops.end());
  return tops;
}

void collect_tags(const RandomForest& forest, std::size_t index, std::vector<std::size_t>& tags) {
  tags.push_back(index);
  for (std::size_t child = index + 1; child < forest.devices.size(); ++child) {
    if (forest.devices[child].parent == index && !forest.devices[child].by_attribute) collect_tags(forest, child, tags);
  }
}

}  // namespace

RandomForest random_forest(std::uint64_t seed) {
  static const std::vector<std::vector<int>> kPeriods{{5}, {1, 2, 4}, {2, 5, 10}, {3, 4, 7}, {1, 10}};
  Random random(seed);
  RandomForest forest;
  forest.name = "forest" + std::to_string(seed);
  const std::vector<int>& periods = kPeriods[static_cast<std::size_t>(random.between(0, 4))];
  const auto count = static_cast<std::size_t>(random.between(1, 14));
  for (std::size_t i = 0; i < count; ++i) {
    RandomDevice device;
    device.name = "d" + std::to_string(i) + (random.one_in(3) ? "-x" : "");
    if (i > 0 && !random.one_in(4)) {
      const auto parent = static_cast<std::size_t>(random.between(0, static_cast<std::int64_t>(i) - 1));
      if (depth_of(forest, parent) < 5) device.parent = parent;
    }
    device.by_attribute = device.parent && random.one_in(5);
    device.period_ms = pick(random, periods);
    device.update_us = pick(random, {0, 1, 5, 15});
    device.handle_us = pick(random, {0, 1, 5, 15});
    forest.devices.push_back(device);
  }
  add_reads(forest, random);
  return forest;
}

std::string to_urdf(const RandomForest& forest) {
  std::string text = "<robot name=\"" + forest.name + "\">\n  <link name=\"base_link\"/>\n  <finemote version=\"1\">\n";
  text += "    <board name=\"host\"/>\n";
  for (std::size_t top : top_level(forest)) write_device(forest, top, "    ", text);
  return text + "  </finemote>\n</robot>\n";
}

std::vector<std::size_t> tag_order(const RandomForest& forest) {
  std::vector<std::size_t> tags;
  for (std::size_t top : top_level(forest)) collect_tags(forest, top, tags);
  return tags;
}

}  // namespace finemote::test
