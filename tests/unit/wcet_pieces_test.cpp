// What runs beside stages: routines by what raised them, jobs around their stages, iterations that an interrupt adds.
#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>
#include <random>

#include "catch.hpp"
#include "generator/wcet/causes.hpp"
#include "generator/wcet/events.hpp"
#include "generator/wcet/gaps.hpp"
#include "generator/wcet/repetition.hpp"
#include "generator/wcet/retries.hpp"
#include "source_dir.hpp"
#include "tests/read.hpp"

using namespace finemote::gen::wcet;

namespace {

using Word = std::uint32_t;

Word roll(Word limit) {
  static std::mt19937 dice(11);
  return std::uniform_int_distribution<Word>(0, limit)(dice);
}

/// Edges lead to later nodes only; the block of a node is its number.
UnrolledGraph random_graph(std::size_t size) {
  UnrolledGraph graph;
  for (std::size_t node = 0; node < size; ++node) {
    UnrolledNode fresh{nullptr, static_cast<Word>(node), static_cast<Cycles>(roll(20)), {}};
    for (std::size_t from = 0; from < node; ++from) {
      if (from + 1 == node || roll(3) == 0) fresh.from.push_back({from, static_cast<Cycles>(roll(5))});
    }
    graph.nodes.push_back(std::move(fresh));
  }
  graph.exits = {size - 1};
  return graph;
}

struct Way {
  std::vector<std::size_t> nodes;  ///< from an exit back to the entry
  Cycles cycles = 0;
};

/// Every way through a graph.
void each_way(const UnrolledGraph& graph, const std::function<void(const Way&)>& take) {
  std::function<void(Way)> go_on = [&](Way way) {
    const UnrolledNode& node = graph.nodes[way.nodes.back()];
    way.cycles += node.cost;
    if (way.nodes.back() == 0) return take(way);
    for (const UnrolledEdge& edge : node.from) {
      Way longer = way;
      longer.nodes.push_back(edge.from);
      longer.cycles += edge.cost;
      go_on(std::move(longer));
    }
  };
  for (const std::size_t exit : graph.exits) go_on(Way{{exit}, 0});
}

/// Whether one of these causes can be all that raised a run that takes this way.
bool may_be_of(Causes causes, const Way& way, const Marks& marks) {
  return std::all_of(way.nodes.begin(), way.nodes.end(), [&](std::size_t node) {
    const auto mark = marks.raised.find(static_cast<Word>(node));
    return mark == marks.raised.end() || (mark->second & causes) != 0;
  });
}

Marks random_causes(std::size_t size) {
  Marks marks;
  for (std::size_t node = 1; node + 1 < size; ++node) {
    if (roll(1) == 0) marks.raised[static_cast<Word>(node)] = 1 + roll(6);
  }
  return marks;
}

Marks brackets_at(const std::vector<std::pair<Word, Word>>& list) {
  Marks marks;
  for (const auto& [block, number] : list) marks.brackets.emplace(block, number);
  return marks;
}

constexpr Word kOther = 1000;

/// What runs before the stages of these marks; -1: they never begin after anything.
Cycles before(const Gaps& gaps, std::set<Word> begun) {
  for (const Gap& gap : gaps.before) {
    if (gap.begun == begun) return gap.cycles;
  }
  return -1;
}

/// Nodes one after the other, each of its own cost.
UnrolledGraph chain_of(const std::vector<Cycles>& costs) {
  UnrolledGraph graph;
  for (std::size_t node = 0; node < costs.size(); ++node) {
    graph.nodes.push_back({nullptr, static_cast<Word>(node), costs[node], {}});
    if (node > 0) graph.nodes.back().from = {{node - 1, 0}};
  }
  graph.exits = {costs.size() - 1};
  return graph;
}

}  // namespace

TEST_CASE("what an interrupt may have done again fits into what the analysis charges each interrupt with") {
  const auto chip =
      nlohmann::json::parse(finemote::test::read(finemote::test::source_dir() + "/schemas/chips/stm32f407.json"));
  const auto charged = chip.at("costs").at("preemption").at("ns").get<std::int64_t>();
  constexpr std::int64_t kCoreClock = 168000000;  // Hz, the fastest: the fewest nanoseconds
  CHECK(kLongestRepetition * 1000000000 <= charged * kCoreClock);
  CHECK((kLongestRepetition + 1) * 1000000000 > charged * kCoreClock);
}

TEST_CASE("a run takes no longer than its cause allows, and one of several causes no longer than they do together") {
  int told_apart = 0;
  for (int i = 0; i < 300; ++i) {
    const std::size_t size = 3 + roll(6);
    const UnrolledGraph graph = random_graph(size);
    const Marks marks = random_causes(size);
    const CauseTimes times = times_by_cause(graph, marks);
    each_way(graph, [&](const Way& way) {
      for (Causes causes = 1; causes < 8; ++causes) {
        if (!may_be_of(causes, way, marks)) continue;
        Cycles sum = 0;
        for (const auto& [cause, cycles] : times) sum += (cause & causes) != 0 ? cycles : 0;
        CHECK(way.cycles <= sum);
      }
    });
    const std::set<Cycles> different{times.count(1) != 0 ? times.at(1) : 0, times.count(2) != 0 ? times.at(2) : 0};
    told_apart += different.size() > 1 ? 1 : 0;
  }
  CHECK(told_apart > 100);
}

