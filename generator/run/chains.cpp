#include "generator/run/chains.hpp"

#include <algorithm>
#include <map>

#include "generator/forest/stage.hpp"
#include "generator/run/measure.hpp"
#include "generator/run/samples.hpp"

namespace finemote::gen {
namespace {

/// Where a device's output can be seen: at its own part, or at a channel of the part it drives.
struct OutputPlace {
  std::string part;
  std::optional<std::uint32_t> channel = {};  ///< none: any

  [[nodiscard]] bool has(const PartRecord& event) const {
    return event.is_output && event.part == part && (!channel || event.channel == *channel);
  }
};

OutputPlace output_of(const Robot& robot, const Device& device) {
  const Segment* segment = device.segment ? &robot.segments[*device.segment] : nullptr;
  if (segment == nullptr || segment->kind != Segment::Kind::pwm_expander) return {device.name.text};
  return {robot.expanders[*segment->expander].name.text, device.channel.value_or(0)};
}

/// How old the data are that an update took: of all channels of the device's part, the oldest sample.
class TakenSamples {
 public:
  TakenSamples(const Robot& robot, const Forest& forest, const RunRecord& record, DeviceId device)
      : states_(states_of(robot, forest, record, device)) {}

  /// At the begin of the update; none: it took none that is known.
  [[nodiscard]] std::optional<Duration> age(const StageRun& update) const {
    const auto is_before = [](const SampledState& state, Duration end) { return state.at() < end; };
    const auto found = std::lower_bound(states_.begin(), states_.end(), update.end, is_before);
    if (found == states_.end() || found->at() != update.end) return std::nullopt;
    return update.begin - picoseconds_down(found->from_ps);
  }

 private:
  std::vector<SampledState> states_;
};

/// When the command of each handle of a device reached an output first, by the number of the run.
class ReachedOutputs {
 public:
  ReachedOutputs(const Robot& robot, const Forest& forest, const RunRecord& record, DeviceId device) {
    const OutputPlace place = output_of(robot, robot.devices[device]);
    const std::uint32_t handle = Stage{forest.rank[device], true}.number();
    for (const PartRecord& event : record.parts) {
      if (event.stage == handle && place.has(event)) at_.emplace(event.n, event.at());
    }
  }

  /// None: a later command came first, or the run was over.
  [[nodiscard]] std::optional<Duration> of(std::uint32_t run) const {
    const auto found = at_.find(run);
    return found == at_.end() ? std::nullopt : std::optional(found->second);
  }

 private:
  std::map<std::uint32_t, Duration> at_;
};

struct Series {
  std::vector<Duration> acquire, decide, wire, end_to_end;
  std::vector<MeasuredAge> decisions, commands;
};

Series collect(const Robot& robot, const Forest& forest, const RunRecord& record, DeviceId from, DeviceId to) {
  Series series;
  const TakenSamples taken(robot, forest, record, from);
  const ReachedOutputs reached(robot, forest, record, to);
  const auto keep = [&](std::vector<Duration>& list, Duration time) { list.push_back(record.true_time(time)); };
  for (const DecisionSample& sample : decision_samples(record, find_chain(robot, from, to))) {
    const Duration decide = sample.handle_end - sample.update.begin;
    const auto age = taken.age(sample.update);
    const auto output = reached.of(sample.handle_run);
    keep(series.decide, decide);
    series.decisions.push_back({sample.handle_end, series.decide.back()});
    if (age) keep(series.acquire, *age);
    if (output) keep(series.wire, *output - sample.handle_end);
    if (!age || !output) continue;
    keep(series.end_to_end, *age + decide + *output - sample.handle_end);
    series.commands.push_back({*output, series.end_to_end.back()});
  }
  return series;
}

}  // namespace

std::vector<MeasuredChain> measure_chains(const Robot& robot, const Forest& forest, const timing::Timing& timing,
                                          const RunRecord& record, bool is_bound) {
  std::vector<MeasuredChain> chains;
  const auto bound_of = [&](std::optional<Duration> bound) { return is_bound ? bound : std::nullopt; };
  for (const timing::ChainResult& bound : timing.chains) {
    MeasuredChain chain;
    chain.from = forest.order[bound.from];
    chain.to = forest.order[bound.to];
    Series series = collect(robot, forest, record, chain.from, chain.to);
    chain.acquire = {summarize(series.acquire), bound_of(bound.acquire)};
    chain.decide = {summarize(series.decide), bound_of(bound.decide)};
    chain.wire = {summarize(series.wire), bound_of(bound.wire)};
    chain.end_to_end = {summarize(series.end_to_end), bound_of(bound.end_to_end)};
    chain.ages = std::move(series.commands.empty() ? series.decisions : series.commands);
    chains.push_back(std::move(chain));
  }
  return chains;
}

}  // namespace finemote::gen
