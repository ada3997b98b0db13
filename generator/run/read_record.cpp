#include "generator/run/read_record.hpp"

#include <algorithm>

#include "generator/forest/stage.hpp"
#include "generator/image/exception.hpp"
#include "generator/run/repeated_outputs.hpp"
#include "generator/run/violation.hpp"

namespace finemote::gen {
namespace {

using Json = nlohmann::ordered_json;

std::vector<FaultCount> faults_of(const Json& record, const char* when) {
  std::vector<FaultCount> faults;
  for (const Json& fault : record.at(when)) faults.push_back({fault.at(0), fault.at(1), fault.at(2)});
  return faults;
}

/// What was counted until the scenario violated an assumption, or by the end; null: it did so during the bring-up.
const Json& undisturbed_in(const Json& record) {
  return record.at("violated_from_ns").is_null() ? record : record.at("undisturbed");
}

/// What came after the bring-up, while every assumption held. Counters stay at their largest value, and begin anew with
/// a reset.
std::vector<FaultCount> late_faults_of(const Json& record) {
  const Json& undisturbed = undisturbed_in(record);
  if (undisturbed.is_null()) return {};
  std::vector<FaultCount> late = faults_of(undisturbed, "fault_counts");
  for (const FaultCount& early : faults_of(record, "faults_at_ready")) {
    for (FaultCount& fault : late) {
      if (fault.module == early.module && fault.number == early.number)
        fault.count = fault.count > early.count ? fault.count - early.count : 0;
    }
  }
  std::erase_if(late, [](const FaultCount& fault) { return fault.count == 0; });
  return late;
}

/// By the monitor, while every assumption held.
std::uint64_t late_violations_of(const Json& record) {
  const Json& undisturbed = undisturbed_in(record);
  std::uint64_t count = 0;
  if (undisturbed.is_null()) return count;
  for (const Json& entry : undisturbed.at("monitor"))
    count += entry.at(2).get<std::uint64_t>() + entry.at(3).get<std::uint64_t>();
  return count;
}

/// While every assumption held; all of it where that ended with the bring-up.
const Json& traffic_in(const Json& record) {
  const Json& undisturbed = undisturbed_in(record);
  return (undisturbed.is_null() ? record : undisturbed).at("traffic");
}

std::vector<Event> events_of(const Json& record, const Forest& forest) {
  std::vector<Event> events;
  for (const Json& event : record.at("stages")) {
    const Stage stage = Stage::of_number(event.at(1));
    if (!forest.order.contains(stage.rank)) continue;
    events.push_back({time_of(event.at(0)), forest.order[stage.rank], stage.is_handle, !event.at(2).get<bool>()});
  }
  return events;
}

/// Rounded up.
std::vector<OwnTime> own_times_of(const Json& record, const Forest& forest) {
  std::vector<OwnTime> times;
  for (const Json& own : record.at("own_stages")) {
    const Stage stage = Stage::of_number(own.at(0));
    if (!forest.order.contains(stage.rank)) continue;
    times.push_back({forest.order[stage.rank], stage.is_handle, picoseconds_up(own.at(1))});
  }
  return times;
}

/// Rounded up.
std::vector<RoutineTime> routine_times_of(const Json& record) {
  std::vector<RoutineTime> times;
  for (const Json& own : record.at("own_exceptions")) {
    RoutineTime& routine = times.emplace_back();
    routine = {own.at(0), picoseconds_up(own.at(1))};
    for (const Json& counted : traffic_in(record).at("exceptions")) {
      if (counted.at(0) == routine.exception) routine.runs = counted.at(1);
    }
  }
  return times;
}

std::vector<ExpectationRecord> expectations_of(const Json& record) {
  const auto seen = [](const Json& value) { return value.is_null() ? std::nullopt : std::optional<double>(value); };
  std::vector<ExpectationRecord> all;
  for (const Json& e : record.at("expectations")) {
    all.push_back({e.at("part"), e.at("value"), time_of(e.at("from_ns")), time_of(e.at("to_ns")), e.at("min"),
                   e.at("max"), seen(e.at("lowest")), seen(e.at("highest")), e.at("finite"), e.at("ok")});
  }
  return all;
}

std::vector<ValueSeries> series_of(const Json& record) {
  std::vector<ValueSeries> all;
  for (const Json& s : record.at("series")) {
    ValueSeries& series = all.emplace_back();
    series = {s.at("part"), s.at("value"), s.at("unit"), time_of(s.at("from_ns")), time_of(s.at("every_ns"))};
    for (const Json& value : s.at("values"))
      series.values.push_back(value.is_null() ? std::nullopt : std::optional(value.get<double>()));
  }
  return all;
}

std::optional<std::int64_t> maybe(const Json& ps) {
  return ps.is_null() ? std::nullopt : std::optional(ps.get<std::int64_t>());
}

std::vector<PartRecord> parts_of(const Json& record) {
  std::vector<PartRecord> parts;
  for (const Json& part : record.at("parts")) {
    const Json& stage = part.at("stage");
    parts.push_back({part.at("part"), part.at("output"), part.at("channel"), part.at("from_ps"), part.at("at_ps"),
                     part.at("n"), stage.is_null() ? std::nullopt : std::optional(stage.get<std::uint32_t>()),
                     part.at("value")});
  }
  return parts;
}

/// Three numbers for each event: emulator/program/audit.hpp. None where no audit was asked for.
std::vector<LoggedEvent> log_of(const Json& audit) {
  std::vector<LoggedEvent> log;
  if (audit.is_null()) return log;
  const auto names = audit.at("names").get<std::vector<std::string>>();
  const Json& numbers = audit.at("events");
  log.reserve(numbers.size() / 3);
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3)
    log.push_back({numbers[i], names.at(numbers[i + 1].get<std::size_t>()), numbers[i + 2]});
  return log;
}

/// How often the service routines of a port ran.
std::int64_t runs_of(const Json& exceptions, const Port& port) {
  std::int64_t runs = 0;
  for (const Json& exception : exceptions) {
    const auto is_own = [&](const InterruptLine& line) { return exception.at(0) == exception_of(line.number); };
    if (std::any_of(port.interrupts.begin(), port.interrupts.end(), is_own))
      runs += exception.at(1).get<std::int64_t>();
  }
  return runs;
}

/// Of the bus that has a port, and comes in this place of those.
BusTraffic traffic_of(const Json& record, std::size_t place, const Port* port) {
  const Json& traffic = traffic_in(record);
  const Json& lines = traffic.at("ports").at(place);
  BusTraffic result{time_of(traffic.at("ns")), time_of(lines.at(0)), time_of(lines.at(1)),
                    port != nullptr ? runs_of(traffic.at("exceptions"), *port) : 0};
  for (const Json& transfer : lines.at(2)) {
    std::int64_t& longest = result.longest[transfer.at(0).get<std::uint32_t>()];
    longest = std::max(longest, transfer.at(1).get<std::int64_t>());
  }
  return result;
}

/// Of the buses with a port, in their order.
std::vector<BusRecord> buses_of(const Json& record, const Robot& robot) {
  std::vector<BusRecord> buses;
  for (const BusId id : robot.buses.ids()) {
    if (robot.buses[id].port.empty()) continue;
    const Json& bus = record.at("buses").at(buses.size());
    const Port* port = robot.board != nullptr ? robot.board->port(robot.buses[id].port) : nullptr;
    buses.push_back(
        {id, bus.at("transfers"), bus.at("errors"), bus.at("busy"), traffic_of(record, buses.size(), port)});
  }
  return buses;
}

std::vector<MonitorEntry> monitor_of(const Json& record, const Forest& forest) {
  std::vector<MonitorEntry> entries;
  for (const Rank rank : forest.order.ids()) {
    if (rank.value() >= record.at("monitor").size()) break;
    const Json& entry = record.at("monitor").at(rank.value());
    entries.push_back({forest.order[rank], time_of(entry.at(0)), time_of(entry.at(1)), entry.at(2), entry.at(3)});
  }
  return entries;
}

}  // namespace

