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

/// `can.b.CAN1_RX0` is of the bus `can.b`, where there is one, and not of `can`.
std::optional<BusId> bus_of(const LineBounds& line, const Robot& robot) {
  const std::string_view source = line.source;
  std::optional<BusId> found;
  for (const BusId bus : robot.buses.ids()) {
    const std::string& name = robot.buses[bus].name.text;
    const bool is_named = source.size() > name.size() && source.substr(0, name.size()) == name;
    const bool is_longer = !found || name.size() > robot.buses[*found].name.text.size();
    if (is_named && source[name.size()] == '.' && is_longer) found = bus;
  }
  return found;
}

/// The longest of each number of frames.
void take_requests(const std::vector<Duration>& requests, std::vector<Duration>& all) {
  if (all.size() < requests.size()) all.resize(requests.size());
  for (std::size_t i = 0; i < requests.size(); ++i) all[i] = std::max(all[i], requests[i]);
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
  if (!line.requests.empty()) take_requests(line.requests, costs.requests[*bus]);
}

}  // namespace

std::optional<ComputedCosts> computed_costs(const TimingFile& file, const Robot& robot) {
  const SchedulerBounds& bounds = file.scheduler;
  if (!file.is_complete || !bounds.release || !bounds.masked || bounds.behind.empty()) return std::nullopt;
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
  }
  for (const LineBounds& line : file.lines) take_line(line, robot, costs);
  costs.retries = {find_or_zero(bounds.retries, cost_words::kRelease),
                   find_or_zero(bounds.retries, cost_words::kReceived),
                   find_or_zero(bounds.retries, cost_words::kEvent)};
  return costs;
}

}  // namespace finemote::gen
