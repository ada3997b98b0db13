#include "generator/model/build.hpp"

#include "catch.hpp"
#include "generator/descriptor/library.hpp"
#include "generator/diagnostic/render.hpp"
#include "generator/xml/parse.hpp"
#include "generator/xml/read_source.hpp"
#include "source_dir.hpp"
#include "unit/duration_literals.hpp"

using namespace finemote::gen;

namespace {

const std::string kSource = finemote::test::source_dir();

/// One reading of a robot, kept together with what it points into.
struct Case {
  Sources sources;
  Diagnostics diagnostics;
  std::optional<Library> library;
  std::optional<Robot> robot;

  void read(const SourceFile* file, const std::string& input_dir) {
    library = load_library({kSource, input_dir, {}, {}}, sources, diagnostics);
    REQUIRE(library);
    const auto document = xml::parse(*file, diagnostics);
    REQUIRE(document);
    robot = build_model(*document, *library, {}, sources, diagnostics);
    INFO(render_text(diagnostics, false));
    CHECK(robot.has_value() == !diagnostics.has_errors());
  }
  void read_example(const std::string& name) {
    const SourceFile* file = xml::read_source(kSource + "/examples/" + name, sources, diagnostics, name);
    REQUIRE(file);
    read(file, kSource + "/examples");
  }
  void read_text(const std::string& inner) {
    read(sources.add(SourceFile{"robot.urdf", "", "<robot name=\"r\">" + inner + "</robot>"}), "");
  }
  [[nodiscard]] const Device& device(const std::string& name) const {
    for (const Device& candidate : robot->devices) {
      if (candidate.name.text == name) return candidate;
    }
    FAIL("no device " << name);
    return robot->devices.back();
  }
};

}  // namespace

TEST_CASE("finsrov is fourteen devices on three buses") {
  Case finsrov;
  finsrov.read_example("finsrov.urdf");
  INFO(render_text(finsrov.diagnostics, false));
  REQUIRE(finsrov.robot);
  const Robot& robot = *finsrov.robot;
  CHECK(robot.name.cpp == "FinsROV");
  CHECK(robot.tick == 1_ms);
  CHECK(robot.devices.size() == 14);
  CHECK(robot.buses.size() == 3);
  CHECK(robot.segments.size() == 3 + 5 + 1);
  CHECK(robot.joints.size() == 13);

  const Device& imu = finsrov.device("imu");
  CHECK(imu.period == 5_ms);
  CHECK(imu.role == 0U);
  const Device& baro = finsrov.device("baro_3");
  CHECK(baro.period == 10_ms);
  CHECK(baro.address == 0x76U);
  const Segment& segment = robot.segments[*baro.segment];
  CHECK(segment.kind == Segment::Kind::mux_channel);
  CHECK(segment.channel == 2);
  CHECK(robot.buses[segment.bus].name.text == "i2c");
  const Device& thruster = finsrov.device("thruster_8");
  CHECK(robot.segments[*thruster.segment].kind == Segment::Kind::pwm_expander);
  CHECK(robot.buses[robot.segments[*thruster.segment].bus].name.text == "i2c");
  CHECK(thruster.channel == 7U);
  CHECK(thruster.wcet.update == 1010_ns);
  CHECK(thruster.wcet.source == Wcet::Source::assumed);

  const Device& rov = finsrov.device("rov");
  CHECK(rov.children.size() == 13);
  REQUIRE(rov.uses.size() == 1);
  CHECK(robot.segments[*rov.uses[0].segment].name.text == "tether");
  REQUIRE(robot.requirements.size() == 2);
  CHECK(robot.requirements[0].to.size() == 8);
  CHECK(robot.requirements[0].kind == Requirement::Kind::latency_decision);
  CHECK(robot.requirements[1].max_fraction == 0.4);
}

TEST_CASE("the inputs of a robot are every file that was read") {
  Case finsrov;
  finsrov.read_example("finsrov.urdf");
  REQUIRE(finsrov.robot);
  CHECK(finsrov.robot->inputs ==
        std::vector<std::string>{
            "finsrov.urdf", "builtin:boards/robomaster_type_c.json", "builtin:chips/stm32f407.json",
            "builtin:devices/h30_imu.json", "builtin:expanders/tca9548a.json", "builtin:expanders/pca9685.json",
            "builtin:devices/finsrov.json", "builtin:devices/ms5837.json", "builtin:devices/pwm_esc.json"});
  CHECK(finsrov.robot->input_paths.size() == finsrov.robot->inputs.size());
}

