#include "generator/run/chains.hpp"

#include <algorithm>
#include <map>

namespace finemote::gen {
namespace {

/// Where a device's output can be seen: itself, or a channel of the part it drives.
struct OutputPlace {
  std::string part;
  std::uint32_t channel = 0;
};

OutputPlace output_of(const Robot& robot, const Device& device) {
  if (!device.segment) return {device.name.text, 0};
  const Segment& segment = robot.segments[*device.segment];
  if (segment.kind != Segment::Kind::pwm_expander) return {device.name.text, device.channel.value_or(0)};
  return {robot.expanders[*segment.expander].name.text, device.channel.value_or(0)};
}

/// When the samples of a part were taken, by channel and number.
std::map<std::pair<std::uint32_t, std::uint32_t>, Duration> samples_of(const RunRecord& record,
                                                                       const std::string& part) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, Duration> samples;
  for (const PartRecord& event : record.parts) {
    if (!event.is_output && event.part == part) samples.emplace(std::pair(event.channel, event.n), event.from());
  }
  return samples;
}

/// What the state of a device is made of: when the oldest sample was taken, of all channels of its part, that each of
/// its updates took, in the order of time.
class TakenSamples {
 public:
  TakenSamples(const Robot& robot, const Forest& forest, const RunRecord& record, DeviceId device) {
    const std::string& name = robot.devices[device].name.text;
    const auto samples = samples_of(record, name);
    const std::uint32_t update = static_cast<std::uint32_t>(2 * forest.rank[device].value());
    for (const SampleUse& use : record.uses) {
      const auto sample = samples.find({use.channel, use.n});
      if (use.stage != update || use.part != name || sample == samples.end()) continue;
      const Duration end = nanoseconds(floor_div(use.at_ps, 1'000));
      if (!ends_.empty() && ends_.back() == end) {
        from_.back() = std::min(from_.back(), sample->second);
      } else {
        ends_.push_back(end);
        from_.push_back(sample->second);
      }
    }
  }

  /// Age of the sample at the begin of the update that took it; none: it took none that is known.
  [[nodiscard]] std::optional<Duration> age(const StageRun& update) const {
    const auto found = std::lower_bound(ends_.begin(), ends_.end(), update.end);
    if (found == ends_.end() || *found != update.end) return std::nullopt;
    return update.begin - from_[static_cast<std::size_t>(found - ends_.begin())];
  }

 private:
  std::vector<Duration> ends_, from_;
};

/// When the command of each handle of a device reached an output first, by the number of the run.
class ReachedOutputs {
 public:
  ReachedOutputs(const Robot& robot, const Forest& forest, const RunRecord& record, DeviceId device) {
    const OutputPlace place = output_of(robot, robot.devices[device]);
    const std::uint32_t handle = static_cast<std::uint32_t>(2 * forest.rank[device].value() + 1);
    for (const PartRecord& event : record.parts) {
      const bool is_meant =
          event.is_output && event.stage == handle && event.part == place.part && event.channel == place.channel;
      if (is_meant) at_.emplace(event.n, event.at());
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
    if (age) keep(series.acquire, *age);
    if (output) keep(series.wire, *output - sample.handle_end);
    if (age && output) keep(series.end_to_end, *age + decide + *output - sample.handle_end);
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
    const Series series = collect(robot, forest, record, chain.from, chain.to);
    chain.acquire = {summarize(series.acquire), bound_of(bound.acquire)};
    chain.decide = {summarize(series.decide), bound_of(bound.decide)};
    chain.wire = {summarize(series.wire), bound_of(bound.wire)};
    chain.end_to_end = {summarize(series.end_to_end), bound_of(bound.end_to_end)};
    chains.push_back(chain);
  }
  return chains;
}

}  // namespace finemote::gen
