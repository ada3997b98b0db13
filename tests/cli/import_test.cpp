// finemote import: robots as people describe them for ros2_control become robots that generate firmware.
#include <fmt/format.h>

#include <functional>

#include "catch.hpp"
#include "cli/program.hpp"

using namespace finemote::test;

namespace {

std::string joint(const std::string& name, const std::string& type, const std::string& inner = {}) {
  return fmt::format(R"(<link name="{0}_link"/><joint name="{0}" type="{1}"><parent link="base_link"/>)"
                     R"(<child link="{0}_link"/><axis xyz="0 0 1"/>)"
                     R"(<limit lower="-1" upper="1" effort="9" velocity="9"/>{2}</joint>)",
                     name, type, inner);
}

std::string takes(const std::string& name, const std::vector<std::string>& commands) {
  std::string text = fmt::format(R"(<joint name="{}">)", name);
  for (const std::string& command : commands) text += fmt::format(R"(<command_interface name="{}"/>)", command);
  return text + R"(<state_interface name="position"/><state_interface name="velocity"/></joint>)";
}

struct Robot {
  const char* kind;
  std::string parts, hardware;
  std::size_t devices;
  std::vector<std::string> lacking;  ///< words of it, beside the execution times
};

std::string numbered(int count, const std::function<std::string(int)>& one) {
  std::string text;
  for (int i = 1; i <= count; ++i) text += one(i);
  return text;
}

const std::string kPlugin = "<hardware><plugin>a_robot/System</plugin><param name=\"port\">/dev/x</param></hardware>";

std::vector<Robot> robots() {
  const auto arm_joint = [](int i) { return joint("joint_" + std::to_string(i), "revolute"); };
  const auto arm_command = [](int i) { return takes("joint_" + std::to_string(i), {"position", "velocity"}); };
  return {
      {"two joints with positions",
       joint("joint1", "continuous") + joint("joint2", "revolute"),
       "<ros2_control name=\"RRBot\" type=\"system\">" + kPlugin + takes("joint1", {"position"}) +
           takes("joint2", {"position"}) + "</ros2_control>",
       3,
       {}},
      {"two wheels",
       joint("left_wheel_joint", "continuous") + joint("right_wheel_joint", "continuous"),
       "<ros2_control name=\"DiffBot\" type=\"system\" rw_rate=\"50\">" + kPlugin +
           takes("left_wheel_joint", {"velocity"}) + takes("right_wheel_joint", {"velocity"}) + "</ros2_control>",
       3,
       {}},
      {"an arm with a gripper of two fingers, and what is at its tip",
       numbered(6, arm_joint) + joint("finger", "prismatic") +
           joint("other_finger", "prismatic", "<mimic joint=\"finger\"/>"),
       "<ros2_control name=\"arm\" type=\"system\" rw_rate=\"500\">" + kPlugin + numbered(6, arm_command) +
           "<sensor name=\"tcp_fts_sensor\"><state_interface name=\"force.z\"/></sensor>"
           "<gpio name=\"flange\"><command_interface name=\"digital_out\"/></gpio></ros2_control>"
           "<ros2_control name=\"gripper\" type=\"actuator\">" +
           kPlugin + takes("finger", {"position"}) + takes("other_finger", {"position"}) + "</ros2_control>",
       7,
       {"sensor 'tcp_fts_sensor' of hardware 'arm'", "gpio 'flange' of hardware 'arm'",
        "joint 'finger' of hardware 'gripper': it is prismatic, and nothing here moves that", "hardware 'gripper'"}},
      {"more motors than two buses take, and an attitude sensor",
       numbered(18, [](int i) { return joint("leg" + std::to_string(i), "revolute"); }),
       "<ros2_control name=\"walker\" type=\"system\" rw_rate=\"400\">" + kPlugin +
           numbered(18, [](int i) { return takes("leg" + std::to_string(i), {"effort"}); }) +
           "<sensor name=\"imu\"><state_interface name=\"orientation.x\"/></sensor></ros2_control>",
       18,
       {"joint 'leg17'", "joint 'leg18'"}},
      {"a vehicle under water",
       numbered(8, [](int i) { return joint("joint_of_the_thruster_number_" + std::to_string(i), "revolute"); }),
       "<ros2_control name=\"sub\" type=\"system\">" + kPlugin +
           numbered(8, [](int i) { return takes("joint_of_the_thruster_number_" + std::to_string(i), {"thrust"}); }) +
           "</ros2_control>",
       9,
       {}},
      {"joints that are none, a plugin that decides by itself, and a gear",
       joint("pan", "revolute") + joint("wheel", "continuous"),
       "<ros2_control name=\"arm\" type=\"system\">" + kPlugin + takes("pan", {"position"}) + takes("gpio", {"io_1"}) +
           "<joint name=\"status\"><state_interface name=\"ready\"/></joint>"
           "<joint name=\"wheel\"><param name=\"node_id\">0</param></joint>"
           "<transmission name=\"gear\"><plugin>SimpleTransmission</plugin><joint name=\"pan\" role=\"joint1\"/>"
           "</transmission></ros2_control>",
       2,
       {"joint 'gpio' of hardware 'arm': the robot has no such joint",
        "joint 'wheel' of hardware 'arm': what it takes, as it names no interface",
        "transmission 'gear' of hardware 'arm': its reduction and offset"}},
      {"an actuator for each joint, run by a thread of its own",
       joint("a/joint 1", "revolute") + joint("a/joint-2", "revolute"),
       "<ros2_control name=\"a/joint 1\" type=\"actuator\" is_async=\"true\" thread_priority=\"30\" "
       "rw_rate=\"333.3\">" +
           kPlugin + takes("a/joint 1", {"velocity"}) +
           "</ros2_control><ros2_control name=\"a/joint-2\" type=\"actuator\" rw_rate=\"0\">" + kPlugin +
           takes("a/joint-2", {"velocity"}) + "</ros2_control>",
       4,
       {}},
      {"wheels that steer, with an attitude sensor of few interfaces and a laser",
       numbered(4, [](int i) { return joint(fmt::format("steer_{}", i), "revolute"); }) +
           numbered(4, [](int i) { return joint(fmt::format("drive_{}", i), "continuous"); }),
       "<ros2_control name=\"rover\" type=\"system\" rw_rate=\"100\">" + kPlugin +
           numbered(4, [](int i) { return takes(fmt::format("steer_{}", i), {"position"}); }) +
           numbered(4, [](int i) { return takes(fmt::format("drive_{}", i), {"velocity"}); }) +
           "<sensor name=\"imu\"><param name=\"frame_id\">imu_link</param><state_interface "
           "name=\"angular_velocity.x\"/>"
           "</sensor><sensor name=\"laser\"><state_interface name=\"range\"/></sensor></ros2_control>",
       10,
       {"sensor 'laser' of hardware 'rover'"}},
      {"a hand of more fingers than one driver has channels, one of which follows by the old way to say so",
       numbered(17, [](int i) { return joint(fmt::format("finger_{}", i), "revolute"); }) + joint("tip", "revolute"),
       "<ros2_control name=\"hand\" type=\"system\">" + kPlugin +
           numbered(17,
                    [](int i) {
                      return takes(fmt::format("finger_{}", i), {"position", "kp", "kd"});
                    }) +
           "<joint name=\"tip\"><param name=\"mimic\">finger_1</param><param name=\"multiplier\">2</param>"
           "<command_interface name=\"position\"/></joint></ros2_control>",
       18,
       {}},
      {"a simulator that knows the joints from elsewhere, and a sensor alone",
       joint("pan", "revolute"),
       "<ros2_control name=\"simulated\" type=\"system\">" + kPlugin +
           "</ros2_control><ros2_control name=\"wrist\" type=\"sensor\">" + kPlugin +
           "<sensor name=\"force\"><state_interface name=\"force.x\"/></sensor></ros2_control>"
           "<ros2_control name=\"real\" type=\"system\">" +
           kPlugin + takes("pan", {"position"}) + "</ros2_control>",
       2,
       {"hardware 'simulated'", "sensor 'force' of hardware 'wrist'", "hardware 'wrist'"}},
      {"a joint that two hardwares drive, one that nothing could, and commands without a name",
       joint("pan", "revolute") + joint("floor", "planar") + joint("lift", "revolute") + joint("tilt", "revolute"),
       "<ros2_control name=\"real\" type=\"system\">" + kPlugin + takes("pan", {"velocity"}) +
           takes("floor", {"velocity"}) + takes("lift", {"acceleration"}) +
           "<joint name=\"tilt\"><command_interface/></joint></ros2_control>"
           "<ros2_control name=\"real\" type=\"system\">" +
           kPlugin + takes("pan", {"velocity"}) + "</ros2_control>",
       2,
       {"joint 'floor' of hardware 'real': it is planar", "'lift' of hardware 'real': nothing here takes the command",
        "joint 'tilt' of hardware 'real': what it takes, as it names no interface",
        "joint 'pan' of hardware 'real': another device drives it already", "hardware 'real'"}},
  };
}

}  // namespace

