// What the ends of frames on one wire can raise together, by hand and against random traffic.
#include "generator/timing/one_wire.hpp"

#include <algorithm>

#include "catch.hpp"
#include "duration_literals.hpp"
#include "generator/simulate/random.hpp"
#include "generator/timing/demand.hpp"

using namespace finemote::gen;
using namespace finemote::gen::timing;

namespace {

Stream source(const std::string& name, Duration apart, Duration cost, std::int64_t count, Duration period) {
  Stream stream{apart, cost, {}, "can." + name, "can", name, BusPlace{0}};
  stream.ends_frame = true;
  Stream::Budget& budget = stream.budgets.emplace_back();
  budget.count = count;
  budget.period = period;
  return stream;
}

Duration work_in(const std::vector<Stream>& streams, Duration window) {
  Effort effort;
  Demand demand(effort);
  demand.add_streams(streams);
  return demand.at(window);
}

struct End {
  Duration at;
  std::size_t kind;
};

/// Ends of frames of all kinds, one frame after the other and mostly without a pause, each kind within its budget.
std::vector<End> random_traffic(const std::vector<Stream>& kinds, Duration length, Random& random) {
  std::vector<End> ends;
  std::vector<std::pair<std::int64_t, std::int64_t>> used(kinds.size(), {-1, 0});  // period, frames in it
  for (Duration at = random.between({}, 500_ns); at < length;) {
    const auto kind = static_cast<std::size_t>(random.between(0, static_cast<std::int64_t>(kinds.size()) - 1));
    const Stream::Budget& budget = kinds[kind].budgets.front();
    const std::int64_t period = floor_div(at, budget.period);
    if (used[kind].first != period) used[kind] = {period, 0};
    if (++used[kind].second <= budget.count) ends.push_back({at, kind});
    at += kinds[kind].separation + (random.one_in(3) ? random.between({}, 300_ns) : Duration::zero());
  }
  return ends;
}

}  // namespace

TEST_CASE(
    "two kinds share the wire: no more ends than of the shortest frame, of each kind as many as its budget allows") {
  const auto streams = one_wire({source("rx", 110_ns, 9_ns, 4, 1000_ns), source("tx", 111_ns, 7_ns, 1, 1000_ns)}, 1_ns);
  REQUIRE(streams.size() == 2);
  CHECK(streams[0].source == "rx");
  CHECK(streams[0].cost == 2_ns);
  CHECK(streams[1].source == "rx and tx");
  CHECK(streams[1].cost == 7_ns);
  CHECK(streams[1].separation == 108_ns);
  CHECK(work_in(streams, 100_ns) == 9_ns);   // one end of any kind; apart they were 16 ns
  CHECK(work_in(streams, 200_ns) == 18_ns);  // two receptions
  CHECK(work_in(streams, 900_ns) == 4 * 9_ns + 7_ns);
}

TEST_CASE("kinds of equal cost are one stream, and what no frame raises is left as it is") {
  Stream request = source("request", 1_ns, 5_ns, 1, 1000_ns);
  request.ends_frame = false;
  const auto streams =
      one_wire({source("rx", 110_ns, 7_ns, 4, 1000_ns), request, source("tx", 90_ns, 7_ns, 1, 1000_ns)}, 1_ns);
  REQUIRE(streams.size() == 2);
  CHECK(streams[0].source == "request");
  CHECK(streams[1].source == "rx and tx");
  CHECK(streams[1].separation == 88_ns);

  const auto alone = one_wire({request, source("rx", 110_ns, 7_ns, 4, 1000_ns)}, 1_ns);
  REQUIRE(alone.size() == 2);
  CHECK(alone[1].separation == 110_ns);
}

TEST_CASE("a kind that nothing but its frames bounds takes the budgets from those it is counted with") {
  Stream any = source("any", 120_ns, 7_ns, 0, 1000_ns);
  any.budgets.clear();
  const auto streams = one_wire({source("rx", 110_ns, 9_ns, 1, 1000_ns), any}, 1_ns);
  REQUIRE(streams.size() == 2);
  CHECK(streams[0].budgets.size() == 1);
  CHECK(streams[1].budgets.empty());
  CHECK(work_in(streams, 1000_ns) == 2_ns + 10 * 7_ns);
}

TEST_CASE(
    "no traffic asks for more than the streams of its wire, and the streams for no more than those of its kinds") {
  Random random(20);
  for (int round = 0; round < 200; ++round) {
    std::vector<Stream> kinds;
    for (const char* name : {"a", "b", "c"}) {
      kinds.push_back(source(name, random.between(40_ns, 160_ns), random.between(1_ns, 20_ns), random.between(1, 5),
                             random.between(400_ns, 1500_ns)));
      kinds.back().budgets.front().carry_in = 1;
    }
    const auto streams = one_wire(kinds, 1_ns);
    const auto ends = random_traffic(kinds, 6000_ns, random);
    for (std::size_t first = 0; first < ends.size(); ++first) {
      Duration work;
      for (std::size_t last = first; last < ends.size(); ++last) {
        work += kinds[ends[last].kind].cost;
        const Duration window = ends[last].at - ends[first].at + 1_ns;
        const Duration bound = work_in(streams, window);
        REQUIRE(work <= bound);
        REQUIRE(bound <= work_in(kinds, window));
      }
    }
  }
}