TEST_CASE("without marks every cause may take the longest way") {
  const CauseTimes times = times_by_cause(chain_of({3, 4}), {});
  CHECK(times == CauseTimes{{kRequest, 7}, {kStep, 7}, {kEnd, 7}, {kReceived, 7}, {kEvent, 7}});
}

TEST_CASE("a cause that no way is left for is not there") {
  Marks marks;
  marks.raised[0] = kReceived;
  CHECK(times_by_cause(chain_of({3, 4}), marks) == CauseTimes{{kReceived, 7}});
}

TEST_CASE("runs that serve several interrupts take no longer than each of these alone is charged") {
  for (int i = 0; i < 200; ++i) {
    std::vector<Cycles> by_served{static_cast<Cycles>(roll(20))};
    for (std::size_t served = 1 + roll(4); served > 0; --served)
      by_served.push_back(by_served.back() + static_cast<Cycles>(roll(40)));
    const Cycles each = time_of_each(by_served);
    // Interrupts come, and each run serves as many as it likes; those that are left over find nothing.
    for (int n = 0; n < 20; ++n) {
      Cycles taken = 0;
      std::size_t came = 0;
      for (std::size_t run = 1 + roll(5); run > 0; --run) {
        const std::size_t served = 1 + roll(static_cast<Word>(by_served.size() - 2));
        taken += by_served[served] + static_cast<Cycles>(roll(static_cast<Word>(served - 1))) * by_served[0];
        came += served;
      }
      CHECK(taken <= static_cast<Cycles>(came) * each);
    }
  }
  CHECK(time_of_each({5, 12, 19}) == 12);       // an iteration of 7
  CHECK(time_of_each({5, 12, 30}) == 18);       // two of them take longer than twice one
  CHECK(time_of_each({10, 11, 12, 13}) == 11);  // runs that find nothing are paid for
}

TEST_CASE("what a job takes is told by the stage that it runs before, and what is left behind the last") {
  // entry 5, stage of mark 2: 10, between 3, stage of mark 4: 20, after 7
  const Gaps gaps = gaps_between(chain_of({5, 10, 3, 20, 7}), brackets_at({{1, 2}, {2, 3}, {3, 4}, {4, 5}}), kOther);
  CHECK(before(gaps, {2}) == 5);
  CHECK(before(gaps, {4}) == 3);
  CHECK(gaps.before.size() == 2);
  CHECK(gaps.rest == 7);
}

TEST_CASE("stages that follow each other at once have nothing between them") {
  const Gaps gaps = gaps_between(chain_of({5, 10, 20, 7}), brackets_at({{1, 2}, {2, 3}, {2, 4}, {3, 5}}), kOther);
  CHECK(before(gaps, {2}) == 5);
  CHECK(gaps.before.size() == 1);
  CHECK(gaps.rest == 7);
}

TEST_CASE("empty stages share a place: what runs before them is counted once, and time goes on behind them") {
  const Gaps gaps = gaps_between(chain_of({5, 9}), brackets_at({{1, 2}, {1, 3}, {1, 4}, {1, 5}}), kOther);
  CHECK(before(gaps, {2, 4}) == 5);
  CHECK(gaps.before.size() == 1);
  CHECK(gaps.rest == 9);
}

TEST_CASE("of several ways around stages the longest counts, and marks of other work are none of stages") {
  UnrolledGraph graph = chain_of({5, 30, 2, 10, 4});  // 0 - 1 - 2 - 3 - 4, and 0 - 2
  graph.nodes[2].from.push_back({0, 6});
  const Gaps gaps = gaps_between(graph, brackets_at({{3, 2}, {4, 3}, {1, kOther}, {2, kOther + 1}}), kOther);
  CHECK(before(gaps, {2}) == 5 + 30 + 2);
  CHECK(gaps.rest == 4);
}

TEST_CASE("a job without stages is all rest") { CHECK(gaps_between(chain_of({5, 9}), {}, kOther).rest == 14); }

TEST_CASE("one more round is the longest way from a mark back to it") {
  Walked walked;
  walked.graph = chain_of({100, 4, 5, 50});                 // 1 is the mark; from 2 it goes back to 1, or on to 3
  walked.graph.nodes.push_back({nullptr, 9, 8, {{1, 2}}});  // another way around
  walked.retries.push_back({RetriedBy::event, 1, {{2, 3}, {4, 1}}});
  RetryTimes times{};
  take_retries(walked, times);
  CHECK(times == RetryTimes{0, 0, 4 + 2 + 8 + 1, 0});
  walked.retries = {{RetriedBy::event, 1, {{2, 3}}}};
  take_retries(walked, times);
  CHECK(times[2] == 15);  // the longest of all
}
