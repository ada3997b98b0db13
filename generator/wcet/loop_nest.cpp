#include "generator/wcet/loop_nest.hpp"

#include <algorithm>
#include <utility>

namespace finemote::gen::wcet {

LoopNest::LoopNest(const FlowGraph& graph) {
  if (graph.blocks.count(graph.entry) == 0) {
    orders_.resize(1);
    return;
  }
  number(graph);
  find_dominators(graph);
  find_loops(graph);
  nest();
  sort_into_orders();
}

bool LoopNest::is_on_every_turn(std::uint32_t block) const {
  const auto index = around(block);
  if (!index) return false;
  const Loop& loop = loops_[*index];
  const auto& before = predecessors_.at(loop.header);
  return std::all_of(before.begin(), before.end(),
                     [&](std::uint32_t from) { return loop.blocks.count(from) == 0 || dominates(block, from); });
}

/// Depth first, without recursion: functions may be long.
void LoopNest::number(const FlowGraph& graph) {
  std::set<std::uint32_t> seen{graph.entry};
  std::vector<std::pair<std::uint32_t, std::size_t>> open{{graph.entry, 0}};
  while (!open.empty()) {
    auto& [block, next] = open.back();
    const auto& edges = graph.blocks.at(block).edges;
    if (next == edges.size()) {
      reverse_postorder_.push_back(block);
      open.pop_back();
      continue;
    }
    const std::uint32_t to = edges[next++].to;
    if (seen.insert(to).second) open.emplace_back(to, 0);
  }
  std::reverse(reverse_postorder_.begin(), reverse_postorder_.end());
  for (std::size_t i = 0; i < reverse_postorder_.size(); ++i) numbers_[reverse_postorder_[i]] = i;
  for (const std::uint32_t block : reverse_postorder_) {
    for (const FlowEdge& edge : graph.blocks.at(block).edges) predecessors_[edge.to].push_back(block);
  }
}

/// Cooper, Harvey, Kennedy: A Simple, Fast Dominance Algorithm.
void LoopNest::find_dominators(const FlowGraph& graph) {
  constexpr std::size_t kUnknown = SIZE_MAX;
  auto& dominators = immediate_dominators_;
  dominators.assign(reverse_postorder_.size(), kUnknown);
  dominators[numbers_.at(graph.entry)] = numbers_.at(graph.entry);
  const auto common = [&](std::size_t a, std::size_t b) {
    while (a != b) (a > b ? a : b) = dominators[std::max(a, b)];
    return a;
  };
  for (bool is_changed = true; is_changed;) {
    is_changed = false;
    for (std::size_t i = 1; i < reverse_postorder_.size(); ++i) {
      std::size_t dominator = kUnknown;
      for (const std::uint32_t block : predecessors_[reverse_postorder_[i]]) {
        const std::size_t p = numbers_.at(block);
        if (dominators[p] != kUnknown) dominator = dominator == kUnknown ? p : common(p, dominator);
      }
      is_changed |= std::exchange(dominators[i], dominator) != dominator;
    }
  }
}

bool LoopNest::dominates(std::uint32_t a, std::uint32_t b) const {
  const std::size_t above = numbers_.at(a);
  std::size_t i = numbers_.at(b);
  while (i > above) i = immediate_dominators_[i];
  return i == above;
}

void LoopNest::find_loops(const FlowGraph& graph) {
  std::map<std::uint32_t, std::set<std::uint32_t>> bodies;
  for (const std::uint32_t block : reverse_postorder_) {
    for (const FlowEdge& edge : graph.blocks.at(block).edges) {
      if (numbers_.at(edge.to) > numbers_.at(block)) continue;
      if (!dominates(edge.to, block)) {
        irreducible_.push_back(edge.to);
        continue;
      }
      auto& body = bodies[edge.to];
      body.insert(edge.to);
      std::vector<std::uint32_t> open{block};
      while (!open.empty()) {
        const std::uint32_t member = open.back();
        open.pop_back();
        if (!body.insert(member).second) continue;
        for (const std::uint32_t before : predecessors_[member]) open.push_back(before);
      }
    }
  }
  for (auto& [header, body] : bodies) loops_.push_back({header, std::move(body), {}});
}

void LoopNest::nest() {
  // From large to small: a loop that holds another has more blocks.
  std::sort(loops_.begin(), loops_.end(),
            [](const Loop& a, const Loop& b) { return a.blocks.size() > b.blocks.size(); });
  for (std::size_t i = 0; i < loops_.size(); ++i) {
    loops_[i].parent = around(loops_[i].header);
    for (const std::uint32_t block : loops_[i].blocks) innermost_[block] = i;
  }
}

void LoopNest::sort_into_orders() {
  orders_.resize(loops_.size() + 1);
  for (const std::uint32_t block : reverse_postorder_) {
    const auto loop = around(block);
    orders_[loop.value_or(loops_.size())].push_back(block);
    if (loop && loops_[*loop].header == block) orders_[loops_[*loop].parent.value_or(loops_.size())].push_back(block);
  }
}

std::optional<std::size_t> LoopNest::around(std::uint32_t block) const {
  const auto found = innermost_.find(block);
  return found == innermost_.end() ? std::nullopt : std::optional(found->second);
}

const std::vector<std::uint32_t>& LoopNest::order(std::optional<std::size_t> loop) const {
  return orders_[loop.value_or(loops_.size())];
}

}  // namespace finemote::gen::wcet
