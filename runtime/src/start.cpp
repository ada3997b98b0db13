#include "start.hpp"

#include "finemote/board.hpp"
#include "finemote/fault.hpp"
#include "finemote/single_core.hpp"
#include "release.hpp"

namespace finemote::detail {
namespace {

bool started = false;
Shared<bool> stopped{false};

[[noreturn]] void refuse(ScheduleFault fault, const char* text) {
  stop_safely(Module::schedule, static_cast<std::uint8_t>(fault), text);
}

void check_order(View<OrderCheck> checks) {
  const std::size_t bad = first_order_violation(checks);
  if (bad == checks.size()) return;
#ifndef FINEMOTE_SILENT
  board::say("order: '");
  board::say(checks[bad].parent_name);
  board::say("' was constructed before its child '");
  board::say(checks[bad].child_name);
  board::say("'\n");
#endif
  stop_safely(Module::order, static_cast<std::uint8_t>(bad),
              FINEMOTE_TEXT("make the child an inline variable defined before it"));
}

void check_tick(const Schedule& schedule, const ReleaseTimer& timer) {
  if (schedule.tick <= 0 || schedule.tick > timer.longest_tick ||
      static_cast<std::uint32_t>(schedule.tick) % timer.tick_unit_ns != 0) {
    refuse(ScheduleFault::bad_tick, FINEMOTE_TEXT("schedule: this board cannot count the tick"));
  }
}

void check_buckets(const Schedule& schedule, const ReleaseTimer& timer) {
  if (schedule.buckets.empty()) refuse(ScheduleFault::empty, FINEMOTE_TEXT("schedule: no buckets"));
  if (schedule.buckets.size() > kMaxBuckets)
    refuse(ScheduleFault::too_many, FINEMOTE_TEXT("schedule: too many buckets"));
  const Bucket* before = nullptr;
  for (const Bucket& bucket : schedule.buckets) {
    const Ticks ticks = ticks_in(bucket.period, static_cast<std::uint32_t>(schedule.tick));
    if (bucket.period <= 0 || !ticks.exact || ticks.count > kMaxPeriodTicks) {
      refuse(ScheduleFault::bad_period, FINEMOTE_TEXT("schedule: a period is no multiple of the tick"));
    }
    if (timer.one_word && bucket.line / 32 != schedule.buckets[0].line / 32) {
      refuse(ScheduleFault::bad_lines,
             FINEMOTE_TEXT("schedule: the lines are not all in one word of the interrupt controller"));
    }
    if (before != nullptr && (bucket.period <= before->period || bucket.priority <= before->priority)) {
      refuse(ScheduleFault::not_monotonic,
             FINEMOTE_TEXT("schedule: a shorter period must come first and be more urgent"));
    }
    before = &bucket;
  }
}

}  // namespace

void start_robot(const Schedule& schedule, const ReleaseTimer& timer) {
  check_order(schedule.order);
  check_tick(schedule, timer);
  check_buckets(schedule, timer);
  schedule.start_buses();
  started = true;
  schedule.safe_outputs();
}

bool outputs_started() { return started; }

void set_stopped(bool is_stopped) { stopped.store(is_stopped); }

bool has_stopped() { return stopped.load(); }

}  // namespace finemote::detail
