// `<base>.timing.json` beside a robot: bounds of its execution times, and what they were computed from.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/units/duration.hpp"

namespace finemote::gen {

inline constexpr const char* kTimingSchema = "finemote.wcet/1";

/// Whose longest times the instructions of an image are charged with: docs/wcet.md. Figures of another model are no
/// figures of this one.
struct CostModel {
  std::string name;
  std::int64_t version = 0;

  friend bool operator==(const CostModel&, const CostModel&) = default;
};

/// The one that this program computes with.
CostModel cost_model();

/// Bounds of the stages of a device; none: there was none, or it is not in the file.
struct StageBounds {
  std::optional<Duration> update, handle;
};

/// Of the routine of an interrupt line.
struct LineBounds {
  std::string source;                         ///< `i2c.I2C2_EV` of a bus, else a name
  Duration longest;                           ///< whatever raises it
  std::map<std::string, Duration> raised_by;  ///< cost_words
  std::vector<Duration> requests = {};        ///< that hand over one frame, two, ...; empty: not told apart
};

/// Of what runs around the stages; none: it is not in the file.
struct SchedulerBounds {
  std::optional<Duration> release, masked;
  std::map<std::string, StageBounds> before;  ///< by device
  std::map<Duration, Duration> behind;        ///< by period
  std::map<std::string, Duration> retries;    ///< cost_words
};

struct TimingFile {
  Position at;  ///< its first byte
  std::map<std::string, StageBounds> devices;
  std::vector<LineBounds> lines;
  SchedulerBounds scheduler;
  bool is_complete = false;            ///< everything in the image has a bound
  std::vector<std::string> arguments;  ///< `name:=value`, sorted
  std::string board;                   ///< that was asked for instead of the robot's own; empty: none
  std::string compiler, hash;          ///< empty: not recorded
  CostModel model;
};

/// Where the timing file of a robot is looked for; empty: standard input and timing models have none.
std::string timing_file_path(const std::string& robot);

/// Reads a file that is there. Reports what xml::read_source, json::parse and the reader of timing models report, and
/// FM4026.
std::optional<TimingFile> read_timing_file(const std::string& path, Sources& sources, Diagnostics& diagnostics);

}  // namespace finemote::gen
