// What a run of the firmware left behind: the stages in time order, and its counters.
#pragma once

#include <cmath>
#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/forest/forest.hpp"
#include "generator/run/fault_table.hpp"
#include "generator/run/silicon.hpp"

namespace finemote::gen {

inline constexpr std::int64_t kPsPerNs = 1'000;
constexpr Duration picoseconds_down(std::int64_t count) { return nanoseconds(floor_div(count, kPsPerNs)); }
constexpr Duration picoseconds_up(std::int64_t count) { return nanoseconds(ceil_div(count, kPsPerNs)); }

/// The start or the end of a stage.
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

/// The longest time that one run of an interrupt routine took by itself, from the start of stacking to the end of
/// unstacking.
struct RoutineTime {
  std::uint32_t exception = 0;
  Duration longest;
  std::int64_t runs = 0;  ///< in `traffic_window`
};

/// What a bus did from the end of the bring-up on.
struct BusTraffic {
  Duration window;                                     ///< how long it was looked at
  Duration sent, received;                             ///< how long its lines were in use; a bus with one line: `sent`
  std::int64_t interrupts = 0;                         ///< runs of its service routines
  std::map<std::uint32_t, std::int64_t> longest = {};  ///< i2c: data bytes of the longest transfer, by address
};

struct BusRecord {
  BusId bus;
  std::uint64_t transfers = 0, errors = 0;
  double busy = 0;                                   ///< fraction of the run, 0..1
  std::optional<BusTraffic> traffic = std::nullopt;  ///< emulated board only
};

/// Something a part did, by which the ends of a chain are measured.
struct PartRecord {
  std::string part;        ///< named like its device or expander
  bool is_output = false;  ///< an output took a value; else a quantity was sampled
  std::uint32_t channel = 0;
  std::int64_t from_ps = 0;            ///< when the quantity was sampled
  std::int64_t at_ps = 0;              ///< when its last bit could be read, or the output took its value
  std::uint32_t n = 0;                 ///< which sample of the channel, or which run of the handle, from 0
  std::optional<std::uint32_t> stage;  ///< the handle whose command an output carries; none: unknown
  double value = 0;                    ///< of an output, in its unit
  bool is_repeated = false;            ///< the value was shown before: this or an older command may have sent it

  [[nodiscard]] Duration from() const { return picoseconds_down(from_ps); }
  [[nodiscard]] Duration at() const { return picoseconds_down(at_ps); }
};

/// A run of a handle.
struct JobRun {
  std::uint32_t stage = 0;
  std::uint32_t n = 0;  ///< since power-on, from 0

  friend auto operator<=>(const JobRun&, const JobRun&) = default;
};

/// What the state of a device was made of when an update ended.
struct SampleUse {
  std::int64_t at_ps = 0;
  std::uint32_t stage = 0;  ///< the update: twice the rank of its device
  std::string part;         ///< whose sample,
  std::uint32_t channel = 0;
  std::uint32_t n = 0;                     ///< and which one
  std::optional<std::int64_t> claimed_ps;  ///< when the state's data were taken, as it says; none: it does not say
};

/// One event of the processor, as emulator/program/audit.hpp tells it.
struct LoggedEvent {
  std::int64_t ps = 0;
  std::string what;
  std::uint32_t number = 0;
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

/// A quantity of a part at even times, the first at `from` since the first release.
struct ValueSeries {
  std::string part, value, unit;
  Duration from, every;
  std::vector<std::optional<double>> values = {};  ///< none: no finite number
};

/// An assumption of the bounds that a scenario violates: docs/timing.md, "Assumptions".
struct Violation {
  std::string assumption;    ///< its id
  std::optional<BusId> bus;  ///< where it does not hold; none: anywhere
};

struct RunRecord {
  Duration ready;                          ///< end of bring-up, since the first release: bounds hold from then on
  std::vector<std::string> absent;         ///< parts that never came up
  Duration judged_for;                     ///< from then on: as long as was asked for, or as the scenario lasts
  double clock_ppm = 0;                    ///< how much too fast the board's clock ran, which counts all times here
  std::vector<Event> events;               ///< in time order
  std::vector<OwnTime> own_times;          ///< of stages that ran; emulated board only
  Duration traffic_window;                 ///< how long buses and routines were looked at; emulated board only
  std::vector<RoutineTime> routine_times;  ///< of routines that ran; emulated board only
  std::vector<std::uint64_t> loop_passes;  ///< most of each loop that is watched; emulated board only
  std::vector<std::uint64_t> overruns;     ///< per bucket
  std::vector<BusRecord> buses;
  std::vector<PartRecord> parts;                ///< in time order per part; emulated board only
  std::vector<SampleUse> uses;                  ///< in time order; emulated board only
  std::vector<JobRun> handed_over;              ///< gave a driver something to send; emulated board only
  std::vector<LoggedEvent> log;                 ///< in time order; where it was asked for
  std::vector<MonitorEntry> monitor;            ///< in schedule order; empty without the monitor
  unsigned resets = 0;                          ///< by the watchdog or the firmware; emulated board only
  unsigned scripted_resets = 0;                 ///< by the scenario
  std::vector<ExpectationRecord> expectations;  ///< of the scenario; emulated board only
  std::vector<ValueSeries> series;              ///< emulated board only
  std::string flash;                            ///< hit or miss: how the emulated board counted fetches
  SiliconChoice silicon;                        ///< which freedom of its manual the emulated chip used
  std::vector<Violation> violated;              ///< by the scenario: bounds that rest on them need not hold
  std::optional<Duration> violated_from;        ///< before that all have to; none: they have to for ever
  std::vector<std::string> text_ports;  ///< where a scenario sent text, of any length: their lines may bring anything
  std::vector<std::string> silent;      ///< devices without a model on the emulated board
  std::vector<FaultCount> faults;       ///< in the order of their first times
  std::vector<FaultCount> late_faults;  ///< of these, counted after the bring-up and before `violated_from`
  std::uint64_t late_violations = 0;    ///< counted by the monitor before `violated_from`
  std::vector<Diagnostic> stopped;      ///< why the firmware stopped after its first release: FM6002; empty: it did not
  bool is_traffic_judged = true;        ///< it was counted while no assumption was violated
  std::optional<Duration> instruction_time;  ///< every one takes that long: the run counts them instead of time
  std::optional<Duration> stopped_at;        ///< it went to its safe stop; host and qemu_f405 only

  /// A time span as the world outside of the board sees it, to the nearest nanosecond.
  [[nodiscard]] Duration true_time(Duration span) const {
    if (clock_ppm == 0) return span;
    return nanoseconds(std::llround(static_cast<double>(span.ns()) / (1 + clock_ppm * 1e-6)));
  }
};

/// Adds what another run of the same image left behind to counters, longest times and parts that never came up; stages,
/// parts and the time of the bring-up stay those of the first.
void merge(RunRecord& all, const RunRecord& more);

}  // namespace finemote::gen
