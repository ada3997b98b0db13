// Hints promise what the changed robot then is: each is applied by hand here, and the robot analysed anew.
#include <fmt/format.h>

#include <algorithm>

#include "duration_literals.hpp"
#include "generator/tasks/remodel.hpp"
#include "generator/timing/remedy.hpp"
#include "timing_random.hpp"
#include "timing_robots.hpp"

using namespace finemote::gen;
using namespace finemote::gen::timing;

namespace {

/// A model whose execution times are stretched until some bucket may miss its deadline.
Model unschedulable(std::uint64_t seed) {
  RandomForest random(seed);
  Model model = random.make(kForestClasses[seed % 4]);
  if (seed % 3 != 0) random.extend(model);
  for (;;) {
    Diagnostics unsaid;
    const auto timing = analyse(model, {}, unsaid);
    if (timing && !timing->schedulable) return model;
    for (timing::Device& device : model.devices) {
      device.update_wcet = floor_div(device.update_wcet * 5, 4) + 1_ns;
      device.handle_wcet = floor_div(device.handle_wcet * 5, 4) + 1_ns;
    }
  }
}

/// What a hint says, done by hand to the model.
Model applied(Model model, const std::vector<Change>& changes) {
  for (const Change& change : changes) {
    REQUIRE(change.kind != Change::Kind::rate);
    for (Flush& flush : model.flushes) {
      const auto& ones = change.devices;
      const bool moves = change.kind == Change::Kind::period && !flush.devices.empty() &&
                         std::find(ones.begin(), ones.end(), flush.devices.front()) != ones.end();
      if (moves) flush.period = change.period;
    }
    for (const Rank d : change.devices) {
      timing::Device& device = model.devices[d];
      if (change.kind == Change::Kind::period) {
        device.period = change.period;
      } else {
        device.update_wcet = floor_div(device.update_wcet * change.value, 1000);
        device.handle_wcet = floor_div(device.handle_wcet * change.value, 1000);
      }
    }
  }
  return model;
}

std::optional<Timing> analysed(const Model& model, const AnalysisRequest& request = {}) {
  Diagnostics findings;
  return analyse(model, request, findings);
}

}  // namespace

TEST_CASE("applied literally, every hint for an unschedulable model gives the figure it promises") {
  int enough = 0, together = 0, lower = 0;
  for (std::uint64_t seed = 1; seed <= 120; ++seed) {
    INFO("seed " << seed);
    const Model model = unschedulable(seed);
    AnalysisRequest request;
    request.remodel = model_remodel(model);
    const auto timing = analysed(model, request);
    REQUIRE(timing);
    Trials trials(*timing, request);
    for (const Remedy& remedy : processor_remedies(*timing, trials)) {
      INFO(processor_hint(*timing, remedy));
      const auto after = analysed(applied(model, remedy.proposal.changes));
      REQUIRE(after);
      CHECK(after->schedulable == remedy.schedulable);
      CHECK(after->processor_load == remedy.processor_load);
      CHECK(after->processor_load < timing->processor_load);
      CHECK(remedy.enough == after->schedulable);
      ++(remedy.enough ? enough : lower);
      together += remedy.proposal.text.find(" and period") != std::string::npos;
    }
  }
  INFO(enough << " " << together << " " << lower);
  CHECK(enough > 100);
}

TEST_CASE("the verdict alone is that of the whole analysis, without its chains and trees") {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    INFO("seed " << seed);
    const Model model = seed % 2 == 0 ? unschedulable(seed) : RandomForest(seed).make(kForestClasses[seed % 4]);
    AnalysisRequest request;
    request.requirements.resize(2);
    request.requirements[0].kind = timing::Requirement::Kind::utilization;
    request.requirements[1].kind = timing::Requirement::Kind::jitter;
    request.requirements[1].to = {Rank{0}};
    const auto whole = analysed(model, request);
    request.verdict_only = true;
    const auto verdict = analysed(model, request);
    REQUIRE(whole);
    REQUIRE(verdict);
    CHECK(verdict->schedulable == whole->schedulable);
    CHECK(verdict->processor_load == whole->processor_load);
    REQUIRE(verdict->bus_loads.size() == whole->bus_loads.size());
    for (const BusPlace b : whole->bus_loads.ids())
      CHECK(verdict->bus_loads[b].utilization == whole->bus_loads[b].utilization);
    CHECK(verdict->requirements[0].fraction == whole->requirements[0].fraction);
    CHECK(verdict->requirements[1].value == whole->requirements[1].value);
    CHECK(verdict->chains.empty());
    CHECK(verdict->tight.trees.empty());
  }
}

TEST_CASE("the uses of the processor sum up to its load, largest first") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const auto timing = analysed(unschedulable(seed));
    REQUIRE(timing);
    double sum = 0;
    for (std::size_t i = 0; i < timing->processor.size(); ++i) {
      sum += timing->processor[i].utilization;
      if (i > 0) CHECK(timing->processor[i].utilization <= timing->processor[i - 1].utilization);
    }
    CHECK(sum == Approx(timing->processor_load));
  }
}

