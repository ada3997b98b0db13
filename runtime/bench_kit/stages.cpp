// The robot of the kit as it runs: what its release interrupt costs, and how long the routines of its buses and every
// stage take by themselves.
#include <cstdint>

#include "can_line.hpp"
#include "finemote/board.hpp"
#include "finemote/schedule.hpp"
#include "finemote/trace.hpp"
#include "groups.hpp"
#include "record.hpp"
#include "routines.hpp"
#include "runtime/chips/cortex_m4/registers.hpp"
#include "runtime/chips/cortex_m4/release.hpp"
#include "runtime/chips/stm32f4/registers/clock.hpp"
#include "runtime/src/start.hpp"
#include "stopwatch.hpp"

namespace finemote::bench_kit {
namespace {

namespace nvic = cortex_m4::nvic;
namespace scb = cortex_m4::scb;
namespace systick = cortex_m4::systick;

/// Two for each device, update and handle, in the order the robot's trace counts them.
std::uint32_t longest[kStageCount];
/// Of a stage with nothing in it.
std::uint32_t empty_stage = 0;
std::uint32_t begin_of_stage = 0;

constexpr stm32f4::CanPeripheral kCans[] = {stm32f4::kCan1, stm32f4::kCan2};
bool is_inward[2];

void for_each_line(void (*act)(unsigned line)) {
  for (const Bucket& bucket : finemote_schedule.buckets) act(bucket.line);
}

/// A controller of the robot neither sends to a bus nor lacks an answer there.
void turn_cans_inward() {
  constexpr std::uint32_t kAsleep = 1U << 1;  // MSR, RM0090 32.9.2
  for (const stm32f4::CanPeripheral& it : kCans) {
    const bool is_used = (stm32f4::rcc::apb1enr.read() & it.clock_bits) == it.clock_bits && !it.can.msr().any(kAsleep);
    if (is_used) is_inward[&it - kCans] = turn_inward(it);
  }
}

void start_robot() {
  constexpr detail::ReleaseTimer kTimer{
      std::int64_t{systick::kMaxInterval} * cortex_m4::kNsPerUnit / cortex_m4::kCyclesPerUnit, cortex_m4::kNsPerUnit,
      true};
  detail::start_robot(finemote_schedule, kTimer);
  turn_cans_inward();  // before releases wait for it
  cortex_m4::start_releases(finemote_schedule);
  for_each_line(nvic::disable);
}

/// The longest time away from a loop that only reads the counter, while releases pend buckets that do not run.
void time_release() {
  constexpr std::uint32_t kWatchUs = 300'000, kAway = 40;  // cycles: more than a turn of the loop
  std::uint32_t away = 0, turn = ~0U;
  const Stopwatch watch;
  for (std::uint32_t before = watch.cycles(); before < cycles_in(kWatchUs);) {
    const std::uint32_t now = watch.cycles(), gap = now - before;
    before = now;
    turn = gap < turn ? gap : turn;
    if (gap < kAway) continue;
    away = gap > away ? gap : away;
    for_each_line(nvic::clear_pending);
    before = watch.cycles();
  }
  if (away == 0) return miss(Test::release_cost_ns, Missing::answer);
  put(Test::release_cost_ns, ns_of(away - turn));
}

/// What a motor of the first identifier sends, so that there is something to receive.
void send_feedback() {
  constexpr std::uint32_t kFeedback = 0x201;
  const cortex_m4::Masked masked;
  for (const stm32f4::CanPeripheral& it : kCans) {
    if (is_inward[&it - kCans]) send_frame(it, kFeedback);
  }
}

void run_stages() {
  constexpr std::uint32_t kTurnUs = 7'000, kTurns = 200;
  trace(0);
  trace(1);
  empty_stage = longest[0];
  longest[0] = 0;
  for_each_line(nvic::clear_pending);
  for_each_line(nvic::enable);
  for (std::uint32_t i = 0; i < kTurns; ++i) {
    for (const Stopwatch watch; !watch.has_passed(cycles_in(kTurnUs));) {}
    send_feedback();
  }
}

/// Nothing interrupts any more.
void stop_robot() {
  asm volatile("cpsid i" ::: "memory");
  systick::Control::write(0);
  scb::InterruptControl::write(scb::kClearSysTick);
  for_each_line(nvic::disable);
}

void record_stages() {
  for (unsigned i = 0; i < kStageCount; ++i) {
    const auto test = static_cast<Test>(static_cast<unsigned>(kFirstStage) + i);
    if (longest[i] == 0) {
      miss(test, Missing::answer);
    } else {
      put(test, ns_of(longest[i] - empty_stage));
    }
  }
}

/// A bus on which nothing happened lacks a partner, or does not work.
void record_routines() {
  for (unsigned i = 0; i < kBusCount; ++i) {
    const auto test = static_cast<Test>(static_cast<unsigned>(kFirstRoutine) + i);
    const std::uint32_t cycles = longest_routine(i);
    if (cycles != 0) {
      put(test, ns_of(cycles));
    } else {
      miss(test, kTests[static_cast<unsigned>(test)].needs[0] != '\0' ? Missing::partner : Missing::answer);
    }
  }
}

}  // namespace

void measure_robot() {
  start_robot();
  time_release();
  watch_routines();
  run_stages();
  stop_robot();
  record_routines();
  record_stages();
}

}  // namespace finemote::bench_kit

/// Stages call it where they begin and end. In between nothing interrupts, so that what is counted is the stage alone.
void finemote::trace(std::uint32_t code) {
  using namespace finemote::bench_kit;
  if (code % 2 == 0) {
    asm volatile("cpsid i" ::: "memory");
    begin_of_stage = cortex_m4::cycles();
    return;
  }
  const std::uint32_t took = cortex_m4::cycles() - begin_of_stage;
  std::uint32_t& most = longest[code / 2];
  most = took > most ? took : most;
  asm volatile("cpsie i" ::: "memory");
}