TEST_CASE("blocks merge in document order, and a parent may stand further down") {
  Case merged;
  merged.read_text(R"(<link name="l"/>
    <finemote><device name="leaf-2" type="sim_load" parent="root"/></finemote>
    <finemote version="1"><board name="host"/><device name="root" type="sim_load" period="20ms"><device name="leaf 1" type="sim_load"/></device></finemote>)");
  REQUIRE(merged.robot);
  const auto& devices = merged.robot->devices;
  REQUIRE(devices.size() == 3);
  CHECK(devices[DeviceId{0}].name.cpp == "leaf_2");
  CHECK(devices[DeviceId{2}].name.cpp == "leaf_1");
  CHECK(devices[DeviceId{1}].children == std::vector<DeviceId>{DeviceId{0}, DeviceId{2}});
  CHECK(devices[DeviceId{0}].period == 20_ms);
  // 2.2 us + 10 us of the param + 300 ns for each of two children
  CHECK(devices[DeviceId{1}].wcet.update == 12'800_ns);
  CHECK(devices[DeviceId{1}].wcet.source == Wcet::Source::assumed);
}

TEST_CASE("a robot reads across trees without becoming one") {
  Case forest;
  forest.read_text(R"(<finemote version="1"><board name="host"/>
    <device name="a" type="sim_load" period="1ms"/>
    <device name="b" type="sim_load" period="2ms"><reads device="a" role="children"/></device></finemote>)");
  REQUIRE(forest.robot);
  CHECK(forest.robot->devices[DeviceId{1}].children.empty());
  REQUIRE(forest.robot->devices[DeviceId{1}].reads.size() == 1);
  CHECK(forest.robot->devices[DeviceId{1}].reads[0].device == DeviceId{0});
}

TEST_CASE("the i2c clock may be left out: the fastest of the port") {
  Case robot;
  robot.read_text(R"(<finemote version="1"><board name="host"/><bus name="i2c" type="i2c" port="i2c2"/>
    <device name="b" type="ms5837" period="20ms" bus="i2c"/></finemote>)");
  REQUIRE(robot.robot);
  CHECK(robot.robot->buses[BusId{0}].rate == 400'000);
  CHECK(robot.robot->devices[DeviceId{0}].address == 0x76U);
}

namespace {

/// A robot of two links whose joint holds this, and a device.
std::string with_joint(const std::string& inside) {
  return "<link name=\"base\"/><link name=\"tip\"/><joint name=\"j\" type=\"continuous\"><parent link=\"base\"/>"
         "<child link=\"tip\"/>" +
         inside +
         "</joint><finemote version=\"1\"><board name=\"host\"/>"
         "<device name=\"load\" type=\"sim_load\" period=\"10ms\"/></finemote>";
}

}  // namespace

TEST_CASE("an origin may turn by a quaternion, as newer URDF has it") {
  Case test;
  test.read_text(with_joint("<origin quat_xyzw=\"0 0 1 1\"/>"));  // a quarter turn about z, of any length
  REQUIRE(test.robot);
  const auto& rpy = test.robot->joints.front().origin.rpy;
  CHECK(rpy[0] == Approx(0).margin(1e-12));
  CHECK(rpy[1] == Approx(0).margin(1e-12));
  CHECK(rpy[2] == Approx(1.5707963267948966));
}

TEST_CASE("of a repeated element the first counts, with a warning, and what is not ours is no mistake") {
  Case test;
  test.read_text(with_joint("<origin xyz=\"1 0 0\"/><origin xyz=\"2 0 0\"/>"));
  REQUIRE(test.robot);
  CHECK(test.robot->joints.front().origin.xyz[0] == 1);
  CHECK(test.diagnostics.size() == 1);
  Case other;
  other.read_text(
      with_joint("<origin xyz=\"1 0 0\" rgba=\"0\"/><calibration rising=\"0\"/><safety_controller k_velocity=\"1\"/>"
                 "<drake:limit acceleration=\"1\" xmlns:drake=\"d\"/><colour/><limit effort=\"1\" velocity=\"1\" "
                 "acceleration=\"1\" deceleration=\"1\" jerk=\"1\"/>"));
  CHECK(other.diagnostics.size() == 0);
  Case robot;
  robot.read_text("<fins count=\"4\"/><remote/><final_drive/><jointed/><line name=\"a\"><point/></line>" +
                  with_joint(""));
  CHECK(robot.diagnostics.size() == 0);
}

TEST_CASE("every shipped descriptor and board is what its schema and the reader want") {
  Sources sources;
  Diagnostics diagnostics;
  auto library = load_library({kSource, "", {}, {}}, sources, diagnostics);
  REQUIRE(library);
  check_whole_library(*library, sources, diagnostics);
  CHECK(render_text(diagnostics, false).empty());
  CHECK(library->device_types.size() == library->device_files.size());
  CHECK(library->boards.size() == library->board_files.size());
}
