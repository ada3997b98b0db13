// What both firmwares with tasks share: the kernel's tick, and values that tasks give each other.
#pragma once

#include "kernel.hpp"
#include "robot.hpp"
#include "start.hpp"

namespace baseline {

/// One task writes it, others read it: copied while nobody else can.
template <class T>
class Shared {
 public:
  void put(const T& value) {
    const Critical critical;
    value_ = value;
  }
  [[nodiscard]] T get() const {
    const Critical critical;
    return value_;
  }

 private:
  T value_{};
};

constexpr Tick kImuTicks = 5, kRobotTicks = 10, kPayloadTicks = kPayloadPeriod / finemote::kMillisecond;
/// Words of a task's stack.
constexpr std::size_t kStackWords = 256;

/// Calls `body` at the first tick and every `period` ticks from then on, for ever.
template <class Body>
[[noreturn]] void every(Tick period, Body body) {
  for (Tick next = 1;; next += period) {
    sleep_until(next);
    body();
  }
}

[[noreturn]] inline void payload_task() { every(kPayloadTicks, run_payload); }

/// The payload's task, where there is one: less urgent than all others.
inline void add_payload() {
  static Task task;
  static Stack<kStackWords> stack;
  if (kIsLoaded) add_task(task, payload_task, 1, stack);
}

}  // namespace baseline
