#include "release.hpp"

#include "finemote/fault.hpp"

// The default hook does nothing; a robot may bring its own.
extern "C" __attribute__((weak)) void finemote_overrun_hook(unsigned) {}

namespace finemote {
namespace detail {

Ticks ticks_in(Duration period, std::uint32_t tick_ns) {
  std::uint64_t quotient = 0;
  std::uint64_t rest = 0;
  for (unsigned bit = 63; bit-- > 0;) {
    rest = rest << 1 | (static_cast<std::uint64_t>(period) >> bit & 1U);
    quotient <<= 1;
    if (rest < tick_ns) continue;
    rest -= tick_ns;
    quotient |= 1;
  }
  return {quotient > UINT32_MAX ? UINT32_MAX : static_cast<std::uint32_t>(quotient), rest == 0};
}

void ReleasePlan::start(const Schedule& schedule, std::uint32_t longest_step) {
  const Buckets& buckets = schedule.buckets;
  for (std::size_t i = 0; i < buckets.size(); ++i) {
    const Ticks period = ticks_in(buckets[i].period, static_cast<std::uint32_t>(schedule.tick));
    buckets.state(i) = {0, period.count, buckets.state(i).bit};
  }
  step_ = 0;
  longest_step_ = longest_step;
}

Release ReleasePlan::next(const Schedule& schedule) {
  Release release{0, longest_step_};
  for (std::size_t i = 0; i < schedule.buckets.size(); ++i) {
    BucketState& bucket = schedule.buckets.state(i);
    bucket.left -= step_;
    if (bucket.left == 0) {
      bucket.left = bucket.period;
      release.due |= bucket.bit;
    }
    if (bucket.left < release.ticks) release.ticks = bucket.left;
  }
  step_ = release.ticks;
  return release;
}

void StarvationWatch::note(const Schedule& schedule, std::uint32_t due, std::uint32_t late) {
  for (std::size_t i = 0; i < schedule.buckets.size(); ++i) {
    BucketState& bucket = schedule.buckets.state(i);
    if ((due & bucket.bit) == 0) continue;
    if ((late & bucket.bit) == 0) {
      bucket.missed = 0;
      late_ &= ~bucket.bit;
      starving_ &= ~bucket.bit;
      continue;
    }
    late_ |= bucket.bit;
    if (bucket.missed < schedule.buckets[i].watchdog) ++bucket.missed;
    if (bucket.missed >= schedule.buckets[i].watchdog) starving_ |= bucket.bit;
  }
}

void report_overruns(std::uint32_t late) {
  for (unsigned i = 0; i < finemote_schedule.buckets.size(); ++i) {
    BucketState& bucket = finemote_schedule.buckets.state(i);
    if ((late & bucket.bit) == 0) continue;
    ++bucket.overruns;
    count_fault(Module::schedule, static_cast<std::uint8_t>(ScheduleFault::overrun));
    finemote_overrun_hook(i);
  }
  if (finemote_schedule.overrun == Overrun::safe_stop) {
    stop_safely(Module::schedule, static_cast<std::uint8_t>(ScheduleFault::overrun),
                FINEMOTE_TEXT("schedule: a bucket overran"));
  }
}

}  // namespace detail

std::uint32_t overruns(unsigned bucket) { return finemote_schedule.buckets.state(bucket).overruns; }

}  // namespace finemote
