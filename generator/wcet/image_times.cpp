#include "generator/wcet/image_times.hpp"

#include <fmt/format.h>

#include <map>
#include <set>

#include "generator/image/double_arithmetic.hpp"
#include "generator/wcet/certificate.hpp"
#include "generator/wcet/events.hpp"
#include "generator/wcet/fpu_use.hpp"
#include "generator/wcet/longest_path.hpp"
#include "generator/wcet/prepared_image.hpp"
#include "generator/wcet/proven_bound.hpp"
#include "generator/wcet/vectors.hpp"
#include "generator/wcet/without.hpp"

namespace finemote::gen::wcet {
namespace {

std::string name_of(const ProgramFunction* function) {
  return function == nullptr ? std::string("?") : readable_name(function->symbol->name);
}

/// Of a function that calculates with 'double': what its caller asks of this core; empty: it does not.
std::string asked_of(const std::string& function) {
  if (is_double_arithmetic(function))
    return fmt::format("arithmetic on 'double' has no bound on this core: {}", kInsteadOfDouble);
  if (is_float_to_64_bits(function))
    return fmt::format("a 64-bit integer made of a 'float' has no bound on this core: {}", kInsteadOf64Bits);
  return {};
}

/// Arithmetic on 'double' is what its caller does, wherever in it the way was lost.
void blame_caller(TimeGap& gap) {
  while (!gap.calls.empty()) {
    const std::string why = asked_of(gap.function);
    if (why.empty()) return;
    move_to_caller(gap);
    gap.why = why;
  }
}

TimeGap gap_of(const WalkProblem& problem) {
  TimeGap gap{problem.address, name_of(problem.function), problem.why};
  for (const CallSite& call : problem.calls) gap.calls.push_back({call.address, name_of(call.function)});
  blame_caller(gap);
  return gap;
}

class Timing {
 public:
  Timing(const Image& image, const KeptMembers& kept, Placement placement)
      : image_(image), prepared_(image, kept, CodeCost(placement), read_marks(image)) {}

  ImageTimes result() {
    for (const Vector& vector : interrupt_vectors(image_)) add(vector);
    for (auto& [address, gap] : gaps_) times_.gaps.push_back(std::move(gap));
    return std::move(times_);
  }

 private:
  void add(const Vector& vector) {
    const Walked walked = prepared_.walk_from(vector.entry);
    for (const auto& [address, problem] : walked.problems) add(gap_of(problem));
    if (!walked.problems.empty()) return;
    const auto path = longest_path(walked.graph);
    const std::string doubt =
        path ? check_certificate(walked.graph, path->potentials, path->bound) : "no way leads out";
    if (!doubt.empty()) return add(TimeGap{vector.entry, name_of(prepared_.program().at(vector.entry)), doubt});
    RoutineTime routine;
    routine.exception = vector.exception;
    routine.name = name_of(prepared_.program().at(vector.entry));
    routine.cycles = path->bound;
    routine.path = steps_of(walked.graph, *path);
    const UnrolledGraph undisturbed = without(walked.graph, prepared_.marks().faults);
    if (const auto short_path = proven_path(undisturbed)) {
      routine.without_faults = short_path->bound;
      routine.path_without_faults = steps_of(undisturbed, *short_path);
    }
    add_brackets(walked, undisturbed, routine);
    EventTimes events = times_by_event(prepared_, vector.entry, undisturbed);
    routine.by_cause = std::move(events.by_cause);
    routine.requests = std::move(events.requests);
    routine.gaps = gaps_between(undisturbed, prepared_.marks(), kFirstWorkMark);
    routine.uses_fpu = uses_fpu(walked.graph);
    take_retries(walked, times_.retries);
    times_.routines.push_back(std::move(routine));
  }

  void add(TimeGap gap) { gaps_.try_emplace(gap.address, std::move(gap)); }

