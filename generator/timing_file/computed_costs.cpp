#include "generator/timing_file/computed_costs.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "generator/timing_file/cost_words.hpp"

namespace finemote::gen {
namespace {

using Counts = DriverSource::Counts;

constexpr std::pair<Counts, const char*> kCauses[] = {{Counts::requests, cost_words::kRequest},
                                                      {Counts::steps, cost_words::kStep},
                                                      {Counts::ends, cost_words::kEnd},
                                                      {Counts::received, cost_words::kReceived},
                                                      {Counts::events, cost_words::kEvent}};

Duration find_or_zero(const std::map<std::string, Duration>& times, const char* word) {
  const auto found = times.find(word);
  return found == times.end() ? Duration::zero() : found->second;
}

std::optional<BusId> bus_of(const LineBounds& line, const Robot& robot) {
  const std::string_view source = line.source;
  for (const BusId bus : robot.buses.ids()) {
    const std::string& name = robot.buses[bus].name.text;
    if (source.size() > name.size() && source.substr(0, name.size()) == name && source[name.size()] == '.') return bus;
  }
  return std::nullopt;
}

void take_line(const LineBounds& line, const Robot& robot, ComputedCosts& costs) {
  const auto bus = bus_of(line, robot);
  if (!bus) {
    costs.pins = std::max(costs.pins, line.longest);
    return;
  }
  for (const auto& [counts, word] : kCauses) {
    if (line.raised_by.count(word) == 0) continue;
    Duration& longest = costs.routines[{*bus, counts}];
    longest = std::max(longest, line.raised_by.at(word));
  }
  if (!line.requests.empty()) costs.requests[*bus] = line.requests;
}

}  // namespace

std::optional<ComputedCosts> computed_costs(const TimingFile& file, const Robot& robot) {
  const SchedulerBounds& bounds = file.scheduler;
  if (!file.is_complete || !bounds.release || !bounds.masked) return std::nullopt;
  for (const char* word : {cost_words::kRelease, cost_words::kReceived, cost_words::kEvent}) {
    if (bounds.retries.count(word) == 0) return std::nullopt;
  }
  ComputedCosts costs;
  costs.release = *bounds.release;
  costs.masked = *bounds.masked;
  costs.behind = bounds.behind;
  for (const Device& device : robot.devices) {
    const auto before = bounds.before.find(device.name.text);
    const StageBounds stages = before == bounds.before.end() ? StageBounds{} : before->second;
    costs.before.push_back({stages.update.value_or(Duration::zero()), stages.handle.value_or(Duration::zero())});
    if (costs.behind.count(device.period) == 0) return std::nullopt;
  }
  for (const LineBounds& line : file.lines) take_line(line, robot, costs);
  costs.retries = {find_or_zero(bounds.retries, cost_words::kRelease),
                   find_or_zero(bounds.retries, cost_words::kReceived),
                   find_or_zero(bounds.retries, cost_words::kEvent)};
  return costs;
}

}  // namespace finemote::gen
