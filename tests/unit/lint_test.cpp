#include "generator/lint/lint.hpp"

#include "catch.hpp"
#include "generator/descriptor/library.hpp"
#include "generator/diagnostic/render.hpp"
#include "generator/model/build.hpp"
#include "generator/xml/parse.hpp"
#include "generator/xml/read_source.hpp"
#include "source_dir.hpp"

using namespace finemote::gen;

namespace {

const std::string kSource = finemote::test::source_dir();

/// A robot, what lint says of it, and its text after the edits.
struct Linted {
  Sources sources;
  Diagnostics diagnostics;
  std::optional<Library> library;
  std::optional<Robot> robot;
  std::string said, mended, reasons;

  explicit Linted(const std::string& inner, const LintOptions& options = {}) {
    read(sources.add(SourceFile{
             "r.urdf", "",
             "<robot name=\"r\"><finemote version=\"1\"><board name=\"host\"/>\n" + inner + "</finemote></robot>\n"}),
         options);
  }
  void read(const SourceFile* file, const LintOptions& options) {
    library = load_library({kSource, "", {}, {}}, sources, diagnostics);
    const auto document = xml::parse(*file, diagnostics);
    REQUIRE(document);
    robot = build_model(*document, *library, {}, sources, diagnostics);
    INFO(render_text(diagnostics, false));
    REQUIRE(robot);
    std::vector<Edit> edits;
    for (const Fix& fix : lint(*robot, options, diagnostics)) {
      edits.insert(edits.end(), fix.change.edits.begin(), fix.change.edits.end());
      reasons += fix.change.reason;
    }
    mended = apply_edits(*file, edits);
    said = render_text(diagnostics, false);
  }
  [[nodiscard]] bool says(const std::string& words) const { return said.find(words) != std::string::npos; }
};

const std::string kWcet = "<wcet update=\"1us\" handle=\"1us\"/>";
const std::string kPwm =
    "<bus name=\"i2c\" type=\"i2c\" port=\"i2c2\"/>\n<expander name=\"pwm\" model=\"pca9685\" bus=\"i2c\" "
    "address=\"0x40\"/>\n";

}  // namespace

TEST_CASE("lint finds nothing in a robot that is well") {
  const Linted robot("<device name=\"a\" type=\"sim_load\" period=\"10ms\">" + kWcet + "</device>\n");
  CHECK(robot.said.empty());
}

TEST_CASE("a sensor behind actuators is found and moved, with its comments and layout around it kept") {
  const std::string actuator =
      "  <device name=\"esc\" type=\"pwm_esc\" bus=\"pwm\" channel=\"0\">" + kWcet + "</device>\n";
  const std::string sensor =
      "  <device name=\"baro\" type=\"ms5837\" bus=\"i2c\">\n    " + kWcet + " <!-- a > b -->\n  </device>\n";
  const std::string head = kPwm + "<device name=\"root\" type=\"group\" period=\"20ms\">\n" + kWcet + "\n";
  const Linted robot(head + actuator + "  <!-- goes along -->\n" + sensor + "</device>\n");
  CHECK(robot.says("warning[FM3151]: sensor 'baro' is declared after actuator 'esc'"));
  CHECK(robot.mended.find(head + "  <!-- goes along -->\n" + sensor + actuator + "</device>\n") != std::string::npos);
  const Linted well(head + sensor + actuator + "</device>\n");
  CHECK(well.said.empty());
}

TEST_CASE("periods that do not divide each other") {
  const auto with = [](const std::string& period) {
    return "<device name=\"root\" type=\"group\" period=\"10ms\">" + kWcet +
           "<device name=\"a\" type=\"sim_load\" period=\"" + period + "\">" + kWcet + "</device></device>\n";
  };
  const Linted robot(with("4ms"));
  CHECK(robot.says(
      "warning[FM3152]: the period of device 'a' (4ms) is neither a multiple nor a divisor of its parent's (10ms)"));
  CHECK(robot.says("hint: for example period=\"5ms\""));
  CHECK(Linted(with("25ms")).says("hint: for example period=\"20ms\""));
  CHECK(Linted(with("5ms")).said.empty());
  CHECK(Linted(with("30ms")).said.empty());
}