  void add_brackets(const Walked& walked, const UnrolledGraph& undisturbed, RoutineTime& routine) const {
    for (const std::uint32_t mark : begun_in(walked.graph)) {
      const auto path = way_behind(mark, walked.graph);
      if (!path) continue;
      BracketTime bracket;
      bracket.mark = mark;
      bracket.cycles = path->bound;
      bracket.path = steps_of(walked.graph, *path);
      bracket.loops = loops_on(walked, path->potentials);
      if (const auto short_path = way_behind(mark, undisturbed)) {
        bracket.without_faults = short_path->bound;
        bracket.path_without_faults = steps_of(undisturbed, *short_path);
      }
      routine.brackets.push_back(std::move(bracket));
    }
  }

  /// From a mark that begins a bracket to the next, which ends it.
  [[nodiscard]] std::optional<LongestPath> way_behind(std::uint32_t mark, const UnrolledGraph& graph) const {
    return longest_between(graph, nodes_at(graph, mark), nodes_at(graph, mark + 1));
  }

  /// Marks of even number begin a bracket.
  [[nodiscard]] std::set<std::uint32_t> begun_in(const UnrolledGraph& graph) const {
    std::set<std::uint32_t> begun;
    for (const UnrolledNode& node : graph.nodes) {
      const auto [first, last] = prepared_.marks().brackets.equal_range(node.block);
      for (auto mark = first; mark != last; ++mark) {
        if (mark->second % 2 == 0) begun.insert(mark->second);
      }
    }
    return begun;
  }

  [[nodiscard]] std::vector<bool> nodes_at(const UnrolledGraph& graph, std::uint32_t mark) const {
    std::vector<bool> are_there(graph.nodes.size());
    for (std::size_t node = 0; node < graph.nodes.size(); ++node) {
      const auto [first, last] = prepared_.marks().brackets.equal_range(graph.nodes[node].block);
      for (auto at = first; at != last; ++at) {
        if (at->second == mark) are_there[node] = true;
      }
    }
    return are_there;
  }

  static std::vector<PathStep> steps_of(const UnrolledGraph& graph, const LongestPath& path) {
    std::vector<PathStep> steps;
    for (std::size_t i = 0; i < path.nodes.size(); ++i) {
      const UnrolledNode& node = graph.nodes[path.nodes[i]];
      const Cycles next = i + 1 < path.nodes.size() ? path.potentials[path.nodes[i + 1]] : path.bound;
      steps.push_back({node.block, name_of(node.function), next - path.potentials[path.nodes[i]]});
    }
    return steps;
  }

  static std::vector<LoopTime> loops_on(const Walked& walked, const Potentials& potentials) {
    std::set<std::uint32_t> headers;
    for (std::size_t node = 0; node < potentials.size(); ++node) {
      const std::uint32_t block = walked.graph.nodes[node].block;
      if (potentials[node] >= 0 && walked.loops.count(block) != 0) headers.insert(block);
    }
    std::vector<LoopTime> loops;
    for (const std::uint32_t header : headers) {
      const CountedLoop& loop = walked.loops.at(header);
      loops.push_back({header, name_of(loop.function), loop.rounds, loop.is_by_mark});
    }
    return loops;
  }

  const Image& image_;
  const PreparedImage prepared_;
  std::map<std::uint32_t, TimeGap> gaps_;
  ImageTimes times_;
};

}  // namespace

void move_to_caller(TimeGap& gap) {
  gap.address = gap.calls.front().address;
  gap.function = gap.calls.front().function;
  gap.calls.erase(gap.calls.begin());
}

Placement placement_of(const Image& image) {
  constexpr std::uint32_t kFlash = 0x0800'0000;
  const auto vectors = interrupt_vectors(image);
  return !vectors.empty() && vectors.front().entry < kFlash ? Placement::sram : Placement::flash;
}

ImageTimes time_image(const Image& image, const KeptMembers& kept, Placement placement) {
  return Timing(image, kept, placement).result();
}

}  // namespace finemote::gen::wcet
