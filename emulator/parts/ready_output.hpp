// An interrupt output of a part: from its sampling instants and its settings to the level on a wire.
#pragma once

#include <cstdint>
#include <functional>

#include "emulator/event_queue.hpp"

namespace finemote::emulator {

/// The board's time, for parts that act by themselves.
struct PartClock {
  std::function<Time()> now;
  std::function<void(Time, EventQueue::Action)> at;  ///< does something at a time
};

/// Becomes active with every sample, and inactive by itself or when it is told that the sample was noticed.
class ReadyOutput {
 public:
  struct Settings {
    bool driven = false;       ///< else the wire is left alone
    Time period = 0;           ///< of the samples, at its multiples; 0: there are none
    bool active_high = false;  ///< the level of the active output
    bool open_drain = false;   ///< pulls low only
    bool operator==(const Settings&) const = default;
  };

  /// @param hold   after which the output is inactive again, shorter than every period
  /// @param alive  asked at every sample: whether there is one
  ReadyOutput(const PartClock& clock, Time hold, std::function<bool()> alive)
      : clock_(clock), hold_(hold), alive_(std::move(alive)) {}

  void set(const Settings& settings) {
    if (settings == settings_) return;
    settings_ = settings;
    active_ = false;
    ++token_;
    show();
    if (settings_.driven && settings_.period != 0) wait((clock_.now() / settings_.period + 1) * settings_.period);
  }
  void notice() {
    active_ = false;
    show();
  }

  /// Told the level when it changes: 1, 0, or -1: the wire is left alone.
  std::function<void(int level)> on_level;

 private:
  void wait(Time sample) {
    clock_.at(sample, [this, sample, token = token_] {
      if (token != token_) return;
      wait(sample + settings_.period);
      if (!alive_()) return;
      active_ = true;
      show();
      clock_.at(sample + hold_, [this, token] {
        if (token == token_) notice();
      });
    });
  }
  void show() {
    const bool high = active_ == settings_.active_high;
    const int level = !settings_.driven || (settings_.open_drain && high) ? -1 : high ? 1 : 0;
    if (level != level_ && on_level) on_level(level);
    level_ = level;
  }

  PartClock clock_;
  Time hold_;
  std::function<bool()> alive_;
  Settings settings_;
  bool active_ = false;
  int level_ = -1;
  std::uint64_t token_ = 0;
};

}  // namespace finemote::emulator
