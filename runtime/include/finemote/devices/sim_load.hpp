// Turns two durations into work: a device of known execution time, for timing experiments.
#pragma once

#include "finemote/contract.hpp"
#include "finemote/interfaces/any.hpp"

namespace finemote {

/// A leaf stamps the present time; an inner one passes on the oldest of its children, and commands them with the
/// command it got itself, or, as a root, with its own state.
class SimLoad {
 public:
  struct Config {
    Duration update = 10 * kMicrosecond;  ///< how long update() works
    Duration handle = 10 * kMicrosecond;  ///< how long handle() works
  };

  constexpr SimLoad(const Config& config, Ports<Any> children = {}) : config_(config), children_(children) {}

  void update();
  void handle();

  Stamp state;
  Stamp command;

 private:
  const Config config_;
  const Ports<Any> children_;
};

}  // namespace finemote
