// The loops of a function, which contain each other or have nothing in common.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "generator/image/flow_graph.hpp"

namespace finemote::gen::wcet {

/// A natural loop: all that reaches an edge back to the header without passing it. Loops of one header are one.
struct Loop {
  std::uint32_t header = 0;
  std::set<std::uint32_t> blocks;     ///< by their starts, the header too
  std::optional<std::size_t> parent;  ///< the smallest other loop around it; none: the function

  /// How often a mark in it may be passed beyond what its source says: before a test that the loop begins with, after
  /// its body, it is passed when the loop is left, too.
  [[nodiscard]] std::uint32_t passes_besides(std::uint32_t mark) const {
    return mark == header && *blocks.begin() != header ? 1 : 0;
  }
};

class LoopNest {
 public:
  explicit LoopNest(const FlowGraph& graph);

  [[nodiscard]] const std::vector<Loop>& loops() const { return loops_; }
  /// The smallest loop that holds a block; none: only the function does.
  [[nodiscard]] std::optional<std::size_t> around(std::uint32_t block) const;
  /// Whether every iteration of the innermost loop around a block passes through it; false where there is none.
  [[nodiscard]] bool is_on_every_turn(std::uint32_t block) const;
  /// Blocks to which an edge leads back from one that they do not dominate: the cycle has further entries, and is no
  /// loop here.
  [[nodiscard]] const std::vector<std::uint32_t>& irreducible() const { return irreducible_; }
  /// What to go through in a loop, or in the function (none): its own blocks and the headers of the loops in it, each
  /// after all that leads to it in one iteration.
  [[nodiscard]] const std::vector<std::uint32_t>& order(std::optional<std::size_t> loop) const;

 private:
  void number(const FlowGraph& graph);
  void find_dominators(const FlowGraph& graph);
  [[nodiscard]] bool dominates(std::uint32_t a, std::uint32_t b) const;
  void find_loops(const FlowGraph& graph);
  void nest();
  void sort_into_orders();

  std::vector<std::uint32_t> reverse_postorder_;
  std::map<std::uint32_t, std::size_t> numbers_;  // in that order
  std::map<std::uint32_t, std::vector<std::uint32_t>> predecessors_;
  std::vector<std::size_t> immediate_dominators_;  // by number
  std::vector<Loop> loops_;
  std::map<std::uint32_t, std::size_t> innermost_;
  std::vector<std::uint32_t> irreducible_;
  std::vector<std::vector<std::uint32_t>> orders_;  // by loop, the function's last
};

}  // namespace finemote::gen::wcet
