// A lamp that is bright while a button is pressed: a device type of this project, to be replaced by yours.
#pragma once

#include "finemote/contract.hpp"
#include "finemote/interfaces/button.hpp"
#include "finemote/interfaces/light.hpp"

namespace lantern {

class Lantern {
 public:
  struct Config {
    float idle = 0.1F;  ///< brightness while nobody presses, 0..1
  };

  constexpr Lantern(const Config& config, finemote::Port<finemote::Button> button, finemote::Port<finemote::Light> lamp)
      : config_(config), button_(button), lamp_(lamp) {}

  /// Reads. Every job of the robot runs all updates from the leaves to the root...
  void update() { brightness_ = button_.state.pressed ? 1.0F : config_.idle; }

  /// ...then all handles from the root to the leaves: decides, and says how old the data is that the decision comes
  /// from.
  void handle() {
    lamp_.command.red = lamp_.command.green = lamp_.command.blue = brightness_;
    lamp_.command.origin = button_.state.origin;
    lamp_.command.valid = button_.state.valid;
  }

 private:
  Config config_;
  finemote::Port<finemote::Button> button_;
  finemote::Port<finemote::Light> lamp_;
  float brightness_ = 0;
};

}  // namespace lantern
