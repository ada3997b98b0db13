// A user's own device: sees whether a line is below the robot.
#pragma once

#include <finemote/contract.hpp>
#include <finemote/time.hpp>

namespace example {

struct LineState : finemote::Stamp {
  bool on_line = false;
};

/// The interface: what a parent sees. A sensor takes no command.
struct Line {
  using State = LineState;
  using Command = void;
};

class LineSensor {
 public:
  struct Config {
    float threshold;          ///< 0..1
    finemote::Duration hold;  ///< [ns]
  };

  constexpr explicit LineSensor(const Config& config) : config_(config) {}

  LineState state;

  /// Stands in for reading a photo diode: brightness goes up and down with a period of 64 calls.
  void update() {
    step_ = (step_ + 1) % 64;
    const int rising = step_ < 32 ? step_ : 63 - step_;
    const finemote::Time now = finemote::now();
    if (static_cast<float>(rising) / 31.0f < config_.threshold) seen_at_ = now;
    state.on_line = now - seen_at_ <= config_.hold;
    state.origin = now;
    state.valid = true;
  }

  void handle() {}

 private:
  Config config_;
  int step_ = 0;
  finemote::Time seen_at_ = 0;
};

}  // namespace example
