// Two tasks, each on a process stack of its own: SVC starts the first, the tick asks for the other, PendSV switches,
// and what they share is changed with BASEPRI raised. The manner of FreeRTOS's port for this core: ARMv7-M B1.5,
// PM0214 2.3.
#include <cstdint>

#include "clocks.hpp"
#include "registers.hpp"

namespace {

constexpr unsigned kWords = 256;
constexpr std::uint32_t kKernelPriority = 0x50;  // BASEPRI while the kernel works

struct Task {
  std::uint32_t* top;  ///< of its stack while it does not run; the first member, for the assembly
  std::uint32_t stack[kWords];
};

}  // namespace

extern "C" {
Task tasks[2];
Task* current = &tasks[0];
volatile std::uint32_t rounds[2], shared_rounds, wrong_stack, wrong_sum, naps;
volatile std::uint32_t switches;
volatile bool are_running;

void choose_task() {
  switches = switches + 1;
  current = current == &tasks[0] ? &tasks[1] : &tasks[0];
}

[[gnu::naked]] void SVC_Handler() {
  asm volatile(
      "ldr r3, =current\n ldr r1, [r3]\n ldr r0, [r1]\n"
      "ldmia r0!, {r4-r11, r14}\n"
      "msr psp, r0\n isb\n"
      "mov r0, #0\n msr basepri, r0\n"
      "bx r14\n");
}

[[gnu::naked]] void PendSV_Handler() {
  asm volatile(
      "mrs r0, psp\n isb\n"
      "ldr r3, =current\n ldr r2, [r3]\n"
      "tst r14, #0x10\n it eq\n vstmdbeq r0!, {s16-s31}\n"
      "stmdb r0!, {r4-r11, r14}\n str r0, [r2]\n"
      "stmdb sp!, {r0, r3}\n mov r0, #0x50\n msr basepri, r0\n dsb\n isb\n"
      "bl choose_task\n"
      "mov r0, #0\n msr basepri, r0\n ldmia sp!, {r0, r3}\n"
      "ldr r1, [r3]\n ldr r0, [r1]\n"
      "ldmia r0!, {r4-r11, r14}\n"
      "tst r14, #0x10\n it eq\n vldmiaeq r0!, {s16-s31}\n"
      "msr psp, r0\n isb\n bx r14\n");
}
}

void on_tick() {
  if (are_running) word_at(0xE000ED04) = 1U << 28;  // PENDSVSET
}

namespace {

std::uint32_t raise_basepri() {
  std::uint32_t before;
  asm volatile("mrs %0, basepri\n msr basepri, %1\n isb\n dsb" : "=&r"(before) : "r"(kKernelPriority) : "memory");
  return before;
}

void restore_basepri(std::uint32_t before) { asm volatile("msr basepri, %0" ::"r"(before) : "memory"); }

/// Gives the rest of its time away.
void yield() {
  word_at(0xE000ED04) = 1U << 28;
  asm volatile("dsb\n isb" ::: "memory");
}

/// Sums in floating point, in registers that only a switch of all of them keeps.
float sum_up(float step) {
  float sum = 0, other = 1;
  for (int i = 0; i < 1000; ++i) {
    sum += step;
    other = other * 0.5F + sum;
  }
  return other > 0 ? sum : 0;
}

[[noreturn]] void work(unsigned number) {
  for (;;) {
    std::uint32_t control, stack;
    asm volatile("mrs %0, control\n mov %1, sp" : "=r"(control), "=r"(stack));
    const auto begin = reinterpret_cast<std::uint32_t>(tasks[number].stack);
    if ((control & 2) == 0 || stack < begin || stack > begin + sizeof tasks[number].stack)
      wrong_stack = wrong_stack + 1;
    const float step = number == 0 ? 1 : 2;
    if (sum_up(step) != 1000 * step) wrong_sum = wrong_sum + 1;
    rounds[number] = rounds[number] + 1;
    const std::uint32_t before = raise_basepri();
    shared_rounds = shared_rounds + 1;
    restore_basepri(before);
    if (number == 1 && rounds[1] % 16 == 0) {
      naps = naps + 1;
      yield();
    }
  }
}

/// The frame that an exception return takes, below it what PendSV restores: ARMv7-M B1.5.6.
void prepare(Task& task, void (*entry)()) {
  std::uint32_t* top = task.stack + kWords;
  *--top = 1U << 24;  // xPSR: Thumb
  *--top = reinterpret_cast<std::uint32_t>(entry) & ~1U;
  for (int i = 0; i < 6; ++i) *--top = 0;
  *--top = 0xFFFFFFFD;  // thread mode, process stack, no floating point
  for (int i = 0; i < 8; ++i) *--top = 0;
  task.top = top;
}

}  // namespace

int main() {
  prepare(tasks[0], [] { work(0); });
  prepare(tasks[1], [] { work(1); });
  byte_at(0xE000ED22) = 0xF0;  // PendSV: the lowest
  start_clocks();
  raise_basepri();
  are_running = true;
  asm volatile("cpsie i\n cpsie f\n dsb\n isb\n svc 0");
  return 0;
}
