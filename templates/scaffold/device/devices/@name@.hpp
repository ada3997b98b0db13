// What it turns into what, in one sentence.
#pragma once

#include "finemote/contract.hpp"
#include "finemote/time.hpp"

namespace @name@ {

/// What a parent sees.
struct MeasurementState : finemote::Stamp {
  float value = 0;  ///< unit
};

/// The interface, which the descriptor provides. A sensor takes no command.
struct Measurement {
  using State = MeasurementState;
  using Command = void;
};

class @class@ {
 public:
  struct Config {
    float gain = 1;
  };

  constexpr explicit @class@(const Config& config) : config_(config) {}

  MeasurementState state;

  /// Reads hardware and children, publishes `state`. Never waits.
  void update() {
    state.value = config_.gain * 1.0F;
    state.origin = finemote::now();  // when the data was taken, or earlier
    state.valid = true;
  }

  /// Decides, and commands children and hardware. Never waits.
  void handle() {}

 private:
  Config config_;
};

}  // namespace @name@
