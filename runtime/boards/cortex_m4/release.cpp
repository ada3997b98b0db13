// The release interrupt: pends every due bucket at once, and programs the timer for the interval after the next.
//
// SysTick's reload value takes effect when the count wraps, so the interval that begins with a release was written one
// release earlier: there is no drift, and the interrupt's own latency does not matter.
#include "release.hpp"

#include "finemote/board.hpp"
#include "finemote/schedule.hpp"
#include "runtime/boards/cortex_m4/core.hpp"
#include "runtime/boards/cortex_m4/registers.hpp"
#include "runtime/src/release.hpp"
#include "runtime/src/start.hpp"

#ifndef FINEMOTE_RUN_DURATION_NS
#define FINEMOTE_RUN_DURATION_NS 0
#endif

namespace finemote {
namespace cortex_m4 {
namespace {

constexpr std::uint32_t kCyclesPerUnit = 21;  // 168 MHz: 21 cycles are 125 ns
constexpr std::uint32_t kNsPerUnit = 125;
static_assert(kCoreHz == 168'000'000);

/// A point in time and the cycle count at it.
struct Base {
  Time at = 0;
  std::uint32_t stamp = 0;
};

/// Between two release interrupts: what the next of them, at the coming instant, works with.
struct Releases {
  std::uint32_t due = 0;        ///< due at the coming instant, as bits of the lines' controller word
  std::uint32_t leading = 0;    ///< ticks of the interval that ends there
  std::uint32_t following = 0;  ///< ticks of the interval that begins there; already in the reload register
  detail::Release next;         ///< the instant after the coming one
  std::uint32_t cycles_per_tick = 0;
  std::uint32_t tick_ns = 0;
  volatile std::uint32_t* pending = nullptr;  ///< the word in the set-pending registers
  volatile std::uint32_t* active = nullptr;
  // The release writes the base nobody reads; `count` of releases tells which is which.
  volatile std::uint32_t count = 0;
  Base bases[2];
  detail::ReleasePlan plan;
  std::uint32_t bits[kMaxBuckets]{};
};

Releases releases;

// Time reaches the instant. An interrupt that reads the time meanwhile still finds the base before, which is as true.
inline void advance_time(Releases& r) {
  const std::uint32_t count = r.count;
  const Base& before = r.bases[count & 1U];
  Base& after = r.bases[~count & 1U];
  after.at = before.at + static_cast<Time>(std::uint64_t{r.leading} * r.tick_ns);
  after.stamp = before.stamp + r.leading * r.cycles_per_tick;
  r.count = count + 1;
}

// The timer gets the interval after the one it has begun to count, and everything moves on by one instant.
inline void plan_ahead(Releases& r) {
  systick::Reload::write(r.next.ticks * r.cycles_per_tick - 1);
  r.leading = r.following;
  r.following = r.next.ticks;
  r.due = r.next.due;
  r.next = r.plan.next();
}

void end_run_in_time(const Releases& r) {
  if constexpr (FINEMOTE_RUN_DURATION_NS > 0) {
    if (r.bases[r.count & 1U].at >= FINEMOTE_RUN_DURATION_NS) run_ended();
  }
}

Duration longest_gap(const Schedule& schedule, std::uint32_t longest_step) {
  const Duration step = longest_step * schedule.tick;
  return schedule.buckets[0].period < step ? schedule.buckets[0].period : step;
}

void start_lines(const Schedule& schedule) {
  for (const Bucket& bucket : schedule.buckets) enable_line(bucket.line, bucket.priority);
}

void prepare(const Schedule& schedule) {
  Releases& r = releases;
  const unsigned word = schedule.buckets[0].line / 32U;
  r.pending = &nvic::set_pending(word);
  r.active = &nvic::active(word);
  for (unsigned i = 0; i < schedule.buckets.size(); ++i) r.bits[i] = bit(schedule.buckets[i].line % 32U);
  r.tick_ns = static_cast<std::uint32_t>(schedule.tick);
  r.cycles_per_tick = r.tick_ns / kNsPerUnit * kCyclesPerUnit;
  r.plan.start(schedule, r.bits, systick::kMaxInterval / r.cycles_per_tick);
}

}  // namespace

void start_releases(const Schedule& schedule) {
  Releases& r = releases;
  prepare(schedule);
  scb::set_priority(15, kReleasePriority);
  board::start_watchdog(longest_gap(schedule, systick::kMaxInterval / r.cycles_per_tick));
  // One tick from here to instant 0, which is time 0 and cycle count 0.
  r.leading = 1;
  r.bases[0] = {-schedule.tick, 0U - r.cycles_per_tick};
  start_cycles(r.bases[0].stamp);
  systick::Reload::write(r.cycles_per_tick - 1);
  systick::Value::write(0);
  systick::Control::write(systick::kEnable | systick::kInterrupt | systick::kCoreClock);
  while (systick::Value::read() == 0) {  // a few cycles: the count takes its first reload value
  }
  const detail::Release first = r.plan.next();
  systick::Reload::write(first.ticks * r.cycles_per_tick - 1);
  r.due = first.due;
  r.following = first.ticks;
  r.next = r.plan.next();
  start_lines(schedule);
}

bool pass_instant() {
  if ((scb::InterruptControl::read() & scb::kSysTickPending) == 0) return false;
  scb::InterruptControl::write(scb::kClearSysTick);
  advance_time(releases);
  end_run_in_time(releases);
  plan_ahead(releases);
  board::feed_watchdog();
  return true;
}

bool releases_started() { return releases.leading != 0; }

Interval release_interval() {
  const Releases& r = releases;
  for (;;) {  // ends: one more turn at most per release, and releases are at least a tick apart
    const std::uint32_t count = r.count;
    const Interval interval{r.bases[count & 1U].stamp, r.leading * r.cycles_per_tick};
    if (r.count == count) return interval;
  }
}

void enable_line(unsigned line, std::uint8_t level) {
  nvic::set_priority(line, level);
  nvic::enable(line);
}

__attribute__((weak)) void run_ended() {}

}  // namespace cortex_m4

Time now() {
  const cortex_m4::Releases& r = cortex_m4::releases;
  for (;;) {  // ends: as in release_interval()
    const std::uint32_t count = r.count;
    if (count == 0) return 0;
    const cortex_m4::Base base = r.bases[count & 1U];
    // Instants are less than 100 ms apart: the product fits 32 bits up to 204 ms.
    const std::uint32_t since = (cortex_m4::cycles() - base.stamp) * cortex_m4::kNsPerUnit / cortex_m4::kCyclesPerUnit;
    if (r.count == count) return base.at + since;
  }
}

}  // namespace finemote

/// SysTick. More urgent than every bucket, so that all due buckets are pended before any of them runs.
extern "C" void finemote_release() {
  using namespace finemote;
  cortex_m4::Releases& r = cortex_m4::releases;
  const std::uint32_t late = r.due & (*r.pending | *r.active);
  cortex_m4::advance_time(r);
  cortex_m4::end_run_in_time(r);
  *r.pending = r.due & ~late;
  cortex_m4::plan_ahead(r);
  if (!r.plan.starving()) board::feed_watchdog();
  if (late != 0) detail::report_overruns(late, r.bits);
}
