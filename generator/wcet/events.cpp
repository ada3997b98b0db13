#include "generator/wcet/events.hpp"

#include <algorithm>
#include <vector>

#include "generator/wcet/proven_bound.hpp"
#include "generator/wcet/without.hpp"

namespace finemote::gen::wcet {
namespace {

/// More than any peripheral holds back.
constexpr std::uint32_t kMostServed = 32;

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

/// A routine whose runs serve a limited number of interrupts.
struct Limited {
  CauseTimes by_cause;
  Cycles longest = 0;  ///< whatever raised it
};

/// By how many it serves, from none to as many as there can be, which take `times`; empty: not known.
std::vector<Limited> limited_runs(const PreparedImage& image, std::uint32_t entry, std::uint32_t mark,
                                  const CauseTimes& times) {
  std::vector<Limited> runs;
  Marks limited = image.marks();
  for (std::uint32_t served = 0; served <= kMostServed; ++served) {
    limited.loop_bounds[mark] = served;
    const Walked some = image.walk_from(entry, limited);
    if (!some.problems.empty()) return {};
    const UnrolledGraph graph = without(some.graph, limited.faults);
    const auto longest = proven_bound(graph);
    if (!longest) return {};
    runs.push_back({times_by_cause(graph, limited), *longest});
    if (served > 0 && runs.back().by_cause == times) return runs;  // more it cannot serve
  }
  return {};
}

/// Ends that find frames waiting, and requests. Every interrupt pays for a run that sends nothing, and for each frame
/// that it hands over, or makes room for, the most that a frame adds. There are no more runs than interrupts, and no
/// run takes longer than that for the frames that it sends, whoever handed them over.
/// @param of_end, of_any  a run that ends alone raise, and any run, by the frames that it sends
void tell_requests(const std::vector<Cycles>& of_end, const std::vector<Cycles>& of_any, EventTimes& times) {
  const Cycles added = std::max(most_added(of_end), most_added(of_any));
  times.by_cause[kEnd] = of_end[0] + added;
  for (std::size_t frames = 1; frames < of_any.size(); ++frames)
    times.requests.push_back(of_any[0] + static_cast<Cycles>(frames) * added);
}

}  // namespace

Cycles most_added(const std::vector<Cycles>& by_served) {
  Cycles most = 0;
  for (std::size_t served = 1; served < by_served.size(); ++served) {
    const auto count = static_cast<Cycles>(served);
    most = std::max(most, (by_served[served] - by_served[0] + count - 1) / count);
  }
  return most;
}

Cycles time_of_each(const std::vector<Cycles>& by_served) { return by_served[0] + most_added(by_served); }

EventTimes times_by_event(const PreparedImage& image, std::uint32_t entry, const UnrolledGraph& undisturbed) {
  EventTimes times{times_by_cause(undisturbed, image.marks()), {}};
  const auto* mark = served_in_turn(undisturbed, image.marks());
  if (mark == nullptr || times.by_cause.count(mark->second) == 0) return times;
  std::vector<Cycles> of_cause, of_any;
  for (const Limited& run : limited_runs(image, entry, mark->first, times.by_cause)) {
    const auto found = run.by_cause.find(mark->second);
    if (found == run.by_cause.end()) return times;
    of_cause.push_back(found->second);
    of_any.push_back(run.longest);
  }
  if (of_cause.size() < 2) return times;
  times.by_cause[mark->second] = time_of_each(of_cause);
  if (mark->second == kEnd && times.by_cause.count(kRequest) != 0) tell_requests(of_cause, of_any, times);
  return times;
}

}  // namespace finemote::gen::wcet
