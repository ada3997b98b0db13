// FM4027: whose releases come too close, and what keeps their interrupt from ending in between.
#include <fmt/format.h>

#include <algorithm>

#include "generator/timing/explain.hpp"
#include "generator/timing/table.hpp"
#include "generator/units/units.hpp"

namespace finemote::gen::timing {
namespace {

std::string closest_text(const ReleaseResult& release) {
  const std::string distance = units::format_duration(release.deadline);
  if (release.is_in_between) {
    return fmt::format(
        "the shortest period, {}, is more than the timer can count, so that it interrupts in between: at most a tick, "
        "{}, before a release",
        units::format_duration(release.period), distance);
  }
  if (release.period == release.other) return fmt::format("devices are released every {}", distance);
  return fmt::format("releases every {} and every {} come as close as {}", units::format_duration(release.period),
                     units::format_duration(release.other), distance);
}

/// The interrupts that take longest, each with its time.
std::string longest_interrupts(const Timing& timing) {
  constexpr std::size_t kMost = 3;
  std::vector<const ProcessorUse*> uses;
  for (const ProcessorUse& use : timing.processor) {
    if (use.kind == ProcessorUse::Kind::interrupt) uses.push_back(&use);
  }
  std::stable_sort(uses.begin(), uses.end(),
                   [](const ProcessorUse* a, const ProcessorUse* b) { return a->cost > b->cost; });
  std::string text;
  for (std::size_t i = 0; i < std::min(uses.size(), kMost); ++i)
    text += fmt::format("{}{} ({})", i > 0 ? ", " : "", user_text(*uses[i]), duration_text(uses[i]->cost));
  return text;
}

}  // namespace

bool report_release(const Timing& timing, Diagnostics& diagnostics) {
  const ProfileResult& verdict = timing.verdict();
  if (!verdict.release || !verdict.release->is_guilty()) return false;
  const ReleaseResult& release = *verdict.release;
  const auto bucket = std::find_if(verdict.buckets.begin(), verdict.buckets.end(),
                                   [&](const BucketResult& b) { return b.period == release.other; });
  Diagnostic& finding =
      diagnostics
          .error(code::timing_release, timing.model.devices[bucket->devices.front()].at,
                 fmt::format("releases can be lost: their interrupt may take longer than {}",
                             units::format_duration(release.deadline)))
          .note(fmt::format("{}; the timer keeps one that waits, and all jobs after a lost one are late",
                            closest_text(release)));
  const std::string interrupts = longest_interrupts(timing);
  if (!interrupts.empty()) finding.note(fmt::format("these are more urgent: {}", interrupts));
  finding.hint(release.is_in_between ? "choose a longer tick, or give the bus a higher rate"
                                     : "choose periods with a longer common divisor, or give the bus a higher rate");
  return true;
}

}  // namespace finemote::gen::timing
