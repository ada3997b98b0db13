// Plans to C++: holes of templates, values, names, and the files of a small robot.
#include <algorithm>
#include <filesystem>
#include <fstream>

#include "catch.hpp"
#include "generator/emit/config.hpp"
#include "generator/emit/names.hpp"
#include "generator/emit/render.hpp"
#include "generator/emit/scope.hpp"
#include "generator/emit/template.hpp"
#include "generator/emit/value.hpp"
#include "generator/tasks/from_robot.hpp"
#include "source_dir.hpp"
#include "tests/temporary_folder.hpp"
#include "unit/robot_plan.hpp"

using namespace finemote::gen;
namespace fs = std::filesystem;

namespace {

/// Where the templates are that include each other.
const finemote::test::TemporaryFolder& templates() {
  static const finemote::test::TemporaryFolder folder;
  return folder;
}

/// A template with this text, for as long as the object lives.
class TemplateFile {
 public:
  explicit TemplateFile(const std::string& text, std::string name = "template.in") : name_(std::move(name)) {
    std::ofstream(templates().path(name_), std::ios::binary) << text;
  }
  TemplateFile(const TemplateFile&) = delete;
  TemplateFile& operator=(const TemplateFile&) = delete;
  ~TemplateFile() { fs::remove(templates().path(name_)); }
  [[nodiscard]] std::string fill(const Data& data) const { return Templates(templates().path()).fill(name_, data); }

 private:
  std::string name_;
};

std::string filled(const std::string& text, const Data& data) { return TemplateFile(text).fill(data); }

/// What the shipped template makes of a Config.
std::string config_of(const std::string& cpp_class, const std::vector<Param>& params, bool is_shipped) {
  Data data;
  set_config(cpp_class, params, is_shipped, data);
  std::string text = Templates(finemote::test::source_dir() + "/templates").fill("config.mustache", data);
  text.erase(std::remove(text.begin(), text.end(), '\n'), text.end());  // as inside of a line
  return text;
}

ParamSpec spec_of(const std::string& name, ParamKind kind, Unit unit = Unit::none) {
  ParamSpec spec;
  spec.name = name;
  spec.kind = kind;
  spec.unit = unit;
  return spec;
}

/// The files of a robot, by name.
struct Rendered {
  RobotPlan planned;
  std::vector<OutputFile> files;

  explicit Rendered(const std::string& inner) : planned(inner) {
    const Plan plan{*planned.robot, planned.forest, planned.schedule};
    timing::AnalysisRequest request;
    request.inputs = true;
    const auto model = timing::make_timing_model(plan.robot, plan.forest, plan.schedule, planned.diagnostics).value();
    const auto timing = timing::analyse(model, request, planned.diagnostics);
    const ProvenBounds bounds{timing::robot_bounds(timing, plan.forest, plan.schedule),
                              timing::instrumented_bounds(plan.robot, plan.forest, plan.schedule)};
    files = render_files(plan, bounds, finemote::test::source_dir(), planned.diagnostics);
  }
  [[nodiscard]] std::string operator[](const std::string& name) const {
    for (const OutputFile& file : files) {
      if (file.name == name) return file.text;
    }
    throw std::invalid_argument("no file " + name);
  }
};

std::string load(const std::string& name, const std::string& period, const std::string& inner = {}) {
  return "<device name=\"" + name + "\" type=\"sim_load\" period=\"" + period + "\">" + inner + "</device>\n";
}

/// Whether the words stand in the text, in this order.
bool in_order(const std::string& text, const std::vector<std::string>& words) {
  std::size_t at = 0;
  for (const std::string& word : words) {
    at = text.find(word, at);
    if (at == std::string::npos) return false;
    at += word.size();
  }
  return true;
}

}  // namespace

TEST_CASE("a template's holes are filled with the text as it is") {
  CHECK(filled("a {{x}} b\n", Data("x", "<&>\"")) == "a <&>\" b\n");
  Data data;
  data.set("lines", text_list({"one", "two"}));
  CHECK(filled("{{#lines}}\n  {{text}};\n{{/lines}}\n", data) == "  one;\n  two;\n");
}

