#include "generator/wcet/marked_loops.hpp"

#include <set>

#include "generator/image/program.hpp"
#include "generator/wcet/loop_marks.hpp"
#include "generator/wcet/loop_nest.hpp"
#include "generator/wcet/marks.hpp"

namespace finemote::gen::wcet {
namespace {

/// Blocks outside of a loop, next to it.
std::set<std::uint32_t> borders_of(const FlowGraph& graph, const Loop& loop) {
  std::set<std::uint32_t> borders;
  for (const auto& [begin, block] : graph.blocks) {
    const bool is_inside = loop.blocks.count(begin) != 0;
    for (const FlowEdge& edge : block.edges) {
      if (!is_inside && edge.to == loop.header) borders.insert(begin);
      if (is_inside && loop.blocks.count(edge.to) == 0) borders.insert(edge.to);
    }
  }
  return borders;
}

/// Calls enter it, and it returns from inside: no block around it says so.
bool has_hidden_ends(const FlowGraph& graph, const Loop& loop) {
  if (loop.header != graph.entry) return false;
  for (const std::uint32_t begin : loop.blocks) {
    if (graph.blocks.at(begin).leaves) return true;
  }
  return false;
}

void add_loops(const ProgramFunction& function, const Marks& marks, std::vector<MarkedLoop>& loops) {
  const LoopNest nest(function.graph);
  if (!nest.irreducible().empty()) return;  // a loop that is entered in its middle is none of the nest's
  for (const auto& [place, bound] : marks.loop_bounds) {
    if (function.graph.blocks.count(place) == 0) continue;
    const auto around = nest.around(place);
    const bool is_for_interrupts = marks.retries.count(place) != 0;
    if (!around || (!is_for_interrupts && !is_of_loop_around(nest, place, marks))) continue;
    const Loop& loop = nest.loops()[*around];
    if (has_hidden_ends(function.graph, loop)) continue;
    const std::set<std::uint32_t> borders = borders_of(function.graph, loop);
    const std::uint32_t most = bound + passes_besides(loop, place, marks);
    loops.push_back(
        {place, loop.header, most, is_for_interrupts, function.symbol->name, {borders.begin(), borders.end()}});
  }
}

}  // namespace

std::vector<MarkedLoop> marked_loops(const Image& image) {
  const Marks marks = read_marks(image);
  std::vector<MarkedLoop> loops;
  if (marks.loop_bounds.empty()) return loops;
  const Program program(image, marks.addresses());
  for (const auto& [address, function] : program.functions()) add_loops(function, marks, loops);
  return loops;
}

}  // namespace finemote::gen::wcet
