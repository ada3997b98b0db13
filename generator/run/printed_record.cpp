#include "generator/run/printed_record.hpp"

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

bool read_bus(std::istringstream& words, std::size_t buses, Duration duration, RunRecord& record) {
  BusRecord bus;
  std::size_t index = 0;
  double busy_ns = 0;
  if (!(words >> index >> bus.transfers >> bus.errors) || index >= buses) return false;
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

std::optional<RunRecord> parse_record(const std::string& text, const Forest& forest, std::size_t buses,
                                      Duration duration) {
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
        good = read_bus(words, buses, duration, record);
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
