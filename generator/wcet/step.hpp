// A basic block on a machine: what it costs, and what holds on its outgoing edges.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/image/program.hpp"
#include "generator/wcet/block_cost.hpp"
#include "generator/wcet/execute.hpp"
#include "generator/wcet/machine.hpp"

namespace finemote::gen::wcet {

/// Of a problem behind which the block goes on all the same.
inline constexpr const char* kStoreToConstant =
    "a store to what is const (a mutable member, or an object that is made anew)";

/// What a return puts into the program counter.
struct Return {
  Interval to = Interval::any();
  bool is_made = false;  ///< no call has put it there
};

/// A way out of a block.
struct Way {
  enum class Kind { edge, call, leave } kind = Kind::edge;
  std::uint32_t to = 0;  ///< of an edge: the block; of a call: the function
  Machine machine;
  Cycles cost = 0;  ///< of the way itself; of a call: to the function; of a return: none, its place is not known here
  bool is_tail = false;      ///< of a call: its return is that of this function
  std::uint32_t behind = 0;  ///< of a call that is no tail: the block that goes on
  Return back = {};          ///< of a return, and of the end of a call that is a tail
};

struct Step {
  Cycles cost = 0;
  std::vector<Way> ways;  ///< only those that the machine allows
  /// Place and reason where there is no bound. The ways that are there all the same may lead to further places.
  std::optional<std::pair<std::uint32_t, std::string>> problem;
};

/// Runs `block` of `function` on `machine`.
Step step(const ProgramFunction& function, const BasicBlock& block, const Surroundings& surroundings,
          const CodeCost& cost, Machine machine);

}  // namespace finemote::gen::wcet