TEST_CASE("work is not to blame where interrupts need all the time there is") {
  Model model;
  model.tick = 1_us;
  timing::Device device;
  device.name = "a";
  device.period = 10_us;
  device.update_wcet = 1_us;
  model.devices.push_back(device);
  timing::Bus bus;
  bus.name = "loud";
  bus.frame = 100_ns;
  bus.wcet = 100_ns;
  model.buses.push_back(bus);
  AnalysisRequest request;
  request.remodel = model_remodel(model);
  Diagnostics findings;
  const auto timing = analyse(model, request, findings);
  REQUIRE(timing);
  REQUIRE(findings.size() == 1);
  const Diagnostic finding = findings.in_file_order().front();
  REQUIRE(finding.notes.size() == 3);
  CHECK(finding.notes[1].message ==
        "the processor needs 110.0 % of its time: interrupts of bus 'loud' 100.0 %, devices every 10us 10.0 %");
  CHECK(finding.notes[2].message == "interrupts alone need all of it: neither longer periods nor less work help");
  CHECK(finding.hints.empty());
}

TEST_CASE("a device below one whose period changes follows, unless it has a period of its own") {
  const Robots robot = Robots::with(R"(
    <device name="root" type="sim_load" period="10ms">
      <device name="child" type="sim_load"/>
      <device name="own" type="sim_load" period="10ms"/>
    </device>)");
  const Remodel remodel = robot_remodel(*robot.robot, robot.forest);
  const auto model = remodel({{Change::Kind::period, {robot["root"]}, {}, 20_ms}});
  REQUIRE(model);
  CHECK(model->devices[robot["root"]].period == 20_ms);
  CHECK(model->devices[robot["child"]].period == 20_ms);
  CHECK(model->devices[robot["own"]].period == 10_ms);
}

TEST_CASE("a sample that is asked for together with a command is missing for the sake of its bus") {
  Model model = Robots::with(R"(<bus name="wire" type="i2c" port="i2c2" clock="100kHz"/>
      <device name="both" type="sim_load" period="1ms"/>)")
                    .model;
  timing::Device& device = model.devices[Rank{0}];
  device.acquisition = timing::Acquisition{};
  device.acquisition->periods = 1;
  Transfer transfer;
  transfer.after = Transfer::After::handle;
  transfer.command = true;
  transfer.wire = 2_ms;
  device.transfers = {transfer};
  const auto timing = analysed(model);
  REQUIRE(timing);
  REQUIRE(timing->missing.size() == 2);
  for (const MissingBound& one : timing->missing) CHECK(one.why.rfind("bus 'wire' is overloaded", 0) == 0);
}

TEST_CASE("a message that may wait too long has a reason and a way back") {
  std::string motors;
  for (int id = 1; id <= 8; ++id)
    motors += fmt::format("<device name=\"m{}\" type=\"dji_m3508\" bus=\"can\" id=\"{}\"/>\n", id, id);
  const auto robot_with = [](const std::string& devices) {
    return Robots::with("<bus name=\"can\" type=\"can\" port=\"can1\" bitrate=\"1Mbit/s\"/>" +
                        std::string(devices.find("can2") == std::string::npos
                                        ? ""
                                        : "<bus name=\"can2\" type=\"can\" port=\"can2\" bitrate=\"1Mbit/s\"/>") +
                        "<device name=\"base\" type=\"sim_load\" period=\"1ms\">" + devices + "</device>");
  };
  const Robots robot = robot_with(motors);
  AnalysisRequest request;
  request.remodel = robot_remodel(*robot.robot, robot.forest);
  const auto timing = analysed(robot.model, request);
  REQUIRE(timing);
  REQUIRE(timing->missing.size() == 2);  // what the motors send, and what is sent to them
  const MissingBound& missing = timing->missing.front();
  CHECK(missing.part == ChainPart::acquire);
  CHECK(timing->missing.back().part == ChainPart::wire);
  CHECK(missing.chains.size() == 8);
  for (const MissingBound& one : timing->missing)
    CHECK(one.why.rfind("bus 'can' is overloaded: it needs 137.2 % of its capacity ('m1' and 7 more: 27.0 %", 0) == 0);
  REQUIRE(missing.restored_by.size() == 1);
  CHECK(missing.restored_by.front() ==
        "<bus name=\"can2\" type=\"can\" port=\"can2\" bitrate=\"1Mbit/s\"/> for 'm5', 'm6', 'm7', 'm8'");

  // Written into the file, it gives every chain its bound, and the load that the hint of the overload promises.
  std::string moved = motors;
  for (const char id : {'5', '6', '7', '8'})
    moved.replace(moved.find("bus=\"can\" id=\"" + std::string(1, id)), 9, "bus=\"can2\"");
  const auto after = analysed(robot_with(moved).model);
  REQUIRE(after);
  CHECK(after->missing.empty());
  CHECK(after->bus_loads[BusPlace{0}].utilization == Approx(0.686022));
}
