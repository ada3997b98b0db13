// The release interrupt: pends every due bucket at once, and programs the timer for the interval after the next.
//
// SysTick's reload value takes effect when the count wraps, so the interval that begins with a release was written one
// release earlier: there is no drift, and the interrupt's own latency does not matter. It has to end before the next
// release, which the analysis holds it to (generator/timing/release_interrupt.hpp).
#include "release.hpp"

#include <atomic>
#include <cstddef>

#include "finemote/board.hpp"
#include "finemote/fault.hpp"
#include "finemote/loop_bound.hpp"
#include "finemote/only_after_fault.hpp"
#include "finemote/schedule.hpp"
#include "finemote/single_core.hpp"
#include "runtime/chips/cortex_m4/core.hpp"
#include "runtime/chips/cortex_m4/registers.hpp"
#include "runtime/src/release.hpp"
#include "runtime/src/start.hpp"

#ifndef FINEMOTE_RUN_DURATION_NS
#define FINEMOTE_RUN_DURATION_NS 0
#endif

namespace finemote {
namespace cortex_m4 {
namespace {

// The image check (generator/image/stack.cpp) reads the schedule out of the linked image.
static_assert(offsetof(Schedule, buckets) == 16 && offsetof(Schedule, start_buses) == 32 &&
              offsetof(Schedule, safe_outputs) == 36 && offsetof(Schedule, buses_quiet) == 48 && sizeof(Bucket) == 24 &&
              offsetof(Bucket, period) == 8 && offsetof(Bucket, line) == 16);

// The emulator reads overruns from memory (emulator/program/firmware.cpp).
static_assert(offsetof(BucketState, overruns) == 12 && sizeof(BucketState) == 20);

static_assert(2 * systick::kMaxInterval <= 0xFFFFFFFFU / kNsPerUnit, "now() counts in 32 bits");

constexpr unsigned kSlots = 7;

/// One release instant, in a ring of those to come.
struct Instant {
  std::uint32_t due;     ///< lines due, as bits of their controller word
  std::uint32_t reload;  ///< what the reload register gets here: the interval after the one that begins here
  std::uint32_t stamp;   ///< cycle count
  Instant* next;
  Time at;
};

/// The ring turns for ever when the instants of a hyperperiod fit into it: each slot then only moves on by a turn.
/// Otherwise every slot is planned anew once it has been left.
struct Releases {
  Instant* volatile present = nullptr;        ///< the last instant that has passed; changed by one store
  volatile std::uint32_t* pending = nullptr;  ///< the word in the set-pending registers
  std::uint32_t turn_ns = 0;                  ///< 0: slots are planned anew
  std::uint32_t turn_cycles = 0;
  detail::StarvationWatch watch;
  Instant ring[kSlots]{};
  // What planning needs.
  detail::ReleasePlan plan;
  detail::Release ahead;  ///< the instant to be planned next
  Time ahead_at = 0;
  std::uint32_t ahead_stamp = 0;
  std::uint32_t cycles_per_tick = 0;
  std::uint32_t tick_ns = 0;
};

Releases releases;

constexpr unsigned kActiveFromPending = (0xE000E300 - 0xE000E200) / 4;  // active bits, PM0214 4.3

__attribute__((noinline)) void plan(Releases& r, Instant& slot) {
  slot.due = r.ahead.due;
  slot.at = r.ahead_at;
  slot.stamp = r.ahead_stamp;
  const std::uint32_t ticks = r.ahead.ticks;
  r.ahead_at += static_cast<Time>(std::uint64_t{ticks} * r.tick_ns);
  r.ahead_stamp += ticks * r.cycles_per_tick;
  r.ahead = r.plan.next(finemote_schedule);
  slot.reload = r.ahead.ticks * r.cycles_per_tick - 1;
}

// Time reaches `coming`. An interrupt that reads the time meanwhile finds the instant before, which is as true.
inline void move_to(Releases& r, Instant& left, Instant& coming) {
  systick::Reload::write(coming.reload);
  r.present = &coming;
  std::atomic_signal_fence(std::memory_order_seq_cst);
  if (r.turn_ns != 0) {
    left.at += r.turn_ns;
    left.stamp += r.turn_cycles;
  } else {
    plan(r, left);
  }
}

void end_run_in_time(const Instant& instant) {
  if constexpr (FINEMOTE_RUN_DURATION_NS > 0) {
    if (instant.at >= FINEMOTE_RUN_DURATION_NS) run_ended();
  }
}

Duration longest_gap(const Schedule& schedule, std::uint32_t longest_step) {
  const Duration step = longest_step * schedule.tick;
  return schedule.buckets[0].period < step ? schedule.buckets[0].period : step;
}

// Plans the slots from instant 0 on and makes a ring of them; the present is then the slot before instant 0. A ring of
// whole hyperperiods ends in the slot that will stand for its last instant, one turn early. Returns the present to
// come.
Instant& fill(Releases& r, std::uint32_t all) {
  unsigned whole = 0;  // slots that whole hyperperiods take
  r.ahead = r.plan.next(finemote_schedule);
  for (unsigned i = 0; i < kSlots - 1; ++i) {
    plan(r, r.ring[i]);
    r.ring[i].next = &r.ring[i + 1];
    if (r.ahead.due != all) continue;
    whole = i + 1;
    r.turn_ns = static_cast<std::uint32_t>(r.ahead_at);
    r.turn_cycles = r.ahead_stamp;
  }
  Instant& last = r.ring[whole != 0 ? whole - 1 : kSlots - 1];
  last.next = &r.ring[0];
  if (whole != 0) {
    last.at -= r.turn_ns;
    last.stamp -= r.turn_cycles;
  } else {
    last.at = -static_cast<Time>(r.tick_ns);
    last.stamp = 0U - r.cycles_per_tick;
  }
  return last;
}

std::uint32_t prepare(Releases& r, const Schedule& schedule) {
  r.pending = &nvic::set_pending(schedule.buckets[0].line / 32U);
  std::uint32_t all = 0;
  for (unsigned i = 0; i < schedule.buckets.size(); ++i) {
    all |= schedule.buckets.state(i).bit = bit(schedule.buckets[i].line % 32U);
  }
  r.tick_ns = static_cast<std::uint32_t>(schedule.tick);
  r.cycles_per_tick = r.tick_ns / kNsPerUnit * kCyclesPerUnit;
  r.plan.start(schedule, systick::kMaxInterval / r.cycles_per_tick);
  return all;
}

// Some bucket is late, or was, which was counted: counts, and lets the watchdog starve when it has to. Out of the
// interrupt's short way.
__attribute__((noinline)) void take_late(Releases& r, std::uint32_t due, std::uint32_t late) {
  only_after_fault();
  r.watch.note(finemote_schedule, due, late);
  if (!r.watch.starving()) board::feed_watchdog();
  if (late != 0) detail::report_overruns(late);
}

// The count takes its first reload value at the next clock (PM0214 4.5); until then the next one must not be written.
void wait_for_count() {
  constexpr std::uint32_t kPolls = 1'000;
  for (std::uint32_t polls = kPolls; systick::Value::read() == 0; --polls) {
    if (polls != 0) continue;
    stop_safely(Module::schedule, static_cast<std::uint8_t>(ScheduleFault::no_timer),
                FINEMOTE_TEXT("schedule: the release timer does not count"));
  }
}

}  // namespace

void start_releases(const Schedule& schedule) {
  Releases& r = releases;
  Instant& before = fill(r, prepare(r, schedule));
  scb::set_priority(15, kReleasePriority);
  board::start_watchdog(longest_gap(schedule, systick::kMaxInterval / r.cycles_per_tick));
  start_cycles(before.stamp);
  r.present = &before;  // now() counts from here on: before, the cycles are those since power-on
  systick::Reload::write(0U - before.stamp - 1);
  systick::Value::write(0);
  systick::Control::write(systick::kEnable | systick::kInterrupt | systick::kCoreClock);
  wait_for_count();
  systick::Reload::write(r.ring[1].stamp - r.ring[0].stamp - 1);
  for (const Bucket& bucket : schedule.buckets) enable_line(bucket.line, bucket.priority);
}

bool pass_instant() {
  if ((scb::InterruptControl::read() & scb::kSysTickPending) == 0) return false;
  scb::InterruptControl::write(scb::kClearSysTick);
  Releases& r = releases;
  Instant& left = *r.present;
  move_to(r, left, *left.next);
  end_run_in_time(*r.present);
  board::feed_watchdog();
  return true;
}

Interval release_interval() {
  const Releases& r = releases;
  for (;;) {  // ends: one more turn at most per release, and releases are at least a tick apart
    retried_if_interrupted<RetriedBy::release>();
    const Instant* const present = r.present;
    if (present == nullptr) return {0, 1};
    const std::uint32_t stamp = present->stamp;  // first and last: when the ring has turned in between, it is another
    std::atomic_signal_fence(std::memory_order_seq_cst);
    const std::uint32_t length = present->next->stamp - stamp;
    std::atomic_signal_fence(std::memory_order_seq_cst);
    if (r.present == present && present->stamp == stamp) return {stamp, length};
  }
}

bool has_begun() { return releases.present != nullptr; }

void enable_line(unsigned line, std::uint8_t level) {
  nvic::set_priority(line, level);
  nvic::enable(line);
}

__attribute__((weak)) void run_ended() {}

}  // namespace cortex_m4

Time now() {
  const cortex_m4::Releases& r = cortex_m4::releases;
  for (;;) {  // ends: as in release_interval()
    retried_if_interrupted<RetriedBy::release>();
    const cortex_m4::Instant* const present = r.present;
    if (present == nullptr) return 0;
    const std::uint32_t stamp = present->stamp;  // as there
    std::atomic_signal_fence(std::memory_order_seq_cst);
    const Time at = present->at;
    // Instants are less than 2^24 cycles apart, and the product fits 32 bits up to twice that.
    const std::uint32_t since = (cortex_m4::cycles() - stamp) * cortex_m4::kNsPerUnit / cortex_m4::kCyclesPerUnit;
    std::atomic_signal_fence(std::memory_order_seq_cst);
    if (r.present != present || present->stamp != stamp) continue;  // interrupted by a release
    const Time time = at + since;
    return time < 0 ? 0 : time;
  }
}

}  // namespace finemote

/// SysTick. More urgent than every bucket, so that all due buckets are pended before any of them runs.
extern "C" void finemote_release() {
  using namespace finemote::cortex_m4;
  Releases& r = releases;
  Instant& left = *r.present;
  Instant& coming = *left.next;
  const std::uint32_t due = coming.due;
  const std::uint32_t late = due & (r.pending[0] | r.pending[kActiveFromPending]);
  end_run_in_time(coming);
  r.pending[0] = due & ~late;
  move_to(r, left, coming);
  if (late == 0 && r.watch.quiet())
    finemote::board::feed_watchdog();
  else
    take_late(r, due, late);
  finemote::drain_stores();
}
