#include "generator/run/chains.hpp"

#include <algorithm>

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

/// What one part did, in the order it could be read or took effect.
std::vector<PartRecord> events_of(const RunRecord& record, const std::string& part, bool outputs,
                                  std::uint32_t channel) {
  std::vector<PartRecord> events;
  for (const PartRecord& event : record.parts) {
    const bool meant = event.is_output == outputs && (!outputs || event.channel == channel);
    if (meant && event.part == part) events.push_back(event);
  }
  std::stable_sort(events.begin(), events.end(), [](const auto& a, const auto& b) { return a.at < b.at; });
  return events;
}

/// Age of the newest sample that could be read at `time`.
std::optional<Duration> sample_age(const std::vector<PartRecord>& samples, Duration time) {
  const auto after = std::upper_bound(samples.begin(), samples.end(), time,
                                      [](Duration t, const PartRecord& event) { return t < event.at; });
  if (after == samples.begin()) return std::nullopt;
  return time - std::prev(after)->from;  // parts sample in the order they send
}

/// When the output changed after `begin` and before the next command was made at `end`.
std::optional<Duration> output_change(const std::vector<PartRecord>& outputs, Duration begin, Duration end) {
  const auto found = std::lower_bound(outputs.begin(), outputs.end(), begin,
                                      [](const PartRecord& event, Duration t) { return event.at < t; });
  if (found == outputs.end() || found->at >= end) return std::nullopt;
  return found->at;
}

struct Series {
  std::vector<Duration> acquire, decide, wire, end_to_end;
};

Series collect(const Robot& robot, const RunRecord& record, DeviceId from, DeviceId to) {
  Series series;
  const std::vector<DecisionSample> samples = decision_samples(record, find_chain(robot, from, to));
  const OutputPlace place = output_of(robot, robot.devices[to]);
  const auto sensed = events_of(record, robot.devices[from].name.text, false, 0);
  const auto outputs = events_of(record, place.part, true, place.channel);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const DecisionSample& sample = samples[i];
    const Duration next = i + 1 < samples.size() ? samples[i + 1].handle_end : sample.handle_end;
    const Duration decide = sample.handle_end - sample.update_begin;
    const auto acquire = sample_age(sensed, sample.update_begin);
    const auto change = output_change(outputs, sample.handle_end, next);
    series.decide.push_back(decide);
    if (acquire) series.acquire.push_back(*acquire);
    if (change) series.wire.push_back(*change - sample.handle_end);
    if (acquire && change) series.end_to_end.push_back(*acquire + decide + *change - sample.handle_end);
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
    const Series series = collect(robot, record, chain.from, chain.to);
    chain.acquire = {summarize(series.acquire), bound_of(bound.acquire)};
    chain.decide = {summarize(series.decide), bound_of(bound.decide)};
    chain.wire = {summarize(series.wire), bound_of(bound.wire)};
    chain.end_to_end = {summarize(series.end_to_end), bound_of(bound.end_to_end)};
    chains.push_back(chain);
  }
  return chains;
}

}  // namespace finemote::gen
