#include "generator/run/wcet_scheduler.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "generator/board_sources/port_objects.hpp"
#include "generator/forest/stage.hpp"
#include "generator/image/exception.hpp"
#include "generator/timing_file/cost_words.hpp"
#include "generator/units/units.hpp"
#include "generator/wcet/cost_table.hpp"

namespace finemote::gen {
namespace {

using Json = nlohmann::ordered_json;
using wcet::Cycles;

/// In the order of their bits: runtime/include/finemote/raised_by.hpp.
constexpr std::pair<wcet::Causes, const char*> kCauses[] = {{wcet::kRequest, cost_words::kRequest},
                                                            {wcet::kStep, cost_words::kStep},
                                                            {wcet::kEnd, cost_words::kEnd},
                                                            {wcet::kReceived, cost_words::kReceived},
                                                            {wcet::kEvent, cost_words::kEvent}};

constexpr std::pair<wcet::RetriedBy, const char*> kRetries[] = {{wcet::RetriedBy::release, cost_words::kRelease},
                                                                {wcet::RetriedBy::received, cost_words::kReceived},
                                                                {wcet::RetriedBy::event, cost_words::kEvent}};

/// The bus that an exception belongs to, and its line there; empty: it is no bus's.
std::string source_of(const TimedRobot& timed, unsigned exception) {
  for (const Bus& bus : timed.robot.buses) {
    const Port* port = timed.robot.board->port(bus.port);
    if (port == nullptr) continue;
    for (const InterruptLine& line : port->interrupts) {
      if (exception_of(line.number) == exception) return bus.name.text + "." + line.name;
    }
  }
  return {};
}

/// Whether a pin that the robot uses raises the exception.
bool is_of_pin(const TimedRobot& timed, unsigned exception) {
  const auto raises = [&](const Use& use) {
    if (use.spec->function != "interrupt" || use.pin.empty()) return false;
    return exception_of(edge_interrupt(pin_name(use.pin))) == exception;
  };
  return std::any_of(timed.robot.devices.begin(), timed.robot.devices.end(),
                     [&](const Device& device) { return std::any_of(device.uses.begin(), device.uses.end(), raises); });
}

/// Of an interrupt that is no job's, for which the chip's file charges no more than entry and return.
Cycles context_of(const wcet::RoutineTime& routine) {
  return routine.uses_fpu ? wcet::documented_costs().fpu_context : 0;
}

Json causes_json(const TimedRobot& timed, const wcet::RoutineTime& routine) {
  Json causes = Json::object();
  for (const auto& [cause, word] : kCauses) {
    const auto found = routine.by_cause.find(cause);
    if (found != routine.by_cause.end()) causes[word] = ns_of(found->second + context_of(routine), timed);
  }
  return causes;
}

/// @param context  what it takes besides
void add_times(const TimedRobot& timed, const wcet::RoutineTime& routine, Cycles context, Json& entry) {
  entry["wcet_ns"] = ns_of(routine.without_faults.value_or(routine.cycles) + context, timed);
  entry["with_faults_ns"] = ns_of(routine.cycles + context, timed);
  if (context > 0) entry["uses_fpu"] = true;
}

/// Updates in the order of the forest, then handles the other way.
bool runs_before(Stage a, Stage b) {
  if (a.is_handle != b.is_handle) return b.is_handle;
  return a.is_handle ? b.rank < a.rank : a.rank < b.rank;
}

/// What several stages begin after is the first one's.
Stage first_of(const std::set<std::uint32_t>& marks) {
  Stage first = Stage::of_number(*marks.begin() / 2);
  for (const std::uint32_t mark : marks) {
    const Stage stage = Stage::of_number(mark / 2);
    if (runs_before(stage, first)) first = stage;
  }
  return first;
}

void add_gaps(const TimedRobot& timed, const wcet::Gaps& gaps, Json& scheduler) {
  std::map<std::uint32_t, std::pair<Stage, Cycles>> longest;
  for (const wcet::Gap& gap : gaps.before) {
    const Stage stage = first_of(gap.begun);
    auto& [whose, cycles] = longest.try_emplace(stage.number(), stage, 0).first->second;
    cycles = std::max(cycles, gap.cycles);
  }
  for (const auto& [number, before] : longest) {
    scheduler.push_back({{"what", cost_words::kBefore},
                         {"device", timed.robot.devices[timed.forest.order[before.first.rank]].name.text},
                         {"stage", stage_name(before.first.is_handle)},
                         {"wcet_ns", ns_of(before.second, timed)}});
  }
}

Cycles longest_masked(const wcet::ImageTimes& times) {
  Cycles longest = 0;
  for (const wcet::RoutineTime& routine : times.routines) {
    for (const wcet::BracketTime& bracket : routine.brackets) {
      if (bracket.mark == wcet::kMaskedMark) longest = std::max(longest, bracket.cycles);
    }
  }
  return longest;
}

}  // namespace

std::int64_t ns_of(Cycles cycles, const TimedRobot& timed) {
  constexpr std::int64_t kSecond = 1'000'000'000;
  const std::int64_t hz = timed.inputs.clock_hz;
  return cycles / hz * kSecond + (cycles % hz * kSecond + hz - 1) / hz;
}

std::optional<SchedulerTask> task_of(const TimedRobot& timed, unsigned exception) {
  if (exception == kSysTickException) return SchedulerTask{cost_words::kRelease};
  for (const Bucket& bucket : timed.schedule.buckets) {
    if (exception_of(bucket.line) == exception)
      return SchedulerTask{fmt::format("bucket {}", units::spaced_duration(bucket.period)), bucket.period};
  }
  return std::nullopt;
}

std::string interrupt_name(const TimedRobot& timed, const wcet::RoutineTime& routine) {
  const std::string source = source_of(timed, routine.exception);
  return source.empty() ? routine.name : source;
}

std::vector<wcet::TimeGap> foreign_routines(const TimedRobot& timed) {
  std::vector<wcet::TimeGap> foreign;
  for (const wcet::RoutineTime& routine : timed.times.routines) {
    const bool is_known = task_of(timed, routine.exception) || !source_of(timed, routine.exception).empty() ||
                          is_of_pin(timed, routine.exception);
    if (is_known || routine.path.empty()) continue;
    foreign.push_back({routine.path.front().address, routine.path.front().function,
                       "no bus, pin or job of the robot has this interrupt: nobody knows how often it runs, and "
                       "response times leave it out"});
  }
  return foreign;
}

std::vector<wcet::TimeGap> vanished_stages(const TimedRobot& timed) {
  std::vector<wcet::TimeGap> vanished;
  for (const Stage stage : stages_of(timed)) {
    if (bracket_of(timed, stage) == nullptr)
      vanished.push_back({0, name_of(timed, stage), "no way through this stage comes to its end"});
  }
  return vanished;
}

Json interrupts_json(const TimedRobot& timed) {
  Json interrupts = Json::array();
  for (const wcet::RoutineTime& routine : timed.times.routines) {
    if (task_of(timed, routine.exception)) continue;
    Json entry{{"source", interrupt_name(timed, routine)}};
    add_times(timed, routine, context_of(routine), entry);
    if (!source_of(timed, routine.exception).empty()) entry["raised_by"] = causes_json(timed, routine);
    for (const Cycles cycles : routine.requests)
      entry["requests"].push_back(ns_of(cycles + context_of(routine), timed));
    interrupts.push_back(std::move(entry));
  }
  return interrupts;
}

Json scheduler_json(const TimedRobot& timed) {
  Json scheduler = Json::array();
  for (const wcet::RoutineTime& routine : timed.times.routines) {
    const auto task = task_of(timed, routine.exception);
    if (!task) continue;
    Json entry{{"what", task->name}};
    add_times(timed, routine, task->period ? 0 : context_of(routine), entry);
    if (task->period) {
      entry["period_ns"] = task->period->ns();
      entry["behind_ns"] = ns_of(routine.gaps.rest, timed);
    }
    scheduler.push_back(std::move(entry));
    if (task->period) add_gaps(timed, routine.gaps, scheduler);
  }
  for (const auto& [by, word] : kRetries)
    scheduler.push_back({{"what", cost_words::kRetry},
                         {"after", word},
                         {"wcet_ns", ns_of(timed.times.retries[static_cast<std::size_t>(by)], timed)}});
  scheduler.push_back({{"what", cost_words::kMasked}, {"wcet_ns", ns_of(longest_masked(timed.times), timed)}});
  return scheduler;
}

}  // namespace finemote::gen
