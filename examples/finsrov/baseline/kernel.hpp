// A preemptive kernel as small as what robots' firmware uses of one: tasks with fixed priorities, time slots of a
// millisecond, semaphores, and mutexes whose holder inherits the priority of who waits.
//
// Made for a comparison, in the manner of the kernels that teams use, and with less work than those do: no lists of
// tasks, no statistics, no hooks, no checks of stacks.
#pragma once

#include <cstddef>
#include <cstdint>

namespace baseline {

/// A count of the kernel's millisecond ticks; wraps.
using Tick = std::uint32_t;

struct Task {
  std::uint32_t* stack_pointer = nullptr;
  std::uint8_t own_priority = 0, priority = 0;  ///< larger is more urgent; 0 is the idle task's
  bool ready = false;
  bool has_deadline = false, timed_out = false;
  Tick deadline = 0;
  const void* waits_for = nullptr;
};

/// Keeps everything out that calls the kernel; may be nested.
class Critical {
 public:
  Critical();
  ~Critical();
  Critical(const Critical&) = delete;
  Critical& operator=(const Critical&) = delete;

 private:
  std::uint32_t before_;
};

/// Room for a task's stack and what the kernel saves there.
template <std::size_t words>
struct Stack {
  alignas(8) std::uint32_t word[words];
};

/// Most tasks beside the idle one.
constexpr std::size_t kMostTasks = 16;

/// Makes a task ready that begins with `entry`, which does not return. Context: before start_kernel().
void add_task(Task& task, void (*entry)(), std::uint8_t priority, std::uint32_t* stack, std::size_t words);
template <std::size_t words>
void add_task(Task& task, void (*entry)(), std::uint8_t priority, Stack<words>& stack) {
  add_task(task, entry, priority, stack.word, words);
}

/// Turns the caller into the idle task.
[[noreturn]] void start_kernel();
bool kernel_runs();

/// A millisecond has passed. Context: interrupt.
void kernel_tick();
Tick tick_now();

/// The calling task goes on when the count of ticks is `tick`; at once where it was.
void sleep_until(Tick tick);

/// Counts to one.
class Semaphore {
 public:
  /// @return  false: nobody gave it within `ticks`
  bool take(Tick ticks);
  /// Context: any that a Critical keeps out.
  void give();
  void clear() { given_ = false; }

 private:
  volatile bool given_ = false;
};

class Mutex {
 public:
  void lock();
  void unlock();

 private:
  Task* holder_ = nullptr;
};

class Locked {
 public:
  explicit Locked(Mutex& mutex) : mutex_(mutex) { mutex_.lock(); }
  ~Locked() { mutex_.unlock(); }
  Locked(const Locked&) = delete;
  Locked& operator=(const Locked&) = delete;

 private:
  Mutex& mutex_;
};

}  // namespace baseline
