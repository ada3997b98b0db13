#include "wcet/routes.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "generator/wcet/longest_path.hpp"
#include "generator/wcet/vectors.hpp"

namespace finemote::test {
namespace {

using namespace gen::wcet;

gen::Image image_at(const std::string& path) {
  gen::Diagnostics diagnostics;
  auto image = gen::read_image(path, diagnostics);
  if (!image) throw std::runtime_error("no image at " + path);
  return std::move(*image);
}

gen::KeptMembers members_at(const std::string& path) {
  gen::Diagnostics diagnostics;
  return gen::kept_members(path, {}, diagnostics);
}

Routine routine_of(unsigned exception, Walked walked) {
  Routine routine;
  routine.exception = exception;
  const std::size_t size = walked.graph.nodes.size();
  routine.onward.resize(size);
  routine.is_exit.resize(size);
  for (std::size_t node = 0; node < size; ++node) {
    for (const UnrolledEdge& edge : walked.graph.nodes[node].from)
      routine.onward[edge.from].push_back({node, edge.cost});
  }
  for (const std::size_t exit : walked.graph.exits) routine.is_exit[exit] = true;
  const auto path = longest_path(walked.graph);
  routine.bound = path ? path->bound : 0;
  routine.walked = std::move(walked);
  return routine;
}

/// From each begin mark to its end mark.
std::map<std::uint32_t, Cycles> bracket_bounds(const UnrolledGraph& graph, const Marks& marks) {
  std::map<std::uint32_t, std::vector<bool>> nodes;  // by mark
  for (std::size_t node = 0; node < graph.nodes.size(); ++node) {
    const auto [first, last] = marks.brackets.equal_range(graph.nodes[node].block);
    for (auto at = first; at != last; ++at) {
      auto& there = nodes[at->second];
      there.resize(graph.nodes.size());
      there[node] = true;
    }
  }
  std::map<std::uint32_t, Cycles> bounds;
  for (const auto& [mark, begins] : nodes) {
    const auto ends = nodes.find(mark + 1);
    if (mark % 2 != 0 || ends == nodes.end()) continue;
    if (const auto path = longest_between(graph, begins, ends->second)) bounds[mark] = path->bound;
  }
  return bounds;
}

}  // namespace

std::optional<Onward> Routine::behind(std::size_t node, std::uint32_t address) const {
  std::optional<Onward> found;
  for (const Onward& next : onward[node]) {
    if (walked.graph.nodes[next.to].block != address) continue;
    if (!found || next.cost > found->cost) found = next;
  }
  return found;
}

LoadedImage::LoadedImage(const std::string& path)
    : image(image_at(path)), kept(members_at(path)), marks(read_marks(image)), placement(placement_of(image)) {}

Routes::Routes(const LoadedImage& from, const CostTable& costs, Marks marks)
    : loaded(from), cost(from.placement, costs), prepared(from.image, from.kept, cost, std::move(marks)) {
  for (const Vector& vector : interrupt_vectors(from.image)) {
    Walked walked = prepared.walk_from(vector.entry);
    for (const auto& [address, problem] : walked.problems) problems.push_back(problem.why);
    Routine routine = routine_of(vector.exception, std::move(walked));
    routine.brackets = bracket_bounds(routine.walked.graph, prepared.marks());
    routines.emplace(vector.exception, std::move(routine));
  }
}

std::vector<std::uint32_t> Routes::borders() const {
  std::vector<std::uint32_t> all;
  for (const auto& [address, function] : prepared.program().functions()) {
    for (const auto& [begin, block] : function.graph.blocks) all.push_back(begin);
  }
  return all;
}

}  // namespace finemote::test
