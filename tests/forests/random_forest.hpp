// A seed to a robot nobody has seen: a forest of sim_load and group devices with periods, nesting and `reads`.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace finemote::test {

struct RandomDevice {
  std::string name;
  std::optional<std::size_t> parent;  ///< index, smaller than the own one
  bool by_attribute = false;          ///< written with parent="..." instead of nested
  int period_ms = 1;
  int update_us = 0, handle_us = 0;
  std::vector<std::size_t> reads;
};

struct RandomForest {
  std::string name;
  std::vector<RandomDevice> devices;
};

/// 1 to 14 devices, 1 to 4 trees, depth up to 6, harmonic and other periods, utilisation below one half.
RandomForest random_forest(std::uint64_t seed);

/// The robot as a URDF. Devices written with parent= stand after the tree they belong to, or before it.
std::string to_urdf(const RandomForest& forest);

/// The devices in the order of their start tags in that URDF.
std::vector<std::size_t> tag_order(const RandomForest& forest);

}  // namespace finemote::test
