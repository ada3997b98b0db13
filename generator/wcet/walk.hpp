// Follows a routine of an image in all ways it can take, with what is known of registers and memory on each.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "generator/image/program.hpp"
#include "generator/wcet/block_cost.hpp"
#include "generator/wcet/constants.hpp"
#include "generator/wcet/execute.hpp"
#include "generator/wcet/marks.hpp"
#include "generator/wcet/unrolled.hpp"

namespace finemote::gen::wcet {

/// An instruction that calls, or jumps to, another function.
struct CallSite {
  std::uint32_t address = 0;
  const ProgramFunction* function = nullptr;  ///< the caller
};

/// Why a routine has no bound.
struct WalkProblem {
  std::uint32_t address = 0;
  const ProgramFunction* function = nullptr;
  std::string why;
  std::vector<CallSite> calls = {};  ///< that led there the first time, innermost first
};

/// A loop that ended, in whatever context it ran longest.
struct CountedLoop {
  const ProgramFunction* function = nullptr;
  std::uint32_t header = 0;
  std::uint64_t rounds = 0;  ///< jumps back to the header, at most
  bool is_by_mark = false;   ///< a mark ended it
};

/// One more iteration of a loop that an interrupt has disturbed.
struct Retry {
  RetriedBy by = RetriedBy::release;
  std::size_t begin = 0;           ///< node of the mark in the iteration before
  std::vector<UnrolledEdge> back;  ///< ways from there to the mark again
};

/// Iterations of a loop that counts a register down, which are alike.
struct Countdown {
  std::uint64_t rounds = 0;
  Cycles cost = 0;  ///< of each, at most
};

struct Walked {
  UnrolledGraph graph;
  std::set<std::size_t> waits;                  ///< nodes that stand for all iterations of a wait but the last two
  std::map<std::size_t, Countdown> countdowns;  ///< by the node that stands for all iterations but the last
  std::vector<Retry> retries;
  std::map<std::uint32_t, CountedLoop> loops;     ///< by header
  std::map<std::uint32_t, WalkProblem> problems;  ///< by address; empty: the graph holds every way there is
};

/// What is known of an image for all its routines; all of it outlives the walk.
struct WalkContext {
  const Program& program;  ///< whose blocks end at the marks
  const Constants& constants;
  const Marks& marks;
  CodeCost cost;
  WordStores* stores = nullptr;  ///< as in Surroundings
  std::uint32_t stack_top = 0;   ///< where the stack is when the routine begins: any place does
};

/// From a routine's entry to its ends. Registers hold anything at first.
Walked walk(const WalkContext& context, std::uint32_t entry);

}  // namespace finemote::gen::wcet
