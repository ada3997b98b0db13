#include "finemote/monitor.hpp"

#include "finemote/schedule.hpp"

namespace finemote {
namespace {

Time releases[kMaxBuckets];  // of each bucket's present or next job; each written by its own bucket alone

void note(Duration value, Duration bound, Duration& most, std::uint32_t& violations) {
  if (value > most) most = value;
  if (value > bound) ++violations;
}

}  // namespace

void monitor_handle(unsigned device) {
  const Time end = now();
  const Monitored& bounds = finemote_monitor.devices[device];
  MonitorRecord& record = finemote_monitor.records[device];
  note(end - releases[bounds.bucket], bounds.response, record.response_max, record.response_violations);
  if (bounds.command == nullptr || !bounds.command->valid) return;
  note(end - bounds.command->origin, bounds.age, record.age_max, record.age_violations);
}

// A bucket is pended again at its first release that does not find it running; the ones it missed were overruns.
void monitor_job(unsigned bucket) {
  const Time end = now();
  const Duration period = finemote_schedule.buckets[bucket].period;
  Time& release = releases[bucket];
  do release += period;
  while (release < end);
}

}  // namespace finemote
