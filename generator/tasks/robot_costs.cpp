#include "generator/tasks/robot_costs.hpp"

#include <algorithm>

#include "generator/descriptor/runtime_limits.hpp"
#include "generator/model/firmware_inputs.hpp"

namespace finemote::gen::timing {
namespace {

/// Generous guesses.
constexpr Duration kMonitorGuess = microseconds(3);
constexpr Duration kEventGuess = microseconds(3);

/// The longest time that the release timer counts at once; it is whole ticks. Where no release is due until then, it
/// interrupts all the same.
Duration longest_step(const Robot& robot) {
  if (robot.board == nullptr) return Duration::max();
  constexpr std::int64_t kNsPerSecond = 1'000'000'000;
  const std::int64_t cycles = std::max<std::int64_t>(robot.tick.ns() * robot.board->cpu_hz / kNsPerSecond, 1);
  return runtime_limits::kTickCycles / cycles * robot.tick;
}

/// Whether the release timer plans instant by instant, for more instants in a hyperperiod than its ring holds.
bool walks(const Schedule& schedule, Duration step) {
  Duration at;
  for (std::size_t instants = 0; instants <= runtime_limits::kReleaseInstants; ++instants) {
    Duration next = step > Duration::max() - at ? Duration::max() : at + step;
    for (const gen::Bucket& bucket : schedule.buckets)
      next = std::min(next, (floor_div(at, bucket.period) + 1) * bucket.period);
    at = next;
    const auto is_due = [&](const gen::Bucket& bucket) { return is_multiple(at, bucket.period); };
    if (std::all_of(schedule.buckets.begin(), schedule.buckets.end(), is_due))
      return instants >= runtime_limits::kReleaseInstants;
  }
  return true;
}

Duration release_cost(const gen::Costs& costs, const Schedule& schedule, Duration step) {
  if (schedule.buckets.empty() || !walks(schedule, step)) return costs.release;
  return costs.release + costs.release_walk +
         static_cast<std::int64_t>(schedule.buckets.size()) * costs.release_walk_per_bucket;
}

/// Of jobs that no flush ends: a flush takes it else.
Duration longest_behind(const ComputedCosts& computed, const Schedule& schedule) {
  Duration longest;
  for (const gen::Bucket& bucket : schedule.buckets) {
    if (bucket.flushes.empty()) longest = std::max(longest, computed.behind_jobs(bucket.period));
  }
  return longest;
}

/// Bounds of the image in place of what the board file says. What runs before a stage is charged with the stage.
void take_bounds_of_image(const ComputedCosts& computed, const Schedule& schedule, Duration job, Costs& costs) {
  const auto jobs = static_cast<std::int64_t>(schedule.buckets.size());  // each may be amid what a release disturbs
  costs.release = costs.interrupt + computed.release + jobs * computed.retries.release;
  costs.release_per_bucket = Duration::zero();
  costs.job = job + longest_behind(computed, schedule);
  costs.stage = Duration::zero();
  costs.masked = computed.masked;
  costs.source = WcetSource::computed;
}

}  // namespace

const gen::Costs& board_costs(const Robot& robot) {
  static constexpr gen::Costs kNone{};
  if (robot.board == nullptr) return kNone;
  return runs_code_in_sram(robot) ? robot.board->costs_in_sram : robot.board->costs;
}

Duration monitor_cost(std::optional<Duration> of_board) { return of_board.value_or(kMonitorGuess); }

Costs robot_costs(const Robot& robot, const Schedule& schedule, const RobotTimingOptions& options) {
  const gen::Costs& costs = board_costs(robot);
  Costs result;
  result.interrupt = costs.interrupt();
  const Duration step = longest_step(robot);
  result.release = release_cost(costs, schedule, step) + result.interrupt;
  if (!schedule.buckets.empty() && schedule.buckets.front().period > step) result.longest_release = step;
  result.release_per_bucket = costs.release_per_bucket;
  result.job = costs.bucket + costs.job();
  result.stage = costs.stage;
  result.masked = costs.masked_section;
  result.keeps_one_release = true;
  result.event_entry = costs.event_entry.value_or(kEventGuess);
  result.event_pause = costs.event_pause.value_or(kEventGuess);
  result.source = WcetSource::assumed;
  if (robot.computed) take_bounds_of_image(*robot.computed, schedule, costs.job(), result);
  if (options.trace || options.monitor) result.masked = std::max(result.masked, costs.masked_section);
  if (options.trace) result.stage += 2 * costs.trace_event;
  if (options.monitor) result.job += monitor_cost(costs.monitor_job);
  return result;
}

Duration supervision(const Robot& robot) {
  Duration sum;
  if (robot.board == nullptr) return sum;
  for (const gen::Bus& bus : robot.buses) {
    const Driver* driver = robot.board->driver(bus.kind);
    if (driver != nullptr) sum += driver->supervise;
  }
  return sum;
}

}  // namespace finemote::gen::timing