TEST_CASE("a device without wcet says what is assumed") {
  const Linted robot("<device name=\"a\" type=\"sim_load\" period=\"10ms\"/>\n");
  CHECK(robot.says("warning[FM3153]: device 'a' has no <wcet>"));
  CHECK(robot.says("update 12200ns and handle 11200ns are assumed"));
}

TEST_CASE("a conversion longer than the period") {
  const auto with = [](const std::string& oversampling) {
    return "<bus name=\"i2c\" type=\"i2c\" port=\"i2c2\"/><device name=\"a\" type=\"ms5837\" bus=\"i2c\" "
           "period=\"5ms\">" +
           kWcet + "<param name=\"oversampling\">" + oversampling + "</param></device>\n";
  };
  const Linted robot(with("8192"));
  CHECK(robot.says("warning[FM3154]: a conversion of device 'a' takes 18080us, longer than its period of 5ms"));
  CHECK(robot.says("write period=\"19ms\" or longer"));
  CHECK(Linted(with("1024")).said.empty());
}

TEST_CASE("a bus above its load, by the figures of the timing analysis") {
  LintOptions options;
  options.bus_load = {0.81};
  const std::string text =
      kPwm + "<device name=\"a\" type=\"pwm_esc\" bus=\"pwm\" channel=\"0\" period=\"5ms\">" + kWcet + "</device>\n";
  CHECK(Linted(text, options).says("warning[FM3155]: bus 'i2c' is busy for 81 % of the time"));
  options.bus_load = {0.7};
  CHECK(Linted(text, options).said.empty());
}

TEST_CASE("an overload of the same line is that of another bus where it came through another macro call") {
  const std::string text =
      kPwm + "<device name=\"a\" type=\"pwm_esc\" bus=\"pwm\" channel=\"0\" period=\"5ms\">" + kWcet + "</device>\n";
  Linted robot(text);
  LintOptions options;
  options.bus_load = {0.81};
  Diagnostic overload;
  overload.code = code::timing_bus_overload;
  overload.at = (*robot.robot->buses.begin()).at;
  overload.message = "bus 'i2c' is overloaded";
  options.overloads.push_back(overload);
  const auto says = [&](const char* words) {
    Diagnostics diagnostics;
    lint(*robot.robot, options, diagnostics);
    return render_text(diagnostics, false).find(words) != std::string::npos;
  };
  CHECK(says("bus 'i2c' is overloaded"));
  CHECK_FALSE(says("bus 'i2c' is busy"));
  const Expansion other;
  options.overloads.front().at.via = &other;
  CHECK(says("bus 'i2c' is busy for 81 % of the time"));
}

TEST_CASE("a bus nobody uses is found and removed, line and all") {
  const std::string device = "<device name=\"a\" type=\"sim_load\" period=\"10ms\">" + kWcet + "</device>\n";
  const Linted robot("  <bus name=\"spare\" type=\"uart\" port=\"usart6\" baud=\"115200baud\"/>\n" + device);
  CHECK(robot.says("warning[FM3156]: bus 'spare' is unused"));
  CHECK(robot.mended.find("<board name=\"host\"/>\n" + device) != std::string::npos);
}

TEST_CASE("codes can be allowed and denied") {
  LintOptions options;
  options.allow = {code::lint_no_wcet};
  const std::string text = "<device name=\"a\" type=\"sim_load\" period=\"10ms\"/>\n";
  CHECK(Linted(text, options).said.empty());
  options = {};
  options.deny = {code::lint_no_wcet};
  const Linted denied(text, options);
  CHECK(denied.says("error[FM3153]"));
  CHECK(denied.diagnostics.has_errors());
}