TEST_CASE("a section of an empty list, or of what is false, leaves no second blank line") {
  Data data;
  data.set("lines", Data(Data::type::list));
  data.set("on", Data(Data::type::bool_false));
  CHECK(filled("a\n\n{{#lines}}\n{{text}}\n{{/lines}}\n\n{{#on}}\nx\n{{/on}}\n\nb\n", data) == "a\n\nb\n");
}

TEST_CASE("a hole that nobody fills is a bug, and names itself") {
  CHECK_THROWS_WITH(filled("{{y}}\n", Data("x", "1")),
                    "template template.in names 'y', which the emitter does not provide");
  CHECK_THROWS_WITH(Templates("/nowhere").fill("t.in", Data("x", "1")),
                    "cannot read '/nowhere/t.in', which belongs to finemote");
}

TEST_CASE("a tag without an end is a bug, and names itself") {
  CHECK_THROWS_WITH(filled("a {{x\n", Data("x", "1")), "a template has '{{' without '}}'");
  CHECK_THROWS_AS(filled("{{#x}}a\n", Data("x", true)), std::logic_error);
}

TEST_CASE("every element of a list is looked at for what a template names") {
  Data list(Data::type::list), data;
  list.push_back(Data("text", "one"));
  list.push_back(Data("other", "two"));
  data.set("lines", list);
  CHECK_THROWS_WITH(filled("{{#lines}}{{text}}{{/lines}}\n", data),
                    "template template.in names 'text', which the emitter does not provide");
}

TEST_CASE("of three braces the first is one of C++") {
  Data data("x", "1");
  data.set("y", "2");
  CHECK(filled("A a{{{x}}, {{y}}};\n", data) == "A a{1, 2};\n");
  CHECK(filled("A a{{{{x}}, {{y}}}};\n", data) == "A a{{1, 2}};\n");
}

TEST_CASE("a partial stands in its place: alone in a line with its lines, inside of one as one") {
  const TemplateFile part("{{! What it is. }}\n{{#on}}<{{x}}>{{/on}}\n{{^on}}-{{/on}}\n", "emit_test_part.mustache");
  Data data("x", "1");
  data.set("on", true);
  CHECK(filled("a {{>emit_test_part}};\n", data) == "a <1>;\n");
  CHECK(filled("a\n{{>emit_test_part}}\nb\n", data).find("a\n<1>\n") == 0);
  const TemplateFile endless("{{>emit_test_part}}\n", "emit_test_part.mustache");
  CHECK_THROWS_AS(filled("{{>emit_test_part}}\n", data), std::logic_error);
}

TEST_CASE("a statement takes one line where it fits, else one for each part") {
  const std::string text = "{{fit}}A a{{{break}}{{x}}, {{break}}{{y}}};{{end_fit}}\n";
  Data data("x", "1");
  data.set("y", "2");
  CHECK(filled(text, data) == "A a{1, 2};\n");
  data.set("x", std::string(120, '1'));
  CHECK(filled(text, data) == "A a{\n    " + std::string(120, '1') + ",\n    2};\n");
  CHECK(filled("{{x}};{{column}}  // 1\n", Data("x", "a")) == "a;" + std::string(60, ' ') + "  // 1\n");
}

TEST_CASE("no name at the end of a comment takes the next line into it") {
  CHECK(filled("int a;  // {{x}}\nint b;\n", Data("x", "c:\\")) == "int a;  // c:\\ //\nint b;\n");
  CHECK(filled("int a;  // {{x}}\nint b;\n", Data("x", "\\ ")) == "int a;  // \\  //\nint b;\n");
}

