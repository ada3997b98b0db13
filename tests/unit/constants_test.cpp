// Numbers of generated code: never a text that is no number, whatever the robot.
#include "generator/emit/constants.hpp"

#include <cfloat>
#include <cmath>

#include "catch.hpp"
#include "generator/emit/number.hpp"
#include "generator/emit/value.hpp"

using namespace finemote::gen;

TEST_CASE("a number that no float holds is never written") {
  for (const double value : {double{INFINITY}, -double{INFINITY}, std::nan(""), 1e39, -1e308, 3.5e38})
    CHECK_THROWS_AS(float_literal(value), NoFloat);
  CHECK(float_literal(static_cast<double>(FLT_MAX)) == "3.40282347e+38f");
  CHECK(float_literal(-1e-300) == "0.0f");
  CHECK(float_literal(2) == "2.0f");
}

TEST_CASE("a number that a person wrote is no rounding error") {
  CHECK(given_float_literal(1e-30) == "1e-30f");
  CHECK(given_float_literal(-0.0) == "0.0f");
  CHECK(float_literal(1e-30) == "0.0f");
}

TEST_CASE("a text is a literal of the same text, whatever it holds") {
  CHECK(string_literal("plain? sch\u00f6n") == "\"plain? sch\u00f6n\"");
  CHECK(string_literal("\"\\") == R"("\"\\")");
  CHECK(string_literal("?\?/ ?\?=?\?\?") == R"("?\?/ ?\?=?\?\?")");  // no trigraphs
  CHECK(string_literal("a\nb\t1") == R"("a\012b\0111")");
  CHECK(string_literal("a\u202eb") == R"("a\342\200\256b")");  // turns the direction of writing
}

TEST_CASE("a constant with such a number is an error at its device") {
  DeviceType mount;
  mount.geometry.resize(1);
  mount.geometry[0].kind = "range";
  mount.geometry[0].param = "travel";
  ParamSpec travel;
  travel.name = "travel";
  Robot robot;
  robot.links = {{"base", {}, {}}, {"head", {}, {}}};
  Joint joint;
  joint.name = "pan";
  joint.type = "revolute";
  joint.lower = -1e308;
  joint.upper = 1;
  robot.joints = {joint};
  Device device;
  device.name = {"servo", "servo"};
  device.type = &mount;
  device.joint = "pan";
  device.params = {{&travel, 1e308, true}};
  robot.devices = {device};
  Forest forest;
  forest.order = {DeviceId{0}};
  const Schedule schedule;
  Diagnostics diagnostics;
  CHECK(make_constants({robot, forest, schedule}, diagnostics).empty());
  REQUIRE(diagnostics.size() == 1);
  CHECK(diagnostics.has_errors());
  const Diagnostic finding = diagnostics.in_file_order().front();
  CHECK(finding.code.number == 2016);
  CHECK(finding.message == "the constant 'servo_range' of device 'servo' holds -5e+307, which no float holds");
}
