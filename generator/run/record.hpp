// What a run of the firmware left behind: the stages in time order, and its counters.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "generator/forest/forest.hpp"

namespace finemote::gen {

/// One begin or end of a stage.
struct Event {
  std::int64_t t_ns = 0;
  std::size_t device = 0;  ///< index into Robot::devices
  bool is_handle = false;
  bool is_end = false;
};

struct BusRecord {
  std::size_t bus = 0;  ///< index into Robot::buses
  std::uint64_t transfers = 0, errors = 0;
  double busy = 0;  ///< fraction of the run, 0..1
};

struct RunRecord {
  std::vector<Event> events;            ///< in time order
  std::vector<std::uint64_t> overruns;  ///< per bucket
  std::vector<BusRecord> buses;
  std::vector<std::string> faults;      ///< `module 3, number 2, 5 times`
};

/// Reads the lines the firmware prints: `E <ns> <stage> B|E`, `O <bucket> <count>`, `B <bus> <transfers> <errors> <busy ns>`,
/// `F <module> <number> <count>`; other lines are ignored. None when a line is broken or a stage does not exist.
std::optional<RunRecord> parse_record(const std::string& text, const Forest& forest, std::int64_t duration_ns);

}  // namespace finemote::gen