TEST_CASE("values are written in the type that a Config member has") {
  const ParamSpec integer = spec_of("n", ParamKind::integer);
  CHECK(value_expression(integer, std::int64_t{1024}) == "1024");
  CHECK(value_expression(integer, std::int64_t{INT32_MIN}) == "-2147483647 - 1");
  CHECK(value_expression(spec_of("n", ParamKind::integer, Unit::frequency_hz), std::int64_t{400'000}) ==
        "std::int64_t{400000}");
  CHECK(value_expression(spec_of("x", ParamKind::real), 0.25) == "0.25f");
  CHECK(value_expression(spec_of("x", ParamKind::real), std::int64_t{2}) == "2.0f");
  CHECK(value_expression(spec_of("b", ParamKind::boolean), true) == "true");
  CHECK(value_expression(spec_of("s", ParamKind::text), std::string("a\"b")) == "\"a\\\"b\"");
  ParamSpec mode = spec_of("m", ParamKind::enumeration);
  mode.enumerators = {{"fast", "my::Mode::kFast"}};
  CHECK(value_expression(mode, std::string("fast")) == "my::Mode::kFast");
}

TEST_CASE("of a shipped class only what differs from its default is assigned, of a user's class everything") {
  ParamSpec gain = spec_of("gain", ParamKind::real), reverse = spec_of("reverse", ParamKind::boolean);
  gain.fallback = 1.0;
  reverse.fallback = false;
  const std::vector<Param> defaults{{&gain, 1.0, true}, {&reverse, false, false}};
  const std::vector<Param> reversed{{&gain, 1.0, false}, {&reverse, true, true}};
  CHECK(config_of("finemote::Esc", defaults, true) == "finemote::Esc::Config{}");
  CHECK(config_of("finemote::Esc", reversed, true) ==
        "[] { finemote::Esc::Config c{}; c.reverse = true; return c; }()");
  CHECK(in_order(config_of("my::Esc", reversed, false), {"my::Esc::Config", "gain", "1.0f", "reverse", "true"}));
}

TEST_CASE("the files of a robot are those that are listed, each says what it is, and twice they are the same") {
  const std::string inner = load("root", "10ms", load("leaf", "1ms")) + load("other", "1ms");
  const Rendered one(inner), two(inner);
  const auto names = output_names(*one.planned.robot, one.planned.forest);
  REQUIRE(names.size() == one.files.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    INFO(names[i]);
    CHECK(one.files[i].name == names[i]);
    CHECK(one.files[i].text.rfind(std::string(kGeneratedHeader) + "\n// Source: r.urdf\n", 0) == 0);
    CHECK(one.files[i].text.back() == '\n');
    CHECK(one.files[i].text.find('\r') == std::string::npos);
    CHECK(one.files[i].text == two.files[i].text);
  }
}

TEST_CASE("a bus is called by its name alone, unless something of the tree has it") {
  const std::string bus = R"(<bus name="imu" type="uart" port="usart1" baud="460800baud"/>
<bus name="ports" type="uart" port="usart6" baud="460800baud"/>)";
  const auto device = [&](const std::string& name, const std::string& on) {
    return bus + "<device name=\"" + name + "\" type=\"h30_imu\" bus=\"" + on + "\" period=\"5ms\"/>";
  };
  CHECK(Rendered(device("pose", "imu"))["trees/pose.hpp"].find("pose{/*mount*/ nullptr, imu}") != std::string::npos);
  CHECK(Rendered(load("root", "5ms", device("imu", "imu").substr(bus.size())) + bus)["trees/root.hpp"].find(
            "imu{/*mount*/ nullptr, ::r::imu}") != std::string::npos);
  CHECK(Rendered(device("pose", "ports"))["trees/pose.hpp"].find("nullptr, ::r::ports}") != std::string::npos);
}

TEST_CASE("updates run from leaf to root, handles from root to leaf") {
  const Rendered rendered(load("root", "10ms", load("first", "10ms") + load("second", "10ms")));
  const std::string source = rendered["trees/root.cpp"];
  CHECK(in_order(source, {"first.update()", "second.update()", "root.update()"}));
  CHECK(in_order(source, {"root.handle()", "second.handle()", "first.handle()"}));
}

TEST_CASE("what crosses between periods is published by its writer and taken by its reader") {
  const std::string source = Rendered(load("root", "10ms", load("leaf", "1ms")))["trees/root.cpp"];
  CHECK(in_order(source,
                 {"leaf.update()", "leaf_to_root_latch.publish", "leaf_to_root_latch.snapshot()", "root.update()"}));
  CHECK(in_order(source,
                 {"root_to_leaf_latch.snapshot()", "leaf.handle()", "root.handle()", "root_to_leaf_latch.publish"}));
}

TEST_CASE("devices are defined before those that are made of them") {
  const std::string header = Rendered(load("root", "10ms", load("leaf", "10ms")))["trees/root.hpp"];
  CHECK(in_order(header, {"finemote::SimLoad leaf", "finemote::SimLoad root"}));
}
