#include "generator/run/chains.hpp"

#include <algorithm>
#include <map>

#include "generator/run/reached_outputs.hpp"
#include "generator/run/samples.hpp"

namespace finemote::gen {
namespace {

/// How old the data are that an update took: of all channels of the device's part, the oldest sample.
class TakenSamples {
 public:
  TakenSamples(const Robot& robot, const Forest& forest, const RunRecord& record, DeviceId device)
      : states_(states_of(robot, forest, record, device)) {}

  /// When the update starts; none: it took none that is known.
  [[nodiscard]] std::optional<Duration> age(const StageRun& update) const {
    const auto is_before = [](const SampledState& state, Duration end) { return state.at() < end; };
    const auto found = std::lower_bound(states_.begin(), states_.end(), update.end, is_before);
    if (found == states_.end() || found->at() != update.end) return std::nullopt;
    return update.begin - picoseconds_down(found->from_ps);
  }

 private:
  std::vector<SampledState> states_;
};

struct Series {
  std::vector<Duration> acquire, decide, wire, end_to_end;
  std::vector<Duration> waiting;  ///< so far: of commands that had not come out by the end
  std::vector<MeasuredAge> decisions, commands;
};

/// What is known of the ends of chains, each found once: many chains share one.
class ChainEnds {
 public:
  ChainEnds(const Robot& robot, const Forest& forest, const RunRecord& record)
      : robot_(robot), forest_(forest), record_(record) {}

  const TakenSamples& taken(DeviceId from) {
    return taken_.try_emplace(from, robot_, forest_, record_, from).first->second;
  }
  const ReachedOutputs& reached(DeviceId to) {
    return reached_.try_emplace(to, robot_, forest_, record_, to).first->second;
  }

 private:
  const Robot& robot_;
  const Forest& forest_;
  const RunRecord& record_;
  std::map<DeviceId, TakenSamples> taken_;
  std::map<DeviceId, ReachedOutputs> reached_;
};

/// @param has_wire  the command goes on from the end of the last handle(); else that is where it takes effect
Series collect(const Robot& robot, const RunRecord& record, const StageRuns& runs, ChainEnds& ends, DeviceId from,
               DeviceId to, bool has_wire) {
  Series series;
  const TakenSamples& taken = ends.taken(from);
  const ReachedOutputs& reached = ends.reached(to);
  const std::vector<StageRun>& handles = runs.of(to, true);
  const auto keep = [&](std::vector<Duration>& list, Duration time) { list.push_back(record.true_time(time)); };
  for (const DecisionSample& sample : decision_samples(record, runs, find_chain(robot, from, to))) {
    const Duration decide = sample.handle_end - sample.update.begin;
    const auto age = taken.age(sample.update);
    const auto output = has_wire ? reached.of(sample.handle_run) : std::optional(sample.handle_end);
    keep(series.decide, decide);
    series.decisions.push_back({sample.handle_end, series.decide.back()});
    if (age) keep(series.acquire, *age);
    const auto end_of_wait = output ? output : reached.overtaken(sample.handle_run);
    if (end_of_wait && has_wire) keep(series.wire, *end_of_wait - sample.handle_end);
    if (reached.is_awaited(sample.handle_run)) keep(series.waiting, handles.back().end - sample.handle_end);
    if (!age || !output) continue;
    keep(series.end_to_end, *age + decide + *output - sample.handle_end);
    series.commands.push_back({*output, series.end_to_end.back()});
  }
  return series;
}

MeasuredChain measure_chain(const Robot& robot, const Forest& forest, const timing::ChainResult& bound,
                            const RunRecord& record, const StageRuns& runs, ChainEnds& ends, bool is_bound) {
  const auto bound_of = [&](std::optional<Duration> one) { return is_bound ? one : std::nullopt; };
  MeasuredChain chain;
  chain.from = forest.order[bound.from];
  chain.to = forest.order[bound.to];
  chain.has_wire = robot.devices[chain.to].type->actuator || bound.wire != Duration::zero();
  Series series = collect(robot, record, runs, ends, chain.from, chain.to, chain.has_wire);
  for (const Duration waiting : series.waiting) {  // any shorter one may still come out in time
    if (bound.wire && waiting > *bound.wire) series.wire.push_back(waiting);
  }
  chain.acquire = {summarize(series.acquire), bound_of(bound.acquire)};
  chain.decide = {summarize(series.decide), bound_of(bound.decide)};
  chain.wire = {summarize(series.wire), bound_of(bound.wire)};
  chain.end_to_end = {summarize(series.end_to_end), bound_of(bound.end_to_end)};
  chain.ages = std::move(series.commands.empty() ? series.decisions : series.commands);
  return chain;
}

bool breaks_a_bound(const MeasuredChain& chain) {
  return std::any_of(kChainFigures.begin(), kChainFigures.end(),
                     [&](const auto& figure) { return (chain.*figure.measured).judged() == Judgement::broken; });
}

/// Unbounded is largest.
bool is_larger(const Measured& a, const Measured& b) { return b.bound && (!a.bound || *a.bound > *b.bound); }

}  // namespace

std::vector<MeasuredChain> measure_chains(const Robot& robot, const Forest& forest, const timing::Timing& timing,
                                          const RunRecord& record, const StageRuns& runs, bool is_bound) {
  std::vector<MeasuredChain> chains;
  ChainEnds ends(robot, forest, record);
  for (const timing::ChainResult& bound : timing.chains)
    chains.push_back(measure_chain(robot, forest, bound, record, runs, ends, is_bound));
  for (const timing::ChainResult& bound : timing.others) {
    if (!is_bound) break;  // there is nothing they could break
    chains.push_back(measure_chain(robot, forest, bound, record, runs, ends, is_bound));
    chains.back().is_listed = false;
  }
  return chains;
}

void leave_out_others(const Robot& robot, std::vector<MeasuredChain>& chains) {
  Table<DeviceId, const MeasuredChain*> longest(robot.devices.size());  // none: a listed one ends there
  Table<DeviceId, bool> is_end(robot.devices.size());
  for (const MeasuredChain& chain : chains) is_end[chain.to] = is_end[chain.to] || chain.is_listed;
  for (const MeasuredChain& chain : chains) {
    const MeasuredChain*& known = longest[chain.to];
    if (is_end[chain.to] || !robot.devices[chain.to].type->actuator) continue;
    if (known == nullptr || is_larger(chain.end_to_end, known->end_to_end)) known = &chain;
  }
  std::vector<MeasuredChain> kept;
  for (const MeasuredChain& chain : chains) {
    if (chain.is_listed || breaks_a_bound(chain) || longest[chain.to] == &chain) kept.push_back(chain);
  }
  chains = std::move(kept);
}

}  // namespace finemote::gen
