// The bounds of a timing file to the execution times of its robot.
#pragma once

#include <string>
#include <vector>

#include "generator/model/robot.hpp"
#include "generator/timing_file/timing_file.hpp"

namespace finemote::gen {

/// What a robot is made of now, to be held against what a timing file was computed from.
struct TimingQuestion {
  std::string robot;                   ///< its file, for messages
  std::vector<std::string> arguments;  ///< `name:=value`, sorted
  std::string board;                   ///< that is asked for instead of the robot's own; empty: none
  std::string hash;                    ///< timing_state()
};

/// What became of the timing file of a robot.
struct TimingFileUse {
  enum class State {
    none,   ///< there is none
    fits,   ///< its bounds are the robot's
    stale,  ///< it was computed from something else: its figures are assumed
    other,  ///< of other arguments or another board: not used
  };
  State state = State::none;
  Position at = {};           ///< its first byte
  std::string path = {};      ///< empty: there is none
  std::string compiler = {};  ///< that made the image of the bounds; empty: not recorded
};

/// Gives the devices the times of the file. A bound counts in place of what is assumed or measured, and of what is
/// declared where it is above that. Reports FM4022 where the file is stale, FM4023 where it is of other arguments.
TimingFileUse::State use_timing_file(const TimingFile& file, const TimingQuestion& question, Robot& robot,
                                     Diagnostics& diagnostics);

}  // namespace finemote::gen