TEST_CASE("robots of ros2_control become robots that generate firmware, or say what they lack") {
  for (const Robot& robot : robots()) {
    INFO(robot.kind);
    const TemporaryFolder folder;
    const std::string given = folder.path("robot.urdf"), whole = folder.path("whole.urdf"), out = folder.path("out");
    write_file(given, "<?xml version=\"1.0\"?>\n<robot name=\"r\">\n<link name=\"base_link\"/>" + robot.parts +
                          robot.hardware + "\n</robot>\n");
    const auto document = finemote_json({"import", given, "-o", whole});
    REQUIRE(document.at("lacking").size() == robot.lacking.size() + 1);
    for (std::size_t i = 0; i < robot.lacking.size(); ++i)
      CHECK(document.at("lacking")[i].get<std::string>().find(robot.lacking[i]) != std::string::npos);
    const auto generated = run_finemote({"generate", whole, "-o", out, "--allow-unschedulable"});
    INFO(generated.output);
    CHECK(generated.exit_status == 0);
    CHECK(finemote_json({"analyze", whole}).at("model").at("devices").size() == robot.devices);
    CHECK(run_finemote({"fmt", whole, "--dry-run"}).output.empty());
    CHECK(run_finemote({"import", whole}).exit_status == 2);
  }
}

