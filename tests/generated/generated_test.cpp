// Robots whose generated sources once did not compile, and robots of former versions.
#include <algorithm>

#include "catch.hpp"
#include "cli/order.hpp"
#include "cli/program.hpp"
#include "generated/compiler.hpp"

using namespace finemote::test;

namespace {

/// Generates and compiles for host and board; a complaint fails the test.
void check_compiles(const std::string& robot, const std::vector<std::string>& includes = {}) {
  const TemporaryFolder folder;
  const auto generated = run_finemote({"generate", robot, "-o", folder.path()});
  INFO(generated.output);
  REQUIRE(generated.exit_status == 0);
  for (const Compiler& compiler : compilers()) CHECK(complaint_about(compiler, folder.path(), includes) == "");
}

std::string robot_of(const std::string& devices) {
  return R"(<robot name="r"><link name="l"/><finemote version="1"><board name="robomaster_type_c"/>)" + devices +
         "</finemote></robot>";
}

}  // namespace

TEST_CASE("a device may read one that comes later in its tree") {
  const TemporaryFolder folder;
  write_file(folder.path("r.urdf"), robot_of(R"(<device name="root" type="group" period="5ms">
    <device name="line" type="sim_load"><reads device="tilt" role="children"/></device>
    <device name="slow" type="sim_load" period="10ms"><reads device="tilt" role="children"/></device>
    <device name="tilt" type="sim_load"><reads device="last" role="children"/>
      <device name="deep" type="sim_load" period="10ms"/></device>
    <device name="last" type="sim_load"/></device>)"));
  check_compiles(folder.path("r.urdf"));
  const auto tree = finemote_json({"tree", folder.path("r.urdf")});
  const auto run = finemote_json({"run", folder.path("r.urdf"), "--board", "host"});
  CHECK(order_mistake(tree, run) == "");  // the schedule stays that of the document
}

TEST_CASE("names of any characters do not disturb generated code") {
  const TemporaryFolder folder;
  std::string robot = read_file(source_path("tests/generated/robots/probes.urdf"));
  for (const auto& [name, instead] : {std::pair<const char*, const char*>{"probes", "a&quot;b\\"},
                                      {"oven", "oven\\"},
                                      {"plate", "pl&quot;ate\\"},
                                      {"console", "con*sole\\"},
                                      {"base", "ba&#10;se\\"},
                                      {"second", "se/cond\\"}}) {
    const std::string old = "\"" + std::string(name) + "\"";
    for (auto at = robot.find(old); at != std::string::npos; at = robot.find(old))
      robot.replace(at, old.size(), "\"" + std::string(instead) + "\"");
  }
  write_file(folder.path("r.urdf"), robot);
  const std::string devices = source_path("tests/generated/robots/devices");
  const auto generated =
      run_finemote({"generate", folder.path("r.urdf"), "-o", folder.path("out"), "--device-path", devices});
  INFO(generated.output);
  REQUIRE(generated.exit_status == 0);
  for (const Compiler& compiler : compilers()) CHECK(complaint_about(compiler, folder.path("out"), {devices}) == "");
}

TEST_CASE("a bus may be called as tables beside buses are, and a device be read twice over a link") {
  const TemporaryFolder folder;
  write_file(folder.path("r.urdf"), robot_of(R"(<bus name="i2c" type="i2c" port="i2c2" clock="400kHz"/>
    <bus name="i2c_slots" type="i2c" port="i2c3" clock="400kHz"/>
    <bus name="tether" type="uart" port="usart6" baud="460800baud"/>
    <device name="link" type="host_link" bus="tether" period="10ms">
      <device name="deep" type="ms5837" bus="i2c" address="0x76"/>
      <reads device="other" role="children"/><reads device="other" role="children"/></device>
    <device name="other" type="ms5837" bus="i2c_slots" address="0x76" period="10ms"/>)"));
  check_compiles(folder.path("r.urdf"));
}

TEST_CASE("names that generated code takes are refused") {
  const TemporaryFolder folder;
  const auto said = [&](const std::string& devices) {
    write_file(folder.path("r.urdf"), robot_of(devices));
    const auto generated = run_finemote({"generate", folder.path("r.urdf"), "-o", folder.path("out")});
    CHECK(generated.exit_status == 2);
    return generated.output;
  };
  const std::string link = R"(<bus name="tether" type="uart" port="usart6" baud="460800baud"/>
    <device name="link" type="host_link" bus="tether" period="10ms"><device name="link_up" type="sim_load"/></device>)";
  CHECK(said(link).find("error[FM3202]: the generated name 'link_up' for device 'link' is already taken\n") !=
        std::string::npos);
  CHECK(said(R"(<bus name="kBuckets" type="uart" port="usart6" baud="9600baud"/>
    <device name="a" type="sim_load" period="1ms"/>)")
            .find("error[FM3049]: the name 'kBuckets' is taken\n") != std::string::npos);
  CHECK(said(R"(<device name="a" type="group" period="1ms"><device name="stage" type="sim_load"/></device>)")
            .find("error[FM3049]: the name 'stage' is taken\n") != std::string::npos);
}

TEST_CASE("the user's device of version 0.1.0 still generates and compiles") {
  const std::string folder = source_path("tests/generated/user_device_0_1");
  check_compiles(folder + "/user_device.urdf", {folder + "/devices"});
}

TEST_CASE("a mux that is a descriptor alone and a user's expander generate, compile and run") {
  const std::string folder = source_path("tests/generated/expanders");
  check_compiles(folder + "/expanders.urdf", {folder + "/devices"});
  const auto run = finemote_json({"run", folder + "/expanders.urdf", "--duration", "300ms", "--chain", "back->both"});
  const auto& chains = run.at("chains");
  const auto chain = *std::find_if(chains.begin(), chains.end(), [](const auto& c) { return c.at("from") == "back"; });
  REQUIRE(chain.at("acquire").at("max_ns").is_number());  // read through channel 3 of the mux
  CHECK(chain.at("acquire").at("max_ns") <= chain.at("acquire").at("bound_ns"));
  CHECK(run.at("overruns") == 0);
}

TEST_CASE("types on CAN with identifiers of any form compile, and what they send is in the bounds") {
  const std::string folder = source_path("tests/generated/can_types");
  check_compiles(folder + "/can_types.urdf", {folder + "/devices"});
  const auto timing = finemote_json({"analyze", folder + "/can_types.urdf"});
  const auto& load = timing.at("bus_load").at(0);
  // Bits of the longest frames per second, at 1 Mbit/s: 135 of 8 bytes, 95 of 4. A command frame every 5 ms, which both
  // servos share; of each servo a position and a temperature; the drive and the meter.
  const std::int64_t nominal = 1000 * (135 * 200 + 2 * (135 * 200 + 95 * 10) + 2 * 135 * 100);
  CHECK(load.at("wire_ns_per_s").get<std::int64_t>() >= nominal);
  CHECK(load.at("wire_ns_per_s").get<std::int64_t>() <= nominal + nominal / 20);  // parts' clocks may be off
}

TEST_CASE("no name of a robot hides a class or an interface of the user's") {
  const std::string folder = source_path("tests/generated/can_types");
  check_compiles(folder + "/hidden_names.urdf", {folder + "/devices"});
}

TEST_CASE("the example's device runs without its params") {
  const TemporaryFolder folder;
  std::string robot = read_file(source_path("examples/user_device.urdf"));
  for (auto at = robot.find("<param "); at != std::string::npos; at = robot.find("<param "))
    robot.erase(at, robot.find("</param>", at) + 8 - at);
  write_file(folder.path("r.urdf"), robot);
  const std::string devices = source_path("examples/devices");
  const auto run = run_finemote({"run", folder.path("r.urdf"), "--board", "host", "--device-path", devices});
  INFO(run.output);
  CHECK(run.exit_status == 0);
  REQUIRE(run_finemote({"generate", folder.path("r.urdf"), "-o", folder.path("out"), "--device-path", devices})
              .exit_status == 0);
  const std::string header = read_file(folder.path("out/trees/follower.hpp"));
  CHECK(header.find("c.threshold = finemote::exact<decltype(c.threshold)>(0.5f);\n") != std::string::npos);
  CHECK(header.find("c.hold = finemote::exact<decltype(c.hold)>(50 * finemote::kMillisecond);\n") != std::string::npos);
}
