// Where chains begin and end: whose data reach a command, and where a command comes out.
#include "generator/timing/operands.hpp"
#include "unit/duration_literals.hpp"
#include "unit/timing_random.hpp"
#include "unit/timing_robots.hpp"

using namespace finemote::gen;
using namespace finemote::gen::timing;

namespace {

using Names = std::vector<std::string>;

const std::string kTether = "<bus name=\"tether\" type=\"uart\" port=\"usart6\" baud=\"115200baud\"/>";
const std::string kEsc = "<bus name=\"esc\" type=\"pwm\" port=\"pwm1\"/>";
const std::string kImu = "<bus name=\"imu_uart\" type=\"uart\" port=\"usart1\" baud=\"921600baud\"/>";
const std::string kKey = "<device name=\"key\" type=\"key\"><use role=\"line\" pin=\"key\"/></device>";
const std::string kRover =
    "<bus name=\"sticks\" type=\"uart\" port=\"usart3\" baud=\"100000baud\"/>"
    "<bus name=\"can\" type=\"can\" port=\"can1\"/>"
    "<device name=\"remote\" type=\"dr16\" bus=\"sticks\" period=\"20ms\"/>"
    "<device name=\"chassis\" type=\"group\" period=\"10ms\"><reads device=\"remote\" role=\"children\"/>"
    "<device name=\"left\" type=\"group\"><device name=\"left_motor\" type=\"dji_m3508\" bus=\"can\" "
    "id=\"1\"/></device>"
    "<device name=\"right\" type=\"group\"><device name=\"right_motor\" type=\"dji_m3508\" bus=\"can\" "
    "id=\"2\"/></device>"
    "</device>";

/// `a->b` of every chain, in the order of the result.
Names ends(const Timing& timing) {
  Names list;
  for (const ChainResult& c : timing.chains)
    list.push_back(timing.model.devices[c.from].name + "->" + timing.model.devices[c.to].name);
  return list;
}

Names default_chains(const Robots& robot) {
  Diagnostics diagnostics;
  const auto timing = analyse(robot.model, {}, diagnostics);
  INFO(render_text(diagnostics, false));
  REQUIRE(timing);
  return ends(*timing);
}

}  // namespace

TEST_CASE("what a link sends up is no source of the commands it brings down") {
  const Robots robot =
      Robots::with(kTether + kEsc + "<device name=\"link\" type=\"host_link\" bus=\"tether\" period=\"10ms\">" + kKey +
                   "<device name=\"thruster\" type=\"pwm_esc\" bus=\"esc\"/></device>");
  CHECK(default_chains(robot) == Names{"link->thruster"});
  Diagnostics diagnostics;
  AnalysisRequest request;
  request.chains = {{robot["key"], robot["thruster"]}};
  CHECK_FALSE(analyse(robot.model, request, diagnostics));
  REQUIRE(diagnostics.size() == 1);
  CHECK(diagnostics.in_file_order().front().message == "no data leads from 'key' to 'thruster'");
  diagnostics = {};
  request.chains = {{robot["key"], robot["link"]}};  // its data do get as far as the link
  CHECK(analyse(robot.model, request, diagnostics));
}

TEST_CASE("a link of sensors alone ends at the link") {
  const Robots robot = Robots::with(
      kTether + "<device name=\"link\" type=\"host_link\" bus=\"tether\" period=\"10ms\">" + kKey + "</device>");
  CHECK(default_chains(robot) == Names{"link->link"});
}

TEST_CASE("below a link, sensors and the link itself are sources of a composite's actuators") {
  const auto body = [](const char* link_period) {
    return Robots::with(kTether + kEsc + kImu + "<device name=\"link\" type=\"host_link\" bus=\"tether\" period=\"" +
                        link_period +
                        "\"><device name=\"body\" type=\"group\" period=\"10ms\">"
                        "<device name=\"imu\" type=\"h30_imu\" bus=\"imu_uart\" period=\"10ms\"/>"
                        "<device name=\"thruster\" type=\"pwm_esc\" bus=\"esc\"/></device>" +
                        kKey + "</device>");
  };
  CHECK(default_chains(body("10ms")) == Names{"link->thruster"});  // its frames are the older ones
  const Robots robot = body("10ms");
  Diagnostics diagnostics;
  AnalysisRequest request;
  request.chains = {{robot["imu"], robot["thruster"]}};
  CHECK(analyse(robot.model, request, diagnostics));
  request.chains = {{robot["key"], robot["thruster"]}};
  CHECK_FALSE(analyse(robot.model, request, diagnostics));
}

