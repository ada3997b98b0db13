#include "kernel.hpp"

#include "marks.hpp"
#include "runtime/chips/cortex_m4/core.hpp"
#include "runtime/chips/cortex_m4/registers.hpp"
#include "runtime/chips/stm32f4/interrupt.hpp"

namespace baseline {

namespace {

using namespace finemote;

/// The context switch runs in a spare line of the lowest priority, as PendSV would: that of SDIO, which is not used.
constexpr unsigned kSwitchLine = 49;
constexpr std::uint8_t kSwitchPriority = 15;
/// Interrupts that call the kernel have this level or a less urgent one; serial lines are above it.
constexpr std::uint8_t kKernelLevel = cortex_m4::kSlowBusPriority;

constexpr std::uint32_t kThumb = 1U << 24;            // of xPSR
constexpr std::uint32_t kToThreadOnPsp = 0xFFFFFFFD;  // without a floating-point frame: PM0214 2.3.7
constexpr std::size_t kFrameWords = 8, kSavedWords = 9;

struct {
  Task* tasks[kMostTasks + 1] = {};
  std::size_t count = 0;
  Task* running = nullptr;
  Task idle;
  volatile Tick now = 0;
} kernel;

Stack<64> idle_stack;

Task& most_urgent() {
  Task* best = kernel.tasks[0];
  for (std::size_t i = 1; i < kernel.count; ++i) {
    Task* const task = kernel.tasks[i];
    if (task->ready && task->priority > best->priority) best = task;
  }
  return *best;
}

void switch_if_needed() {
  if (kernel.running != nullptr && &most_urgent() != kernel.running) stm32f4::pend_line(kSwitchLine);
}

void wake(Task& task, bool timed_out) {
  task.waits_for = nullptr;
  task.has_deadline = false;
  task.timed_out = timed_out;
  task.ready = true;
}

/// In a Critical. It waits once the Critical ends.
void wait_for(const void* what, bool has_deadline, Tick deadline) {
  Task& task = *kernel.running;
  task.waits_for = what;
  task.has_deadline = has_deadline;
  task.deadline = deadline;
  task.timed_out = false;
  task.ready = false;
  stm32f4::pend_line(kSwitchLine);
}

/// The most urgent task that waits for it; null: none.
Task* first_waiting_for(const void* what) {
  Task* best = nullptr;
  for (std::size_t i = 1; i < kernel.count; ++i) {
    Task* const task = kernel.tasks[i];
    if (task->waits_for == what && (best == nullptr || task->priority > best->priority)) best = task;
  }
  return best;
}

}  // namespace

extern "C" {

/// Saves where the running task stands, and says where the next one does.
[[gnu::used]] std::uint32_t* baseline_switch(std::uint32_t* stack_pointer) {
  const Critical critical;
  kernel.running->stack_pointer = stack_pointer;
  kernel.running = &most_urgent();
  mark<kIdleMark + 1>();
  if (kernel.running == &kernel.idle) {
    mark<kIdleMark>();
    asm volatile("nop");  // an instruction that is passed in this case alone
  }
  return kernel.running->stack_pointer;
}

[[gnu::naked]] void finemote_line_49() {
  asm volatile(
      "mrs r0, psp\n\t"
      "tst lr, #0x10\n\t"
      "it eq\n\t"
      "vstmdbeq r0!, {s16-s31}\n\t"
      "stmdb r0!, {r4-r11, lr}\n\t"
      "bl baseline_switch\n\t"
      "ldmia r0!, {r4-r11, lr}\n\t"
      "tst lr, #0x10\n\t"
      "it eq\n\t"
      "vldmiaeq r0!, {s16-s31}\n\t"
      "msr psp, r0\n\t"
      "bx lr");
}

[[gnu::used, noreturn]] void baseline_idle() {
  cortex_m4::enable_line(kSwitchLine, kSwitchPriority);
  stm32f4::pend_line(kSwitchLine);
  for (;;) asm volatile("");
}

/// On the idle task's stack from here on.
[[gnu::naked, noreturn]] static void become_idle(std::uint32_t*) {
  asm volatile(
      "msr psp, r0\n\t"
      "movs r0, #2\n\t"
      "msr control, r0\n\t"
      "isb\n\t"
      "b baseline_idle");
}
}

Critical::Critical() {
  asm volatile("mrs %0, basepri" : "=r"(before_));
  cortex_m4::mask_from(kKernelLevel);
}

Critical::~Critical() { asm volatile("msr basepri, %0" : : "r"(before_) : "memory"); }

void add_task(Task& task, void (*entry)(), std::uint8_t priority, std::uint32_t* stack, std::size_t words) {
  if (kernel.count == 0) kernel.tasks[kernel.count++] = &kernel.idle;
  kernel.tasks[kernel.count++] = &task;
  std::uint32_t* const frame = stack + words - kFrameWords;
  for (std::size_t i = 0; i < kFrameWords; ++i) frame[i] = 0;
  frame[6] = reinterpret_cast<std::uint32_t>(entry) & ~1U;
  frame[7] = kThumb;
  task.stack_pointer = frame - kSavedWords;
  for (std::size_t i = 0; i < kSavedWords; ++i) task.stack_pointer[i] = 0;
  task.stack_pointer[kSavedWords - 1] = kToThreadOnPsp;
  task.own_priority = task.priority = priority;
  task.ready = true;
}

void start_kernel() {
  kernel.idle.ready = true;
  kernel.running = &kernel.idle;
  become_idle(idle_stack.word + 64);
}

bool kernel_runs() { return kernel.running != nullptr; }

Tick tick_now() { return kernel.now; }

void kernel_tick() {
  const Critical critical;
  const Tick now = kernel.now + 1;
  kernel.now = now;
  for (std::size_t i = 1; i < kernel.count; ++i) {
    Task& task = *kernel.tasks[i];
    if (!task.ready && task.has_deadline && static_cast<std::int32_t>(now - task.deadline) >= 0) wake(task, true);
  }
  switch_if_needed();
}

void sleep_until(Tick tick) {
  const Critical critical;
  if (static_cast<std::int32_t>(tick - kernel.now) > 0) wait_for(nullptr, true, tick);
}

bool Semaphore::take(Tick ticks) {
  {
    const Critical critical;
    if (given_) {
      given_ = false;
      return true;
    }
    wait_for(this, true, kernel.now + ticks);
  }
  const Critical critical;  // it was away, and is back
  return !kernel.running->timed_out;
}

void Semaphore::give() {
  const Critical critical;
  if (Task* const task = first_waiting_for(this)) {
    wake(*task, false);
    switch_if_needed();
  } else {
    given_ = true;
  }
}

void Mutex::lock() {
  const Critical critical;
  if (holder_ == nullptr) {
    holder_ = kernel.running;
    return;
  }
  if (holder_->priority < kernel.running->priority) holder_->priority = kernel.running->priority;
  wait_for(this, false, 0);  // who unlocks it hands it over
}

void Mutex::unlock() {
  const Critical critical;
  kernel.running->priority = kernel.running->own_priority;
  holder_ = first_waiting_for(this);
  if (holder_ != nullptr) wake(*holder_, false);
  switch_if_needed();
}

}  // namespace baseline
