// The generator on one page: what becomes of the description of a robot.
//
//   parse -> expand -> model -> forest -> schedule -> analyse -> emit
//
// Every stage takes finished values, returns a new one and knows only the types before it. What the files are written
// to, compared with or shown as is the business of commands (generator/cli).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/descriptor/library.hpp"
#include "generator/diagnostic/diagnostics.hpp"
#include "generator/emit/command_frame.hpp"
#include "generator/emit/render.hpp"
#include "generator/input/input.hpp"
#include "generator/timing/analyse.hpp"
#include "generator/timing_file/inputs_hash.hpp"
#include "generator/timing_file/use.hpp"

namespace finemote::gen {

/// A robot with all that is planned of it. `robot` points into `library`.
struct PlannedRobot {
  Library library;
  Robot robot;
  Forest forest;
  Schedule schedule;
  TimingFileUse timing_file = {};
  std::string board = {};  ///< asked for, where it is another than the robot names; empty: the robot's own

  [[nodiscard]] Plan plan() const { return {robot, forest, schedule}; }
};

/// Parse, expand, model, forest, schedule, and the bounds of the robot's timing file. All mistakes are reported; with
/// one there is no robot.
std::optional<PlannedRobot> plan_robot(const Input& input, Sources& sources, Diagnostics& diagnostics);

/// What a computer sends down to every link: for those who play the computer.
CommandFrames command_frames(const PlannedRobot& planned, const std::string& data_dir);

/// What the instructions of the robot's image are made from, its generated files without bounds included:
/// timing_state().
TimingState timing_state_of(const PlannedRobot& planned, const std::string& data_dir, const files::Access& access);

/// What is proven of a robot, in its own profile `target`.
struct Analysis {
  std::optional<timing::Timing> timing;  ///< with `inputs`; none: no answer, and the findings say why
  Diagnostics findings;                  ///< what timing::analyse reports, apart from mistakes in the input
};

/// Whether findings come with changes that would help: finding them analyses variants of a robot that cannot meet its
/// deadlines or requirements.
enum class Hints { wanted, left_out };

/// Analyse: once for a command, which hands the result to whatever asks for it.
Analysis analyse_robot(const PlannedRobot& planned, Hints hints);

/// What the firmware can be held to: as it is written, and with monitor and trace built in (a variant, analysed here).
ProvenBounds prove_bounds(const PlannedRobot& planned, const Analysis& analysis);

/// Emit: the generated files, bounds included. Reports what render_files reports.
std::vector<OutputFile> emit_files(const PlannedRobot& planned, const ProvenBounds& bounds, const std::string& data_dir,
                                   Diagnostics& diagnostics);

}  // namespace finemote::gen
