// Turns "call this at that time" into calls in time order; at equal times, in the order they were asked for.
#pragma once

#include <cstdint>
#include <functional>
#include <queue>
#include <vector>

#include "emulator/time.hpp"

namespace finemote::emulator {

/// Future work of peripherals and parts. Cancelling is done by owners: they keep a `Token` and drop the stale ones.
class EventQueue {
 public:
  using Action = std::function<void()>;

  void at(Time time, Action action) { events_.push(Event{time, sequence_++, std::move(action)}); }

  [[nodiscard]] Time next() const { return events_.empty() ? kNever : events_.top().time; }

  /// When the event that runs now was due; kNever while none does.
  [[nodiscard]] Time running() const { return running_; }

  /// Runs everything due at `now` or before, including what is added for then while running.
  void run(Time now) {
    while (!events_.empty() && events_.top().time <= now) {
      Action action = std::move(const_cast<Event&>(events_.top()).action);  // popped on the next line
      running_ = events_.top().time;
      events_.pop();
      action();
    }
    running_ = kNever;
  }

 private:
  struct Event {
    Time time;
    std::uint64_t sequence;
    Action action;
  };
  struct Later {
    bool operator()(const Event& a, const Event& b) const {
      return a.time != b.time ? a.time > b.time : a.sequence > b.sequence;
    }
  };

  std::priority_queue<Event, std::vector<Event>, Later> events_;
  std::uint64_t sequence_ = 0;
  Time running_ = kNever;
};

}  // namespace finemote::emulator
