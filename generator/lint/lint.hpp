// A correct robot to warnings that save robots, and to the edits that mend the mechanical ones.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/lint/change.hpp"
#include "generator/model/robot.hpp"

namespace finemote::gen {

/// The oldest data behind a device's command, at the end of its handle().
struct CommandAge {
  std::int64_t ns = 0;
  std::size_t source = 0;  ///< whose sample: index into Robot::devices
};

struct LintOptions {
  std::vector<Code> allow;  ///< not reported
  std::vector<Code> deny;   ///< reported as errors
  double most_bus_load = 0.7;
  std::vector<double> bus_load;  ///< 0..1, per Robot::buses, from the timing analysis; empty: not known
  std::vector<std::optional<CommandAge>> command_ages;  ///< proven, per Robot::devices; empty: not known
  std::vector<Diagnostic> overloads;  ///< FM4021 of the timing analysis, instead of FM3155 for these buses
};

/// What mends one finding mechanically.
struct Fix {
  Code code;
  std::string message;  ///< of the finding
  std::string subject;  ///< name of the device that moves, or of the bus that goes
  Change change;        ///< without edits where the text does not allow it
};

/// Looks for what is allowed and yet rarely meant. Reports, in document order:
/// FM3151 a sensor declared after actuators of its period (they handle later than they could),
/// FM3152 a child's period that is neither multiple nor divisor of its parent's,
/// FM3153 a leaf without <wcet>, FM3154 a conversion longer than the device's period,
/// FM3155 a bus that is busy for more than `most_bus_load` (above 100 %: FM4021; who denies FM3155 denies these),
/// FM3156 a bus nobody uses, FM3157 a param that is computed from the URDF, FM3158 to FM3160 what mechanics.hpp finds,
/// FM3161 a limit on the age of commands below the proven age, FM3208 what hardware.hpp finds. codes.hpp has the table.
/// @return  one for each FM3151 and FM3156 that is reported
std::vector<Fix> lint(const Robot& robot, const LintOptions& options, Diagnostics& diagnostics);

}  // namespace finemote::gen
