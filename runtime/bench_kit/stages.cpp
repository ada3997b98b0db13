// The robot of the kit as it runs: what its release interrupt costs, and how long every stage takes by itself.
#include <cstdint>

#include "finemote/board.hpp"
#include "finemote/schedule.hpp"
#include "finemote/trace.hpp"
#include "groups.hpp"
#include "record.hpp"
#include "runtime/chips/cortex_m4/registers.hpp"
#include "runtime/chips/cortex_m4/release.hpp"
#include "runtime/chips/stm32f4/interrupt.hpp"
#include "runtime/src/start.hpp"
#include "stopwatch.hpp"

namespace finemote::bench_kit {
namespace {

namespace scb = cortex_m4::scb;
namespace systick = cortex_m4::systick;
using stm32f4::bit;
using stm32f4::Register;

/// Two for each device, update and handle, in the order the robot's trace counts them.
std::uint32_t longest[kStageCount];
/// Of a stage with nothing in it.
std::uint32_t empty_stage = 0;
std::uint32_t begin_of_stage = 0;

/// NVIC_ICER and NVIC_ICPR, PM0214 4.3.3, 4.3.5.
constexpr std::uint32_t kDisable = 0xE000E180, kUnpend = 0xE000E280;

void write_lines(std::uint32_t registers) {
  for (const Bucket& bucket : finemote_schedule.buckets)
    Register{registers + 4U * (bucket.line / 32U)}.write(bit(bucket.line % 32U));
}

void start_robot() {
  constexpr detail::ReleaseTimer kTimer{
      std::int64_t{systick::kMaxInterval} * cortex_m4::kNsPerUnit / cortex_m4::kCyclesPerUnit, cortex_m4::kNsPerUnit,
      true};
  detail::start_robot(finemote_schedule, kTimer);
  cortex_m4::start_releases(finemote_schedule);
  write_lines(kDisable);
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
    write_lines(kUnpend);
    before = watch.cycles();
  }
  if (away == 0) return miss(Test::release_cost_ns, Missing::answer);
  put(Test::release_cost_ns, ns_of(away - turn));
}

void run_stages() {
  constexpr std::uint32_t kRunUs = 1'500'000;
  trace(0);
  trace(1);
  empty_stage = longest[0];
  longest[0] = 0;
  write_lines(kUnpend);
  for (const Bucket& bucket : finemote_schedule.buckets) cortex_m4::nvic::enable(bucket.line);
  for (const Stopwatch watch; !watch.has_passed(cycles_in(kRunUs));) {}
}

/// Nothing interrupts any more.
void stop_robot() {
  asm volatile("cpsid i" ::: "memory");
  systick::Control::write(0);
  scb::InterruptControl::write(scb::kClearSysTick);
  write_lines(kDisable);
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

}  // namespace

void measure_robot() {
  start_robot();
  time_release();
  run_stages();
  stop_robot();
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