std::vector<FaultCount> faults_of(const Json& document) { return faults_of(document, "fault_counts"); }

std::vector<FaultCount> undisturbed_faults_of(const Json& document) {
  const Json& undisturbed = undisturbed_in(document);
  return undisturbed.is_null() ? std::vector<FaultCount>{} : faults_of(undisturbed);
}

Duration time_of(const Json& ns) { return nanoseconds(ns.get<std::int64_t>()); }

RunRecord read_record(const Json& json, const Robot& robot, const Forest& forest) {
  RunRecord record;
  record.ready = time_of(json.at("ready_ns"));
  record.absent = json.at("absent").get<std::vector<std::string>>();
  record.events = events_of(json, forest);
  record.own_times = own_times_of(json, forest);
  record.traffic_window = time_of(traffic_in(json).at("ns"));
  record.routine_times = routine_times_of(json);
  record.loop_passes = json.at("loop_passes").get<std::vector<std::uint64_t>>();
  record.overruns = json.at("overruns").get<std::vector<std::uint64_t>>();
  record.faults = faults_of(json, "fault_counts");
  record.late_faults = late_faults_of(json);
  record.late_violations = late_violations_of(json);
  record.is_traffic_judged = !undisturbed_in(json).is_null();
  record.parts = parts_of(json);
  note_repeated(robot, record.parts);
  for (const Json& use : json.at("uses"))
    record.uses.push_back({use.at(0), use.at(1), use.at(2), use.at(3), use.at(4), maybe(use.at(5))});
  for (const Json& run : json.at("handed_over")) record.handed_over.push_back({run.at(0), run.at(1)});
  record.log = log_of(json.at("audit"));
  record.expectations = expectations_of(json);
  record.series = series_of(json);
  record.buses = buses_of(json, robot);
  record.monitor = monitor_of(json, forest);
  record.resets = json.at("resets");
  record.scripted_resets = json.at("scripted_resets");
  if (const Json& from = json.at("violated_from_ns"); !from.is_null()) record.violated_from = time_of(from);
  for (const Json& violation : json.at("violated"))
    record.violated.push_back(
        violation_of(violation.at("assumption"), violation.at("part"), violation.at("port"), robot));
  return record;
}

}  // namespace finemote::gen
