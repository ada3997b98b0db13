// Whether an exclusive store may fail, and what follows then.
#pragma once

#include <map>
#include <set>

#include "generator/wcet/frame.hpp"
#include "generator/wcet/step.hpp"

namespace finemote::gen::wcet {

/// Those of a program: where a failed one begins its loop anew, that iteration is part of what a preemption costs.
class ExclusiveStores {
 public:
  /// Runs a block. An exclusive store in it succeeds where to fail would only begin its loop anew, and nothing depends
  /// on how often it was tried. Else it may fail.
  Step step(const Frame& frame, const BasicBlock& block, Surroundings surroundings, const CodeCost& cost,
            Machine machine);

  /// With what an iteration of a loop begins at its header: an earlier one that failed may have left other values
  /// there.
  const Machine& begin_turn(Frame& frame, std::size_t loop);

 private:
  enum class Kind { none, retried, other };
  struct Known {
    std::map<std::uint32_t, Kind> kinds;             // of blocks
    std::map<std::uint32_t, std::set<int>> carried;  // by header: registers of retried iterations
  };
  const Known& of(const Frame& frame);

  std::map<const ProgramFunction*, Known> known_;
};

}  // namespace finemote::gen::wcet
