// What the emulated board executes against the ways that the static analysis allows; and wrong marks and costs, which
// must show there.
#include <nlohmann/json.hpp>

#include "catch.hpp"
#include "generator/image/exception.hpp"
#include "generator/wcet/causes.hpp"
#include "wcet/follower.hpp"
#include "wcet/ran_robot.hpp"

using namespace finemote;
using namespace finemote::gen::wcet;
using namespace finemote::test;

namespace {

/// A recorded run, and what it is held against.
struct Case {
  explicit Case(const std::vector<std::string>& words)
      : ran(words),
        loaded(ran.image()),
        routes(loaded, documented_costs(), loaded.marks),
        recording(record_job(ran.job(), {routes.borders(), routes.prepared.words_at_start(), gen::kSysTickException})) {
  }

  [[nodiscard]] std::uint64_t mistakes_with(const Marks& marks) const {
    return follow(recording, Routes(loaded, documented_costs(), marks)).count;
  }

  RanRobot ran;
  LoadedImage loaded;
  Routes routes;
  Recording recording;
};

void hold(const Case& run, const Findings& findings) {
  CHECK(run.routes.problems.empty());
  for (const std::string& mistake : findings.mistakes) FAIL_CHECK(mistake);
  for (const std::string& changed : run.recording.changed) FAIL_CHECK(changed);
  CHECK(findings.count == 0);
  CHECK(findings.routines.size() >= 3);
  CHECK(findings.brackets.size() >= 6);
}

/// Edges into some nodes cost nothing.
template <class Which>
std::uint64_t mistakes_without_cost(Case& run, Which which) {
  const auto before = run.routes.routines;
  for (auto& [exception, routine] : run.routes.routines) {
    for (std::size_t from = 0; from < routine.onward.size(); ++from) {
      for (Onward& next : routine.onward[from]) {
        if (which(routine.walked.graph.nodes[from], routine.walked.graph.nodes[next.to])) next.cost = 0;
      }
    }
  }
  const std::uint64_t mistakes = follow(run.recording, run.routes).count;
  run.routes.routines = before;
  return mistakes;
}

bool is_call(const UnrolledNode& from, const UnrolledNode& to) {
  return from.function != to.function && to.block == to.function->graph.entry;
}

bool is_return(const UnrolledNode& from, const UnrolledNode& to) {
  return from.function != to.function && to.block != to.function->graph.entry;
}

bool is_branch(const UnrolledNode& from, const UnrolledNode& to) {
  return from.function == to.function && from.function->graph.blocks.at(from.block).end != to.block;
}

/// Without the ways into one node that was passed.
std::uint64_t mistakes_without_way_to(Case& run, unsigned exception, std::size_t node) {
  Routine& routine = run.routes.routines.at(exception);
  const auto before = routine.onward;
  for (auto& onward : routine.onward) {
    onward.erase(std::remove_if(onward.begin(), onward.end(), [&](const Onward& next) { return next.to == node; }),
                 onward.end());
  }
  const std::uint64_t mistakes = follow(run.recording, run.routes).count;
  routine.onward = before;
  return mistakes;
}

}  // namespace

TEST_CASE("what runs on the examples is in the graphs, and takes no longer than they say") {
  for (const char* example : {"examples/finsrov.urdf", "examples/six_joint_arm.urdf", "examples/discovery.urdf",
                              "examples/deep_forest.urdf"}) {
    CAPTURE(example);
    const Case run({source_path(example), "--duration", "50ms"});
    const Findings findings = follow(run.recording, run.routes);
    hold(run, findings);
    CHECK(findings.faults.empty());  // nothing failed
  }
}

TEST_CASE("what is wrong in the marks or in the graph shows in a run") {
  Case run({source_path("examples/infantry.urdf"), "--duration", "50ms"});
  const Findings findings = follow(run.recording, run.routes);
  hold(run, findings);
  const Marks& marks = run.loaded.marks;

  // A place of every run that is told to lie after a fault.
  Marks wrong = marks;
  const auto& [exception, routine] = *run.routes.routines.begin();
  wrong.faults.insert(routine.walked.graph.nodes[0].block);
  CHECK_FALSE(follow(run.recording, Routes(run.loaded, documented_costs(), wrong)).faults.empty());

  // Nothing is done again.
  if (findings.retries > 0) {
    wrong = marks;
    wrong.retries.clear();
    CHECK(run.mistakes_with(wrong) > 0);
  }

  // Where software asks only lines of the bus lead.
  wrong = marks;
  for (auto& [place, causes] : wrong.raised) causes = causes == kRequest ? kStep : causes;
  if (wrong.raised != marks.raised) CHECK(run.mistakes_with(wrong) > 0);

  CHECK(mistakes_without_cost(run, is_call) > 0);
  CHECK(mistakes_without_cost(run, is_return) > 0);
  CHECK(mistakes_without_cost(run, is_branch) > 0);

  // Every hundredth way that was taken.
  std::size_t number = 0;
  for (const auto& [of, node] : findings.nodes) {
    if (node == 0 || number++ % 500 != 0) continue;
    CAPTURE(of, node);
    CHECK(mistakes_without_way_to(run, of, node) > 0);
  }
}

TEST_CASE("a loop that turns once more than its mark allows shows in a run") {
  const TemporaryFolder folder;
  write_file(folder.path("r.urdf"), R"(<robot name="r"><link name="l"/><finemote version="1">
  <board name="robomaster_type_c"/><device name="own" type="list" period="5ms"/></finemote></robot>)");
  write_file(folder.path("devices/list.json"), R"({"schema": "finemote.device/1", "type": "list", "summary": "counts",
  "class": "List", "header": "list.hpp", "provides": [], "params": [], "wcet": {"update_ns": 20000, "handle_ns": 1000}})");
  write_file(folder.path("devices/list.hpp"), R"(#pragma once
#include <cstdint>
#include <finemote/loop_bound.hpp>
class List {
 public:
  constexpr List() = default;
  void update() {
    const finemote::LoopBound<3> all;
    for (std::uint32_t i = 0; i < size_; ++i) {
      all.pass();
      sum_ = sum_ + i;
    }
  }
  void handle() {}
 private:
  std::uint32_t volatile size_ = 3, sum_ = 0;
};
)");
  const Case run({folder.path("r.urdf"), "--duration", "50ms"});
  const Findings findings = follow(run.recording, run.routes);
  CHECK(findings.count == 0);
  REQUIRE(findings.bounds_passed.size() == 1);
  Marks wrong = run.loaded.marks;
  --wrong.loop_bounds.at(*findings.bounds_passed.begin());
  CHECK(run.mistakes_with(wrong) > 0);
}

TEST_CASE("a word that start-up is told to set for good, and does not, shows") {
  const RanRobot ran({source_path("examples/infantry.urdf"), "--duration", "1ms"});
  const LoadedImage loaded(ran.image());
  const Routes routes(loaded, documented_costs(), loaded.marks);
  std::map<std::uint32_t, std::uint32_t> words = routes.prepared.words_at_start();
  REQUIRE_FALSE(words.empty());
  ++words.begin()->second;
  CHECK_FALSE(record_job(ran.job(), {routes.borders(), words, gen::kSysTickException}).changed.empty());
}
