#include "generator/run/run_result.hpp"

#include <algorithm>
#include <numeric>

namespace finemote::gen {

std::uint64_t RunResult::violations() const {
  std::uint64_t count = 0;
  for (const MonitorEntry& entry : record.monitor) count += entry.response_violations + entry.age_violations;
  return count;
}

std::uint64_t RunResult::overruns() const {
  return std::accumulate(record.overruns.begin(), record.overruns.end(), std::uint64_t{0});
}

namespace {

/// Every figure of a run that has a bound.
std::vector<Judgement> judgements(const RunResult& result) {
  std::vector<Judgement> all;
  const auto add = [&](std::initializer_list<const Measured*> figures) {
    for (const Measured* figure : figures) all.push_back(figure->judged());
  };
  for (const MeasuredChain& c : result.chains) add({&c.acquire, &c.decide, &c.wire, &c.end_to_end});
  for (const MeasuredResponse& r : result.responses) add({&r.update, &r.handle, &r.jitter});
  return all;
}

bool has(const std::vector<Judgement>& all, Judgement one) {
  return std::find(all.begin(), all.end(), one) != all.end();
}

}  // namespace

bool RunResult::bounds_hold() const { return !has(judgements(*this), Judgement::broken) && violations() == 0; }

bool RunResult::is_judged() const {
  const std::vector<Judgement> all = judgements(*this);
  return has(all, Judgement::held) || has(all, Judgement::broken);
}

bool RunResult::good() const {
  const auto& expected = record.expectations;
  const bool as_expected =
      std::all_of(expected.begin(), expected.end(), [](const ExpectationRecord& e) { return e.ok; });
  if (must_judge && !is_judged()) return false;
  return overruns() == 0 && record.resets == 0 && wcets_hold && (bounds_hold() || record.faulty) && as_expected;
}

const std::string& name_of(const RunResult& result, DeviceId device) { return result.robot.devices[device].name.text; }

}  // namespace finemote::gen
