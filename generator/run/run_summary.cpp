#include "generator/run/run_summary.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/timing/table.hpp"

namespace finemote::gen {
namespace {

void print_bounds(const RunResult& result, std::ostream& out) {
  const RunResult::BoundCount count = result.count_bounds();
  if (count.broken > 0)
    out << fmt::format("ABOVE THEIR BOUNDS: {} of {} measured values\n", count.broken, count.judged);
  else if (!result.bounds_hold())
    out << "ABOVE THEIR BOUNDS by the monitor in the firmware\n";
  else if (count.judged > count.excused)
    out << fmt::format("every bound that counts was held, by {} measured values\n", count.judged - count.excused);
  else if (result.must_judge)
    out << "nothing was judged: no figure has both a bound that counts and a sample\n";
  if (count.excused > 0)
    out << fmt::format("{} more {} above bounds that do not count: the scenario violated their assumption\n",
                       count.excused, count.excused == 1 ? "value is" : "values are");
}

void print_worst_age(const RunResult& result, std::ostream& out) {
  const MeasuredChain* worst = nullptr;
  for (const MeasuredChain& chain : result.figures.chains) {
    if (chain.end_to_end.observed.count == 0) continue;
    if (worst == nullptr || chain.end_to_end.observed.max > worst->end_to_end.observed.max) worst = &chain;
  }
  if (worst == nullptr) return;
  const Measured& age = worst->end_to_end;
  const bool is_excused = age.judged() == Judgement::broken && result.bounds_hold();
  out << fmt::format("worst age of a command: {} measured, {} bound{} ({} -> {})\n",
                     timing::duration_text(age.observed.max), timing::duration_text(age.bound),
                     is_excused ? " (broken by what the scenario did)" : "", name_of(result, worst->from),
                     name_of(result, worst->to));
}

}  // namespace

const Measured& whole_of(const MeasuredChain& chain) {
  return chain.end_to_end.observed.count > 0 ? chain.end_to_end : chain.decide;
}

void print_summary(const RunResult& result, std::ostream& out) {
  print_bounds(result, out);
  print_worst_age(result, out);
  if (result.order.mistake)
    out << "out of order: " << *result.order.mistake << "\n";
  else if (result.order.is_judged)
    out << "every stage ran in its order\n";
  const std::vector<ExpectationRecord>& expected = result.record.expectations;
  const auto met = std::count_if(expected.begin(), expected.end(), [](const ExpectationRecord& e) { return e.ok; });
  if (!expected.empty()) out << fmt::format("{} of {} expectations of the scenario were met\n", met, expected.size());
  const unsigned scripted = result.record.scripted_resets;
  out << fmt::format("overruns {}, resets {}{}\n", result.overruns(), result.record.resets,
                     scripted > 0 ? fmt::format(" beside {} of the scenario", scripted) : "");
  if (result.schedulable)
    out << fmt::format("schedulable: {} (finemote analyze)\n", *result.schedulable ? "yes" : "no");
  for (const FaultCount& fault : result.record.faults)
    out << "fault: " << fault_text(result.fault_table, fault) << "\n";
  if (!result.unexplained_faults().empty()) out << "no scenario asked for these faults\n";
}

}  // namespace finemote::gen