TEST_CASE("sensors stand before what they command, at the link that ROS names") {
  const TemporaryFolder folder;
  write_file(folder.path("robot.urdf"),
             "<robot name=\"r\"><link name=\"base_link\"/><link name=\"imu_link\"/>"
             "<joint name=\"imu_joint\" type=\"fixed\"><parent link=\"base_link\"/>"
             "<child link=\"imu_link\"/></joint>" +
                 joint("wheel", "continuous") + "<ros2_control name=\"base\" type=\"system\">" + kPlugin +
                 takes("wheel", {"velocity"}) +
                 "<sensor name=\"imu\"><param name=\"frame_id\"> imu_link </param>"
                 "<state_interface name=\"orientation.x\"/></sensor>"
                 "</ros2_control></robot>\n");
  const auto element = finemote_json({"import", folder.path("robot.urdf"), "-o", folder.path("whole.urdf")});
  const std::string text = element.at("text");
  CHECK(text.find("type=\"h30_imu\" bus=\"attitude_uart\" link=\"imu_link\"/>") != std::string::npos);
  CHECK(text.find("name=\"imu\"") < text.find("name=\"wheel\""));
  const auto lint = run_finemote({"lint", folder.path("whole.urdf")});
  INFO(lint.output);
  CHECK(lint.output.find("FM3151") == std::string::npos);
}

TEST_CASE("import reads what xacro makes of a file, and the element goes into the file itself") {
  const TemporaryFolder folder;
  write_file(folder.path("hardware.xacro"), R"x(<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="hardware" params="name rate"><ros2_control name="${name}" type="system" rw_rate="${rate}">
    <joint name="wheel"><command_interface name="velocity"/></joint></ros2_control></xacro:macro></robot>)x");
  write_file(folder.path("robot.urdf.xacro"), R"x(<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="rate" default="100"/><xacro:include filename="hardware.xacro"/>
  <link name="base_link"/>)x" + joint("wheel", "continuous") +
                                                  R"x(<xacro:hardware name="base" rate="$(arg rate)"/>
</robot>
)x");
  const std::string whole = folder.path("whole.urdf.xacro");
  const auto said = run_finemote({"import", folder.path("robot.urdf.xacro"), "rate:=50", "-o", whole});
  CHECK(said.exit_status == 0);
  CHECK(read_file(whole).find("<xacro:hardware name=\"base\"") != std::string::npos);
  CHECK(read_file(whole).find("<device name=\"base\" type=\"group\" period=\"20ms\">") != std::string::npos);
  CHECK(run_finemote({"generate", whole, "-o", folder.path("out")}).exit_status == 0);
}
