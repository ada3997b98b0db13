#include "generator/wcet/events.hpp"

#include <algorithm>
#include <vector>

#include "generator/wcet/without.hpp"

namespace finemote::gen::wcet {
namespace {

/// More than any peripheral holds back.
constexpr std::uint32_t kMostServed = 32;

CauseTimes times_of(const Walked& walked, const Marks& marks) {
  return times_by_cause(without(walked.graph, marks.faults), marks);
}

/// The only mark of the graph that says so; none: there is none, or there are several.
const std::pair<const std::uint32_t, std::uint32_t>* served_in_turn(const UnrolledGraph& graph, const Marks& marks) {
  const std::pair<const std::uint32_t, std::uint32_t>* found = nullptr;
  for (const auto& mark : marks.once_for_each) {
    const bool is_there = std::any_of(graph.nodes.begin(), graph.nodes.end(),
                                      [&](const UnrolledNode& node) { return node.block == mark.first; });
    if (is_there && found != nullptr) return nullptr;
    if (is_there) found = &mark;
  }
  return found;
}

}  // namespace

Cycles time_of_each(const std::vector<Cycles>& by_served) {
  Cycles each = 0;
  for (std::size_t served = 1; served < by_served.size(); ++served) {
    const auto count = static_cast<Cycles>(served);
    const Cycles all = by_served[served] + (count - 1) * by_served[0];
    each = std::max(each, (all + count - 1) / count);
  }
  return each;
}

CauseTimes times_by_event(const PreparedImage& image, std::uint32_t entry, const UnrolledGraph& undisturbed) {
  const Marks& marks = image.marks();
  CauseTimes times = times_by_cause(undisturbed, marks);
  const auto* mark = served_in_turn(undisturbed, marks);
  if (mark == nullptr || times.count(mark->second) == 0) return times;
  std::vector<Cycles> by_served;
  Marks limited = marks;
  for (std::uint32_t served = 0; served <= kMostServed; ++served) {
    limited.loop_bounds[mark->first] = served;
    const Walked some = image.walk_from(entry, limited);
    const CauseTimes of_some = times_of(some, marks);
    const auto found = of_some.find(mark->second);
    if (!some.problems.empty() || found == of_some.end()) return times;
    by_served.push_back(found->second);
    if (served > 0 && of_some == times) {  // more it cannot serve
      times[mark->second] = time_of_each(by_served);
      return times;
    }
  }
  return times;
}

}  // namespace finemote::gen::wcet
