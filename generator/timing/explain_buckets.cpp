// FM4015: why a bucket may run over its period.
#include <fmt/format.h>

#include "generator/timing/explain.hpp"
#include "generator/timing/words.hpp"

namespace finemote::gen::timing {
namespace {

/// Loads of what can keep a bucket from running, by what could be changed about it.
struct Loads {
  double own = 0, faster = 0, interrupts = 0;
};

Loads loads_of(const Timing& timing, Duration period) {
  Loads loads;
  for (const ProcessorUse& use : timing.processor) {
    const bool is_work = use.kind == ProcessorUse::Kind::bucket || use.kind == ProcessorUse::Kind::flush;
    if (!is_work) {
      loads.interrupts += use.utilization;
    } else if (use.every <= period) {
      (use.every == period ? loads.own : loads.faster) += use.utilization;
    }
  }
  return loads;
}

/// `'tx' interrupts of bus 'jetson' 38.0 %, devices every 1ms 30.1 %, ...`
std::string users(const Timing& timing) {
  constexpr std::size_t kMost = 6;
  std::string text;
  double rest = 0;
  for (std::size_t i = 0; i < timing.processor.size(); ++i) {
    const ProcessorUse& use = timing.processor[i];
    if (i >= kMost) {
      rest += use.utilization;
    } else {
      text += fmt::format("{}{} {}", i > 0 ? ", " : "", user_text(use), percent(use.utilization));
    }
  }
  if (timing.processor.size() > kMost)
    text += fmt::format(", {} more {}", timing.processor.size() - kMost, percent(rest));
  return text;
}

/// Who uses the processor, and what makes every bucket end in time.
void explain_load(const Timing& timing, double interrupts, Trials& trials, Diagnostic& finding) {
  finding.note(fmt::format("the processor needs {} of its time: {}", percent(timing.processor_load), users(timing)));
  const bool is_hopeless = interrupts >= 1;
  if (is_hopeless) finding.note("interrupts alone need all of it: neither longer periods nor less work help");
  for (const Remedy& remedy : processor_remedies(timing, trials)) {
    if (remedy.enough || !is_hopeless) finding.hint(processor_hint(timing, remedy));
  }
}

}  // namespace

void report_buckets(const Timing& timing, Trials& trials, Diagnostics& diagnostics) {
  bool is_first = true;
  for (const BucketResult& bucket : timing.verdict().buckets) {
    if (bucket.ok) continue;
    Diagnostic& finding = diagnostics.error(code::timing_unschedulable, timing.model.devices[bucket.devices.front()].at,
                                            bucket_text(bucket.period) + " may miss their deadline");
    const Loads loads = loads_of(timing, bucket.period);
    finding.note(fmt::format("they need {} of the processor, shorter periods {}, interrupts {} (profile {})",
                             percent(loads.own), percent(loads.faster), percent(loads.interrupts),
                             profile_name(timing.asked)));
    if (is_first) explain_load(timing, loads.interrupts, trials, finding);
    is_first = false;
  }
}

}  // namespace finemote::gen::timing
