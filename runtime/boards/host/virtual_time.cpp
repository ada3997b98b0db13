// Virtual time: a queue of interrupts, the release timer, and buckets that preempt each other as nested calls.
#include <algorithm>
#include <cstdio>
#include <functional>
#include <queue>
#include <string>
#include <utility>
#include <vector>

#include "finemote/bus_counters.hpp"
#include "finemote/fault.hpp"
#include "finemote/host.hpp"
#include "finemote/monitor.hpp"
#include "finemote/schedule.hpp"
#include "finemote/trace.hpp"
#include "runtime/src/release.hpp"
#include "runtime/src/start.hpp"

namespace finemote {
namespace {

constexpr Time kNever = INT64_MAX;
constexpr unsigned kThread = 255;  // less urgent than every bucket
constexpr detail::ReleaseTimer kTimer{4 * kSecond, 1, false};

struct Interrupt {
  Time at;
  std::uint64_t order;
  std::function<void()> routine;
};
struct Later {
  bool operator()(const Interrupt& a, const Interrupt& b) const {
    return a.at != b.at ? a.at > b.at : a.order > b.order;
  }
};

/// Everything the virtual processor knows.
struct Machine {
  Time now = 0;
  Time end = kNever;  // nothing is released or recorded from here on
  Time next_release = kNever;
  detail::ReleasePlan plan;
  detail::StarvationWatch watch;
  detail::Release next;       // what happens at next_release
  std::uint32_t pending = 0;  // bit i: bucket i
  std::uint32_t active = 0;
  unsigned level = kThread;  // priority of the running code
  bool in_interrupt = false;
  bool fed = true;
  bool stopped = false;
  std::uint64_t orders = 0;
  std::priority_queue<Interrupt, std::vector<Interrupt>, Later> interrupts;
  std::vector<host::Event> events;
  std::string stop_text;
};

Machine& machine() {
  static Machine the_machine;
  return the_machine;
}

Time next_happening(const Machine& m) {
  return std::min(m.next_release, m.interrupts.empty() ? kNever : m.interrupts.top().at);
}

void release(Machine& m) {
  const std::uint32_t late = m.next.due & (m.pending | m.active);
  m.pending |= m.next.due & ~late;
  m.watch.note(finemote_schedule, m.next.due, late);
  m.next_release += m.next.ticks * finemote_schedule.tick;
  m.next = m.plan.next(finemote_schedule);
  if (m.next_release >= m.end) m.next_release = kNever;
  m.fed = !m.watch.starving();
  if (late != 0) detail::report_overruns(late);
}

// The release comes after the bus interrupts of the same instant, as their priorities say.
void take_interrupts(Machine& m) {
  m.in_interrupt = true;
  while (next_happening(m) <= m.now) {
    if (!m.interrupts.empty() && m.interrupts.top().at <= m.now) {
      const auto routine = m.interrupts.top().routine;
      m.interrupts.pop();
      routine();
    } else {
      release(m);
    }
  }
  m.in_interrupt = false;
}

// The most urgent pending bucket that may interrupt the running code, or the number of buckets.
unsigned most_urgent(const Machine& m) {
  const auto& buckets = finemote_schedule.buckets;
  unsigned i = 0;
  while (i < buckets.size() && !((m.pending >> i & 1U) != 0 && buckets[i].priority < m.level)) ++i;
  return i;
}

// All that is due at this instant, then every bucket it made ready, before the running code goes on.
void admit(Machine& m) {
  if (m.in_interrupt) return;
  take_interrupts(m);
  while (m.now < m.end) {
    const unsigned i = most_urgent(m);
    if (i == finemote_schedule.buckets.size()) return;
    const Bucket& bucket = finemote_schedule.buckets[i];
    const unsigned interrupted = m.level;
    m.pending &= ~(1U << i);
    m.active |= 1U << i;
    m.level = bucket.priority;
    bucket.entry();
    m.level = interrupted;
    m.active &= ~(1U << i);
    take_interrupts(m);
  }
}

// Time passes to `until`; what happens at `until` itself is left to the next stage.
void pass(Machine& m, Duration work) {
  while (work > 0) {
    const Time next = next_happening(m);
    if (next >= m.now + work) {
      m.now += work;
      return;
    }
    if (next > m.now) {
      work -= next - m.now;
      m.now = next;
    }
    admit(m);
  }
}

void idle_until(Machine& m, Time until) {
  admit(m);
  while (m.now < until) {
    m.now = std::min(std::max(m.now, next_happening(m)), until);
    if (m.now < until) admit(m);
  }
}

}  // namespace

Time now() { return machine().now; }

void busy(Duration work) {
  Machine& m = machine();
  if (!m.in_interrupt) pass(m, work);
}

#ifdef FINEMOTE_TRACE
void trace(std::uint32_t code) {
  Machine& m = machine();
  const bool end = (code & 1U) != 0;
  if (!end) admit(m);  // at one instant: finished stages publish, then releases and interrupts, then work begins
  if (m.now < m.end) m.events.push_back({m.now, static_cast<std::uint16_t>(code >> 1), end});
}
#endif

// The interrupted jobs are never returned to: run() catches this.
struct Stopped {};

void stop_safely(Module module, std::uint8_t number, const char* text) {
  Machine& m = machine();
  count_fault(module, number);
  m.stop_text = text != nullptr ? text : "stopped";
  m.next_release = kNever;
  detail::set_stopped(true);
  if (detail::outputs_started()) finemote_schedule.safe_outputs();
  throw Stopped{};
}

namespace host {

void interrupt_at(Time when, std::function<void()> routine) {
  Machine& m = machine();
  m.interrupts.push({std::max(when, m.now), m.orders++, std::move(routine)});
}

bool run(Duration duration) {
  Machine& m = machine();
  for (unsigned i = 0; i < finemote_schedule.buckets.size(); ++i) finemote_schedule.buckets.state(i).bit = 1U << i;
  m.end = duration;
  try {
    detail::start_robot(finemote_schedule, kTimer);
    m.plan.start(finemote_schedule, UINT32_MAX);
    m.next = m.plan.next(finemote_schedule);
    m.next_release = 0;
    idle_until(m, duration);
  } catch (const Stopped&) {
    return false;
  }
  return true;
}

void advance(Duration duration) {
  Machine& m = machine();
  idle_until(m, m.now + duration);
}

const std::vector<Event>& events() { return machine().events; }
bool watchdog_fed() { return machine().fed; }
const std::string& stop_text() { return machine().stop_text; }

void reset() {
  machine() = Machine{};
  detail::set_stopped(false);
}

void print_run() {
  for (const Event& event : events()) {
    std::printf("E %lld %u %c\n", static_cast<long long>(event.at), event.stage, event.end ? 'E' : 'B');
  }
  for (unsigned i = 0; i < finemote_schedule.buckets.size(); ++i) std::printf("O %u %u\n", i, overruns(i));
  unsigned number = 0;
  for (const BusCounters* bus = first_bus(); bus != nullptr; bus = bus->next) {
    std::printf("B %u %u %u\n", number++, bus->transfers, bus->errors);
  }
  for (unsigned i = 0; i < kFaultRecords && fault_record(i).count != 0; ++i) {
    const FaultRecord record = fault_record(i);
    std::printf("F %u %u %u\n", static_cast<unsigned>(record.module), record.number, record.count);
  }
  if (!stop_text().empty()) std::printf("S %lld\n", static_cast<long long>(now()));
#ifdef FINEMOTE_MONITOR
  for (unsigned i = 0; i < finemote_monitor.devices.size(); ++i) {
    const MonitorRecord& record = finemote_monitor.records[i];
    std::printf("M %u %lld %lld %u %u\n", i, static_cast<long long>(record.response_max),
                static_cast<long long>(record.age_max), record.response_violations, record.age_violations);
  }
#endif
}

}  // namespace host
}  // namespace finemote
