#include "release.hpp"

#include "finemote/fault.hpp"

// The default hook does nothing; a robot may bring its own.
extern "C" __attribute__((weak)) void finemote_overrun_hook(unsigned) {}

namespace finemote {
namespace detail {

volatile std::uint8_t completed[kMaxBuckets];

namespace {
std::uint32_t overrun_counts[kMaxBuckets];
// Up to three releases are planned before the first job of a bucket can have run.
constexpr std::int16_t kHeadStart = -3;
}  // namespace

void ReleasePlan::start(const Schedule& schedule, const std::uint32_t* bits, std::uint32_t longest_step) {
  end_ = entries_;
  for (const Bucket& bucket : schedule.buckets) {
    const auto index = static_cast<unsigned>(end_ - entries_);
    *end_++ = Entry{0,           static_cast<std::uint32_t>(bucket.period / schedule.tick),
                    bits[index], &completed[index],
                    kHeadStart,  bucket.watchdog};
    completed[index] = 0;
    overrun_counts[index] = 0;
  }
  step_ = 0;
  longest_step_ = longest_step;
  starving_ = 0;
}

void ReleasePlan::recover(Entry& entry) {
  entry.missed = 0;
  starving_ &= ~entry.bit;
}

void ReleasePlan::miss(Entry& entry) {
  if (entry.missed < entry.limit) ++entry.missed;
  if (entry.missed >= entry.limit) starving_ |= entry.bit;
}

void report_overruns(std::uint32_t late, const std::uint32_t* bits) {
  for (unsigned i = 0; i < finemote_schedule.buckets.size(); ++i) {
    if ((late & bits[i]) == 0) continue;
    ++overrun_counts[i];
    count_fault(Module::schedule, static_cast<std::uint8_t>(ScheduleFault::overrun));
    finemote_overrun_hook(i);
  }
  if (finemote_schedule.overrun == Overrun::safe_stop) {
    stop_safely(Module::schedule, static_cast<std::uint8_t>(ScheduleFault::overrun), "schedule: a bucket overran");
  }
}

}  // namespace detail

std::uint32_t overruns(unsigned bucket) { return detail::overrun_counts[bucket]; }

}  // namespace finemote
