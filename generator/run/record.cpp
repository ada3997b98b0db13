#include "generator/run/record.hpp"

#include <sstream>

#include "generator/forest/stage.hpp"

namespace finemote::gen {
namespace {

/// Later than any run gets.
constexpr Duration kLatest = 1000 * seconds(86'400);

/// The next word, which counts nanoseconds; `words` fails where it does not, or lies beyond kLatest.
Duration read_time(std::istringstream& words) {
  std::int64_t ns = 0;
  words >> ns;
  if (nanoseconds(ns) > kLatest || nanoseconds(ns) < -kLatest) words.setstate(std::ios::failbit);
  return nanoseconds(ns);
}

bool read_event(std::istringstream& words, const Forest& forest, RunRecord& record) {
  const Duration at = read_time(words);
  std::size_t number = 0;
  char edge = 0;
  if (!(words >> number >> edge) || (edge != 'B' && edge != 'E')) return false;
  const Stage stage = Stage::of_number(number);
  if (!forest.order.contains(stage.rank)) return false;
  record.events.push_back({at, forest.order[stage.rank], stage.is_handle, edge == 'E'});
  return true;
}

bool read_overruns(std::istringstream& words, RunRecord& record) {
  std::size_t bucket = 0;
  std::uint64_t count = 0;
  if (!(words >> bucket >> count) || bucket > 1000) return false;
  if (record.overruns.size() <= bucket) record.overruns.resize(bucket + 1);
  record.overruns[bucket] = count;
  return true;
}

bool read_bus(std::istringstream& words, Duration duration, RunRecord& record) {
  BusRecord bus;
  std::size_t index = 0;
  double busy_ns = 0;
  if (!(words >> index >> bus.transfers >> bus.errors)) return false;
  bus.bus = BusId{index};
  if (words >> busy_ns && duration > Duration::zero()) bus.busy = busy_ns / static_cast<double>(duration.ns());
  record.buses.push_back(bus);
  return true;
}

bool read_fault(std::istringstream& words, RunRecord& record) {
  FaultCount fault;
  if (!(words >> fault.module >> fault.number >> fault.count)) return false;
  record.faults.push_back(fault);
  return true;
}

bool read_stop(std::istringstream& words, RunRecord& record) {
  const Duration at = read_time(words);
  if (!words) return false;
  record.stopped_at = at;
  return true;
}

bool read_monitor(std::istringstream& words, const Forest& forest, RunRecord& record) {
  MonitorEntry entry;
  std::size_t place = 0;
  words >> place;
  entry.response_max = read_time(words);
  entry.age_max = read_time(words);
  words >> entry.response_violations >> entry.age_violations;
  if (!words || !forest.order.contains(Rank{place})) return false;
  entry.device = forest.order[Rank{place}];
  record.monitor.push_back(entry);
  return true;
}

}  // namespace

namespace {

void add(std::vector<OwnTime>& all, const OwnTime& more) {
  for (OwnTime& own : all) {
    if (own.device != more.device || own.is_handle != more.is_handle) continue;
    own.longest = std::max(own.longest, more.longest);
    return;
  }
  all.push_back(more);
}

void add(std::vector<FaultCount>& all, const FaultCount& more) {
  for (FaultCount& fault : all) {
    if (fault.module != more.module || fault.number != more.number) continue;
    fault.count += more.count;
    return;
  }
  all.push_back(more);
}

void add(MonitorEntry& all, const MonitorEntry& more) {
  all.response_max = std::max(all.response_max, more.response_max);
  all.age_max = std::max(all.age_max, more.age_max);
  all.response_violations += more.response_violations;
  all.age_violations += more.age_violations;
}

}  // namespace

void merge(RunRecord& all, const RunRecord& more) {
  for (const OwnTime& own : more.own_times) add(all.own_times, own);
  for (std::size_t i = 0; i < all.loop_passes.size() && i < more.loop_passes.size(); ++i)
    all.loop_passes[i] = std::max(all.loop_passes[i], more.loop_passes[i]);
  for (const FaultCount& fault : more.faults) add(all.faults, fault);
  for (const FaultCount& fault : more.late_faults) add(all.late_faults, fault);
  for (std::size_t i = 0; i < all.overruns.size() && i < more.overruns.size(); ++i) all.overruns[i] += more.overruns[i];
  for (std::size_t i = 0; i < all.monitor.size() && i < more.monitor.size(); ++i) add(all.monitor[i], more.monitor[i]);
  for (std::size_t i = 0; i < all.expectations.size() && i < more.expectations.size(); ++i) {
    if (all.expectations[i].ok && !more.expectations[i].ok) all.expectations[i] = more.expectations[i];
  }
  all.resets += more.resets;
}

std::optional<RunRecord> parse_record(const std::string& text, const Forest& forest, Duration duration) {
  RunRecord record;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.size() < 2 || line[1] != ' ') continue;
    std::istringstream words(line.substr(2));
    bool good = true;
    switch (line[0]) {
      case 'E':
        good = read_event(words, forest, record);
        break;
      case 'O':
        good = read_overruns(words, record);
        break;
      case 'B':
        good = read_bus(words, duration, record);
        break;
      case 'F':
        good = read_fault(words, record);
        break;
      case 'S':
        good = read_stop(words, record);
        break;
      case 'M':
        good = read_monitor(words, forest, record);
        break;
      default:
        break;
    }
    if (!good) return std::nullopt;
  }
  return record;
}

}  // namespace finemote::gen