TEST_CASE("a remote control that a tree reads is a source of its commands") {
  const Robots robot = Robots::with(kRover);
  CHECK(default_chains(robot) == Names{"remote->remote", "remote->left_motor", "remote->right_motor"});
}

TEST_CASE("a requirement that ends in composites is asked of their actuators, wire included") {
  const Robots robot = Robots::with(kRover +
                                    "<require latency=\"remote -> chassis.children\" max=\"1ms\"/>"
                                    "<require latency=\"remote -> chassis\" max=\"1s\"/>");
  AnalysisRequest request;
  request.requirements = timing_requirements(*robot.robot, robot.forest);
  Diagnostics diagnostics;
  const auto timing = analyse(robot.model, request, diagnostics);
  REQUIRE(timing);
  REQUIRE(timing->requirements.size() == 2);
  const ChainResult& motor = chain(*timing, "remote", "right_motor");
  REQUIRE(motor.wire);
  CHECK(*motor.wire > 100_us);  // a frame of eight bytes at 1 Mbit/s
  for (const RequirementResult& r : timing->requirements) {
    CHECK(r.requirement.to == std::vector<Rank>{robot["left_motor"], robot["right_motor"]});
    REQUIRE(r.value);
    CHECK(*r.value >= *motor.end_to_end);
  }
  CHECK_FALSE(timing->requirements[0].ok);
  CHECK(timing->requirements[1].ok);
}

TEST_CASE("a chain may name a role, as a requirement may") {
  const Robots robot = Robots::with(kRover);
  Diagnostics diagnostics;
  const auto pairs = [&](const std::string& text) {
    Names list;
    for (const ChainRequest& c : parse_chains(robot.model, {text}, diagnostics))
      list.push_back(robot.model.devices[c.from].name + "->" + robot.model.devices[c.to].name);
    return list;
  };
  CHECK(pairs("remote->chassis.children") == Names{"remote->left_motor", "remote->right_motor"});
  CHECK(pairs("left.children -> right") == Names{"left_motor->right"});
  CHECK(diagnostics.size() == 0);
  CHECK(pairs("remote -> chassis.child").empty());
  CHECK(pairs("remote -> chasis.children").empty());
  REQUIRE(diagnostics.size() == 2);
  CHECK(diagnostics.in_file_order()[0].message == "there is no device 'chasis'");
  CHECK(diagnostics.in_file_order()[1].message == "device 'chassis' has no child in the role 'child'");
}

TEST_CASE("default chains are the oldest of all sources that are connected, on random forests") {
  std::size_t ended = 0;
  for (std::uint64_t seed = 0; seed < 120; ++seed) {
    RandomForest random(seed);
    Model model = random.make(kForestClasses[seed % 4]);
    random.observe(model);
    Random choice(seed + 1000);
    for (const Rank d : model.devices.ids()) {
      const auto parent = model.devices[d].parent;
      if (choice.one_in(6)) {
        timing::Acquisition& acquisition = model.devices[d].acquisition.emplace();
        acquisition.fixed = choice.between({}, 90_ns);
        acquisition.interval = choice.between({}, 90_ns);
      }
      if (parent && choice.one_in(4)) model.devices[*parent].ends_here.push_back(d), ++ended;
      for (const Rank observed : model.devices[d].reads) {
        if (choice.one_in(4)) model.devices[d].ends_here.push_back(observed);
      }
    }
    const Topology topology = make_topology(model);
    const ProfileAnalysis tight = analyse_profile(model, topology, Profile::tight);
    Effort effort;
    const WireAnalysis wire(model, tight, effort);
    const ChainAnalysis chains(model, topology, tight, wire, wire.acquisitions(), effort);
    for (const ChainResult& found : chains.defaults()) {
      INFO("seed " << seed << ", to " << model.devices[found.to].name);
      CHECK(chains.connected(found.from, found.to));
      const auto age = [](const ChainResult& c) { return c.acquire && c.decide ? *c.acquire + *c.decide : kNever; };
      Duration oldest;
      for (const Rank from : model.devices.ids()) {
        const bool is_source = topology.children[from].empty() || model.devices[from].acquisition;
        if (is_source && chains.connected(from, found.to)) oldest = std::max(oldest, age(chains.bound(from, found.to)));
      }
      CHECK(age(found) == oldest);
    }
  }
  CHECK(ended > 30);
}
