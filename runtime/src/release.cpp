#include "release.hpp"

#include "finemote/fault.hpp"

// The default hook does nothing; a robot may bring its own.
extern "C" __attribute__((weak)) void finemote_overrun_hook(unsigned) {}

namespace finemote {
namespace detail {

namespace {
std::uint32_t overrun_counts[kMaxBuckets];
}  // namespace

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

void ReleasePlan::start(const Schedule& schedule, const std::uint32_t* bits, std::uint32_t longest_step) {
  std::size_t count = 0;
  for (const Bucket& bucket : schedule.buckets) {
    entries_[count] = {0, ticks_in(bucket.period, static_cast<std::uint32_t>(schedule.tick)).count, bits[count]};
    overrun_counts[count++] = 0;
  }
  step_ = 0;
  longest_step_ = longest_step;
}

Release ReleasePlan::next(std::size_t buckets) {
  Release release{0, longest_step_};
  for (std::size_t i = 0; i < buckets; ++i) {
    Entry& entry = entries_[i];
    entry.left -= step_;
    if (entry.left == 0) {
      entry.left = entry.period;
      release.due |= entry.bit;
    }
    if (entry.left < release.ticks) release.ticks = entry.left;
  }
  step_ = release.ticks;
  return release;
}

void StarvationWatch::note(const Schedule& schedule, const std::uint32_t* bits, std::uint32_t due, std::uint32_t late) {
  for (unsigned i = 0; i < schedule.buckets.size(); ++i) {
    if ((due & bits[i]) == 0) continue;
    if ((late & bits[i]) == 0) {
      missed_[i] = 0;
      late_ &= ~bits[i];
      starving_ &= ~bits[i];
      continue;
    }
    late_ |= bits[i];
    if (missed_[i] < schedule.buckets[i].watchdog) ++missed_[i];
    if (missed_[i] >= schedule.buckets[i].watchdog) starving_ |= bits[i];
  }
}

void report_overruns(std::uint32_t late, const std::uint32_t* bits) {
  for (unsigned i = 0; i < finemote_schedule.buckets.size(); ++i) {
    if ((late & bits[i]) == 0) continue;
    ++overrun_counts[i];
    count_fault(Module::schedule, static_cast<std::uint8_t>(ScheduleFault::overrun));
    finemote_overrun_hook(i);
  }
  if (finemote_schedule.overrun == Overrun::safe_stop) {
    stop_safely(Module::schedule, static_cast<std::uint8_t>(ScheduleFault::overrun),
                FINEMOTE_TEXT("schedule: a bucket overran"));
  }
}

}  // namespace detail

std::uint32_t overruns(unsigned bucket) { return detail::overrun_counts[bucket]; }

}  // namespace finemote
