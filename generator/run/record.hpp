// What a run of the firmware left behind: the stages in time order, and its counters.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "generator/forest/forest.hpp"
#include "generator/run/fault_table.hpp"

namespace finemote::gen {

/// One begin or end of a stage.
struct Event {
  Duration at;
  DeviceId device;
  bool is_handle = false;
  bool is_end = false;
};

/// The longest time that one run of a stage took by itself, without interrupts and what preempted it.
struct OwnTime {
  DeviceId device;
  bool is_handle = false;
  Duration longest;
};

struct BusRecord {
  BusId bus;
  std::uint64_t transfers = 0, errors = 0;
  double busy = 0;  ///< fraction of the run, 0..1
};

/// Something a part did, by which the ends of a chain are measured.
struct PartRecord {
  std::string part;        ///< named like its device or expander
  bool is_output = false;  ///< an output took a value; else a quantity was sampled
  std::uint32_t channel = 0;
  Duration from;  ///< when the quantity was sampled
  Duration at;    ///< when its last bit could be read, or the output took its value
};

/// What the monitor in the firmware kept of one device.
struct MonitorEntry {
  DeviceId device;
  Duration response_max;
  Duration age_max;  ///< zero: no valid command was handled
  std::uint64_t response_violations = 0, age_violations = 0;
};

/// A value of a part that had to stay between two limits, as the scenario says.
struct ExpectationRecord {
  std::string part, value;
  Duration from, to;  ///< since the first release
  double min = 0, max = 0;
  std::optional<double> lowest, highest;  ///< seen, of the finite values; none: no such value
  bool finite = true;                     ///< none was infinite or no number
  bool ok = false;
};

struct RunRecord {
  std::vector<Event> events;            ///< in time order
  std::vector<OwnTime> own_times;       ///< of stages that ran; emulated board only
  std::vector<std::uint64_t> overruns;  ///< per bucket
  std::vector<BusRecord> buses;
  std::vector<PartRecord> parts;                ///< in time order per part; emulated board only
  std::vector<MonitorEntry> monitor;            ///< in schedule order; empty without the monitor
  unsigned resets = 0;                          ///< by the watchdog or the firmware; emulated board only
  std::vector<ExpectationRecord> expectations;  ///< of the scenario; emulated board only
  std::string flash;                            ///< hit or miss: how the emulated board counted fetches
  bool faulty = false;                          ///< the scenario injects faults: bounds need not hold
  std::vector<std::string> silent;              ///< devices without a model on the emulated board
  std::vector<FaultCount> faults;               ///< in the order of their first times
  std::optional<Duration> instruction_time;     ///< every one takes that long: the run counts them instead of time
  std::optional<Duration> stopped_at;           ///< it went to its safe stop; host and qemu_f405 only
};

/// Reads the lines the firmware prints: `E <ns> <stage> B|E`, `O <bucket> <count>`, `B <bus> <transfers> <errors> <busy
/// ns>`, `F <module> <number> <count>`, `S <ns>`, `M <device> <worst response> <worst age> <late> <old>`; other lines
/// are ignored. None when a line is broken, a stage does not exist or a time is beyond 1000 days.
std::optional<RunRecord> parse_record(const std::string& text, const Forest& forest, Duration duration);

}  // namespace finemote::gen
