// A linked image to bounds of the execution times of all its routines.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "generator/image/constants.hpp"
#include "generator/image/image.hpp"
#include "generator/wcet/causes.hpp"
#include "generator/wcet/gaps.hpp"
#include "generator/wcet/memory_map.hpp"
#include "generator/wcet/retries.hpp"

namespace finemote::gen::wcet {

/// A piece of a longest path.
struct PathStep {
  std::uint32_t address = 0;  ///< of the code
  std::string function;
  Cycles cycles = 0;  ///< of its instructions and of the way to the next piece
};

/// A loop and how often it jumps back to its header.
struct LoopTime {
  std::uint32_t address = 0;
  std::string function;
  std::uint64_t rounds = 0;  ///< at most, from when it is entered to when it is left
  bool is_by_mark = false;   ///< the source says so: `LoopBound<n>`; else it follows from the code
};

/// From one mark to the next: runtime/include/finemote/mark.hpp.
struct BracketTime {
  std::uint32_t mark = 0;  ///< at its start
  Cycles cycles = 0;
  std::optional<Cycles> without_faults;  ///< on ways that no fault leads to; none: there is no such way
  std::vector<PathStep> path;
  std::vector<PathStep> path_without_faults;  ///< as long as `without_faults` says
  std::vector<LoopTime> loops;                ///< that it may run through
};

struct RoutineTime {
  unsigned exception = 0;
  std::string name;
  Cycles cycles = 0;                     ///< from its first instruction to its last, brackets included
  std::optional<Cycles> without_faults;  ///< as of a bracket
  std::vector<PathStep> path, path_without_faults;
  std::vector<BracketTime> brackets;
  CauseTimes by_cause;           ///< without faults: of a routine of buses
  std::vector<Cycles> requests;  ///< of them: those that hand over one frame, two, ...; empty: not told apart
  Gaps gaps;                     ///< without faults: of a job
  bool uses_fpu = false;
};

/// A place in the code.
struct CodePlace {
  std::uint32_t address = 0;
  std::string function;
};

/// Why some routine has no bound.
struct TimeGap {
  std::uint32_t address = 0;
  std::string function;
  std::string why;
  std::vector<CodePlace> calls = {};  ///< that lead there, innermost first; others may, too
};

/// It is where the innermost call is. There is one.
void move_to_caller(TimeGap& gap);

/// Routines with a gap have no entry.
struct ImageTimes {
  std::vector<RoutineTime> routines;  ///< by exception
  std::vector<TimeGap> gaps;          ///< by address
  RetryTimes retries{};
};

/// Where its code runs.
Placement placement_of(const Image& image);

/// Of the release and of every interrupt line with a routine. The bounds hold under the assumptions of docs/wcet.md.
ImageTimes time_image(const Image& image, const KeptMembers& kept, Placement placement);

}  // namespace finemote::gen::wcet
