// Turns the level of a pin into a button that has been pressed or not.
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"
#include "finemote/gpio.hpp"
#include "finemote/interfaces/button.hpp"

namespace finemote {

/// A key on a pin. A new level counts when every update() has seen it for `debounce`; until then the state is the old
/// one. The first level counts at the end of the first `debounce`, when the state becomes valid; a key held down at
/// start is pressed and counted.
class Key {
 public:
  struct Config {
    Duration debounce = 20 * kMillisecond;
  };

  constexpr Key(const Config& config, GpioPin pin) : config_(config), pin_(pin) {}

  void update();
  void handle() {}

  ButtonState state;

 private:
  Config config_;
  GpioPin pin_;
  bool level_ = false;  ///< as last seen
  bool seen_ = false;
  Time level_since_ = 0, state_since_ = 0;
};

}  // namespace finemote
