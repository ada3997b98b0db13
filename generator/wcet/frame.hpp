// How far a walk has come in one call of a function, and how a try is taken back.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "generator/wcet/loop_nest.hpp"
#include "generator/wcet/machine.hpp"
#include "generator/wcet/walk.hpp"

namespace finemote::gen::wcet {

/// What comes to a place, by all ways that lead there.
struct Arrival {
  Machine machine;
  std::vector<UnrolledEdge> from;
};

inline void arrive(std::optional<Arrival>& there, Machine machine, const std::vector<UnrolledEdge>& from) {
  if (!there) {
    there = Arrival{std::move(machine), from};
    return;
  }
  there->machine.join(machine);
  there->from.insert(there->from.end(), from.begin(), from.end());
}

using Arrivals = std::map<std::uint32_t, std::optional<Arrival>>;  // by block

/// One call of a function.
struct Frame {
  const ProgramFunction& function;
  const LoopNest& nest;
  Arrivals arrivals;
  std::optional<Arrival> end;
  std::map<std::uint32_t, std::uint32_t> passes;  // of marks, in the loop around each
  std::map<std::uint32_t, std::size_t> passed;    // nodes of the last of them
  bool is_cut_by_mark = false;
  std::optional<std::size_t> unmarked;  // the wait whose own marks of loops do not count
  Interval back;                        // what its caller put into the link register
};

/// What a try of an iteration changes, to be taken back after it.
class Snapshot {
 public:
  Snapshot(const Frame& frame, const Walked& walked)
      : nodes_(walked.graph.nodes.size()),
        retries_(walked.retries.size()),
        arrivals_(frame.arrivals),
        end_(frame.end),
        passes_(frame.passes),
        problems_(walked.problems),
        loops_(walked.loops) {}

  void restore(Frame& frame, Walked& walked) const {
    frame.arrivals = arrivals_;
    frame.end = end_;
    frame.passes = passes_;
    walked.graph.nodes.resize(nodes_);
    walked.retries.resize(retries_);
    walked.problems = problems_;
    walked.loops = loops_;
    walked.waits.erase(walked.waits.lower_bound(nodes_), walked.waits.end());
    walked.countdowns.erase(walked.countdowns.lower_bound(nodes_), walked.countdowns.end());
  }

 private:
  const std::size_t nodes_, retries_;
  const Arrivals arrivals_;
  const std::optional<Arrival> end_;
  const std::map<std::uint32_t, std::uint32_t> passes_;
  const decltype(Walked::problems) problems_;
  const decltype(Walked::loops) loops_;
};

/// Blocks that ways lead to which nothing went on with.
inline std::vector<std::uint32_t> left_over(const Frame& frame) {
  std::vector<std::uint32_t> blocks;
  for (const auto& [block, arrival] : frame.arrivals) {
    if (arrival) blocks.push_back(block);
  }
  return blocks;
}

}  // namespace finemote::gen::wcet
