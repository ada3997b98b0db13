// Scenarios: the table behind them, what is made of it, and how mistakes in them are found.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "catch.hpp"
#include "emulator/scenario/grammar.hpp"
#include "emulator/scenario/page.hpp"
#include "emulator/scenario/read.hpp"
#include "emulator/scenario/schema.hpp"
#include "generator/descriptor/library.hpp"
#include "generator/diagnostic/render.hpp"
#include "generator/model/build.hpp"
#include "generator/run/parts.hpp"
#include "generator/run/scenario.hpp"
#include "generator/xml/parse.hpp"
#include "generator/xml/read_source.hpp"
#include "read.hpp"
#include "source_dir.hpp"
#include "tests/rewrites.hpp"

using namespace finemote;
using finemote::test::read;
using Json = nlohmann::ordered_json;

namespace {

const std::string kSource = finemote::test::source_dir();

/// A robot, kept with what it points into.
struct Case {
  explicit Case(const std::string& file, const std::string& folder) {
    library = gen::load_library({kSource, folder, {}, {}}, sources, diagnostics);
    REQUIRE(library);
    const gen::SourceFile* source = gen::xml::read_source(file, sources, diagnostics, "robot.urdf");
    REQUIRE(source);
    const auto document = gen::xml::parse(*source, diagnostics);
    REQUIRE(document);
    robot = gen::build_model(*document, *library, {}, sources, diagnostics);
    INFO(gen::render_text(diagnostics, false));
    REQUIRE(robot);
  }
  /// As `run` knows it.
  scenario::World world() const {
    scenario::World world = gen::scenario_world(*robot, gen::emulated_parts(*robot, {}), gen::Duration::zero());
    world.duration_ns.reset();
    return world;
  }
  gen::Sources sources;
  gen::Diagnostics diagnostics;
  std::optional<gen::Library> library;
  std::optional<gen::Robot> robot;
};

Case example(const std::string& name) { return Case(kSource + "/examples/" + name + ".urdf", kSource + "/examples"); }

/// Everything that is said of a text.
struct Answer {
  bool good = false;
  std::string text;
  std::vector<gen::Diagnostic> findings;
};

Answer check(const std::string& text, const scenario::World& world) {
  const gen::SourceFile file{"s.json", "", text};
  gen::Diagnostics diagnostics;
  Answer answer;
  answer.good = scenario::read(file, world, diagnostics).has_value();
  answer.text = gen::render_text(diagnostics, false);
  answer.findings = diagnostics.in_file_order();
  return answer;
}

const scenario::World kWorld{{{"remote", "dbus_receiver"},
                              {"imu", "h30_imu"},
                              {"wheel", "dji_motor"},
                              {"hand", "standing_body"},
                              {"bank", "register_bank"},
                              {"chassis", ""}},
                             std::vector<std::string>{"usart1", "can1"},
                             {},
                             100'000'000};

std::string with(const std::string& members) { return R"({"schema": "finemote.scenario/1", )" + members + "}"; }
std::string event(const std::string& members) { return with("\"events\": [{" + members + "}]"); }
std::string expectation(const std::string& members) { return with("\"expect\": [{" + members + "}]"); }

/// Exactly one error, of this code, at the word `at` of the text, that says `words`.
void refuses(const std::string& text, unsigned code, const std::string& at, const std::string& words,
             const scenario::World& world = kWorld) {
  const Answer answer = check(text, world);
  INFO(text << "\n" << answer.text);
  CHECK_FALSE(answer.good);
  REQUIRE(answer.findings.size() == 1);
  CHECK(answer.findings[0].code.number == code);
  CHECK(answer.text.find(words) != std::string::npos);
  CHECK(answer.findings[0].at.line == 1);
  CHECK(answer.findings[0].at.column == text.find(at) + 1);
}

bool schema_accepts(const valijson::Schema& schema, const std::string& text) {
  const auto value = nlohmann::json::parse(text);
  valijson::Validator validator;
  return validator.validate(schema, valijson::adapters::NlohmannJsonAdapter(value), nullptr);
}

struct Shipped {
  const char *robot, *scenario;
};
constexpr Shipped kShipped[] = {
    {"six_joint_arm", "arm_faults"},    {"six_joint_arm", "arm_loops"}, {"infantry", "infantry_faults"},
    {"infantry", "infantry_imu"},       {"infantry", "infantry_loops"}, {"infantry", "infantry_more_faults"},
    {"infantry", "infantry_other_way"}, {"finsrov", "rov_faults"},      {"finsrov", "rov_loops"},
    {"finsrov", "rov_more_faults"},
};

std::string shipped_text(const Shipped& it) {
  return read(kSource + "/tests/emulator/scenarios/" + it.scenario + ".json");
}

/// One member of an entry renamed, of another type, or out of range; none: the row has no range to leave.
std::vector<Json> mutants(const Json& value) {
  std::vector<Json> all;
  if (value.is_number()) all.insert(all.end(), {"1", true, Json::array({1}), Json(), 1e300 * (value < 0 ? -1 : 1)});
  if (value.is_string()) all.insert(all.end(), {1, false, value.get<std::string>() + "~", Json::object(), ""});
  if (value.is_boolean()) all.insert(all.end(), {1, "true", Json()});
  if (value.is_array()) all.insert(all.end(), {1, Json::array({1, 2}), Json::array({1, 2, "3"}), Json::array()});
  return all;
}

/// Members for which any number, or any text, has a meaning.
bool takes_any(const std::string& key, const Json& mutant) {
  const bool is_free_number = key == "torque" || key == "min" || key == "max";
  return (is_free_number && mutant.is_number()) || (key == "text" && mutant.is_string());
}

}  // namespace

TEST_CASE("the JSON Schema of scenarios is the one made from the table") {
  const std::string path = kSource + "/schemas/scenario.schema.json", text = scenario::json_schema().dump(1) + "\n";
  if (finemote::test::rewrites()) std::ofstream(path, std::ios::binary) << text;
  INFO("FINEMOTE_UPDATE_GOLDEN=1 writes it anew");
  CHECK(read(path) == text);
}

TEST_CASE("a scenario can name every port of every shipped board, as what it is") {
  for (const auto& file : std::filesystem::directory_iterator(kSource + "/schemas/boards")) {
    for (const Json& port : Json::parse(read(file.path())).value("ports", Json::array())) {
      const std::string name = port["name"], bus = port["buses"][0];
      INFO(file.path() << ", " << name);
      const scenario::PortKind* kind = scenario::kind_of_port(name);
      REQUIRE(kind != nullptr);
      CHECK(kind->name == (bus == "uart" ? "serial" : bus));
    }
  }
}

TEST_CASE("the reference page has the tables made from the table") {
  const std::string path = kSource + "/docs/reference/emulator.md";
  std::string page = read(path);
  const std::string before = page;
  const std::pair<const char*, std::string> tables[] = {
      {"parts", scenario::parts_table()}, {"actions", scenario::actions_table()}, {"values", scenario::values_table()}};
  for (const auto& [name, table] : tables) {
    const std::string begin = "<!-- table: " + std::string(name) + " -->\n";
    const std::size_t at = page.find(begin), end = page.find("<!-- end of table -->", at);
    REQUIRE(at != std::string::npos);
    REQUIRE(end != std::string::npos);
    page.replace(at + begin.size(), end - at - begin.size(), "\n" + table + "\n");
  }
  if (finemote::test::rewrites()) std::ofstream(path, std::ios::binary) << page;
  INFO("FINEMOTE_UPDATE_GOLDEN=1 writes it anew");
  CHECK(read(path) == page);
}

TEST_CASE("what runs hang on the board keeps to the table of scenarios") {
  for (const char* robot : {"finsrov", "infantry", "six_joint_arm", "two_devices", "user_device"}) {
    const Case c = example(robot);
    const Answer answer = check(gen::emulated_parts(*c.robot, {}).scenario.dump(1), {});
    INFO(robot << "\n" << answer.text);
    CHECK(answer.good);
  }
  for (const char* robot : {"rover", "rig", "crane"}) {
    const std::string folder = kSource + "/tests/emulator/robots";
    const Case c(folder + "/" + robot + ".urdf", folder);
    const Answer answer = check(gen::emulated_parts(*c.robot, {}).scenario.dump(1), {});
    INFO(robot << "\n" << answer.text);
    CHECK(answer.good);
  }
}

TEST_CASE("shipped scenarios are valid, without a warning, also by their schema") {
  valijson::Schema schema;
  const nlohmann::json text = nlohmann::json::parse(scenario::json_schema().dump());
  valijson::SchemaParser().populateSchema(valijson::adapters::NlohmannJsonAdapter(text), schema);
  for (const Shipped& it : kShipped) {
    const Case c = example(it.robot);
    const Answer answer = check(shipped_text(it), c.world());
    INFO(it.scenario << "\n" << answer.text);
    CHECK(answer.good);
    CHECK(answer.findings.empty());
    CHECK(schema_accepts(schema, shipped_text(it)));
  }
  CHECK_FALSE(schema_accepts(schema, event(R"("t_ns": 1, "part": "remote", "do": "move", "left_y": 5)")));
  CHECK_FALSE(schema_accepts(schema, event(R"("t_ns": 1, "part": "remote", "do": "move", "lefty": 1)")));
  CHECK_FALSE(schema_accepts(schema, event(R"("t_ns": 1, "part": "remote", "do": "moev", "left_y": 1)")));
}

TEST_CASE("every mutation of every shipped scenario is an error with a place") {
  unsigned count = 0;
  for (const Shipped& it : kShipped) {
    const Case c = example(it.robot);
    const scenario::World world = c.world();
    const Json good = Json::parse(shipped_text(it));
    const auto refused = [&](const Json& document) {
      ++count;
      const Answer answer = check(document.dump(1), world);
      const bool placed = std::all_of(answer.findings.begin(), answer.findings.end(),
                                      [](const auto& finding) { return finding.at.line > 0 && finding.at.column > 0; });
      if (!answer.good && placed && !answer.findings.empty()) return;
      INFO(it.scenario << ": " << document.dump(1));
      CHECK(false);
    };
    for (const char* list : {"events", "expect"}) {
      for (std::size_t i = 0; i < good[list].size(); ++i) {
        for (const auto& [key, value] : good[list][i].items()) {
          Json renamed = good;
          renamed[list][i].erase(key);
          renamed[list][i][key + "x"] = value;
          refused(renamed);
          for (const Json& mutant : mutants(value)) {
            if (takes_any(key, mutant)) continue;
            Json changed = good;
            changed[list][i][key] = mutant;
            refused(changed);
          }
        }
      }
    }
  }
  CHECK(count > 5'000);
}

TEST_CASE("a mistake in a scenario is found at its word") {
  refuses(event(R"("t_ns": 1, "part": "remote", "do": "move", "lefty": 1)"), 6007, "\"lefty", "did you mean 'left_y'");
  refuses(event(R"("t_ns": 1, "part": "remote", "do": "move", "left_y": 5)"), 6009, "5}", "-1 to 1");
  refuses(event(R"("t_ns": 1, "part": "remote", "do": "moev", "left_y": 1)"), 6007, "\"moev", "did you mean 'move'");
  refuses(event(R"("t_ns": 1, "part": "remot", "do": "move", "left_y": 1)"), 6007, "\"remot\"",
          "did you mean 'remote'");
  refuses(event(R"("t_ns": 1, "part": "chassis", "do": "move")"), 6007, "\"chassis", "no model");
  refuses(event(R"("t_ns": 1, "part": "remote", "do": "failsafe")"), 6007, "\"failsafe", "cannot happen to 'remote'");
  refuses(event(R"("t_ns": 1, "part": "remote", "do": "move")"), 6004, "{\"t_ns", "changes nothing");
  refuses(event(R"("t_ns": "5ms", "part": "imu", "do": "silent")"), 6004, "\"5ms", "for example 5000000");
  refuses(event(R"("t_ns": "5", "part": "imu", "do": "silent")"), 6004, "\"5\"", "write 5 without quotes");
  refuses(event(R"("t_ns": -1, "part": "imu", "do": "silent")"), 6009, "-1", "0 to 86400000000000 ns");
  refuses(event(R"("t_ns": 1.5, "part": "imu", "do": "silent")"), 6009, "1.5", "a whole number");
  refuses(event(R"("t_ns": 1e999, "part": "imu", "do": "silent")"), 6009, "1e999", "a double can hold");
  refuses(event(R"("t_ns": 99999999999999999999999, "part": "imu", "do": "silent")"), 6009, "99999", "0 to 8640");
  refuses(event(R"("t_ns": 1, "part": "imu", "do": "silent", "on": "yes")"), 6004, "\"yes", "true or false");
  refuses(event(R"("t_ns": 1, "port": "can2", "do": "silent")"), 6007, "\"can2", "no bus at port 'can2'");
  refuses(event(R"("t_ns": 1, "port": "can3", "do": "silent")"), 6007, "\"can3", "no port 'can3'");
  refuses(event(R"("t_ns": 1, "port": "can1", "do": "nack")"), 6007, "\"nack", "cannot happen to 'can1'");
  refuses(event(R"("t_ns": 1, "pin": "PA16", "do": "low")"), 6009, "\"PA16", "PA0 to PI11");
  refuses(event(R"("t_ns": 1, "pin": "PI12", "do": "low")"), 6009, "\"PI12", "PA0 to PI11");
  refuses(event(R"("t_ns": 1, "pin": "PA0", "port": "can1", "do": "low")"), 6004, "\"port", "to one 'part'");
  refuses(event(R"("t_ns": 1, "do": "silent")"), 6004, "{\"t_ns", "only 'reset'");
  refuses(event(R"("t_ns": 1, "part": "wheel", "do": "disturb")"), 6004, "{\"t_ns", "'torque' is missing");
  refuses(event(R"("t_ns": 1, "part": "bank", "do": "set", "r256": 1)"), 6007, "\"r256", "no member 'r256'");
  refuses(event(R"("t_ns": 1, "part": "hand", "do": "move", "rate": [1, 2])"), 6004, "[1, 2", "needs 3");
  refuses(event(R"("t_ns": 1, "part": "hand", "do": "move", "rate": [1, 2, 1e400])"), 6009, "1e400", "'rate[2]'");
  refuses(with(R"("event": [])"), 6007, "\"event\"", "did you mean 'events'");
  refuses(with(R"("events": {})"), 6004, "{}", "an array");
  refuses(with(R"("events": [7])"), 6004, "7", "'events[0]' must be an object, got a number");
  refuses(with(R"("expect": [null])"), 6004, "null", "'expect[0]' must be an object, got null");
  refuses(with(R"("parts": [{"type": "standing_body", "name": "s"}, null])"), 6004, "null",
          "'parts[1]' must be an object, got null");
  refuses(with(R"("events": [], "events": [])"), 6004, "\"events\": []}", "repeated");
  refuses(R"({"schema": "finemote.scenario/2", "events": []})", 6004, "\"finemote", "finemote.scenario/1");
  refuses(R"({"events": []})", 6004, "{", "'schema' is missing");
  refuses("[]", 6004, "[", "a scenario must be an object, got an array");
  refuses(expectation(R"("from_ns": 0, "part": "wheel", "value": "sped", "min": 0, "max": 1)"), 6007, "\"sped",
          "did you mean 'speed'");
  refuses(expectation(R"("from_ns": 0, "part": "remote", "value": "left_y", "min": 0, "max": 1)"), 6007, "\"left_y",
          "no value that can be looked at");
  refuses(expectation(R"("from_ns": 0, "part": "wheel", "value": "speed", "min": 2, "max": 1)"), 6009, "1}",
          "below 'min'");
  refuses(expectation(R"("from_ns": 9, "to_ns": 8, "part": "wheel", "value": "speed", "min": 0, "max": 1)"), 6009, "8,",
          "below 'from_ns'");
  refuses(expectation(R"("from_ns": 0, "part": "wheel", "value": "speed", "min": 0)"), 6004, "{\"from_ns",
          "'max' is missing");
  refuses(with(R"("parts": [{"type": "sonar", "name": "s"}])"), 6007, "\"sonar", "there is no part model 'sonar'");
  refuses(with(R"("parts": [{"type": "standing_body", "name": "imu"}])"), 6004, "\"imu", "already");
  refuses(with(R"("parts": [{"type": "host_terminal", "name": "h", "port": "usart9", "baud": 9600}])"), 6007,
          "\"usart9", "no serial port");
  refuses(with(R"("parts": [{"type": "ms5837", "name": "b"}])"), 6004, "{\"type", "needs one of 'port' and 'mux'");
  refuses(with(R"("parts": [{"type": "ms5837", "name": "b", "mux": "imu", "channel": 0}])"), 6007, "\"imu",
          "cannot be a 'mux'");
}

TEST_CASE("parts that stand in each other's way are refused at the word") {
  const Case rov = example("finsrov");
  const scenario::World world =
      gen::scenario_world(*rov.robot, gen::emulated_parts(*rov.robot, {}), gen::milliseconds(100));
  const auto part = [](const std::string& members) { return with("\"parts\": [{" + members + "}]"); };
  const auto refused = [&](const std::string& members, unsigned code, const std::string& at, const std::string& words) {
    refuses(part(members), code, at, words, world);
  };
  const auto accepted = [&](const std::string& members) {
    const Answer answer = check(part(members), world);
    INFO(members << "\n" << answer.text);
    CHECK(answer.good);
  };
  accepted(R"("type": "register_bank", "name": "rb", "port": "i2c2", "address": 80)");
  accepted(R"("type": "register_bank", "name": "rb", "mux": "mux", "channel": 7, "address": 118)");
  accepted(R"("type": "pwm_output", "name": "probe", "pwm": "pwm", "channel": 0)");
  accepted(R"("type": "thruster", "name": "t9", "pwm": "pwm", "channel": 15)");
  refused(R"("type": "register_bank", "name": "", "port": "i2c2", "address": 80)", 6004, "\"\"", "needs a name");
  refused(R"("type": "register_bank", "name": "rb", "port": "i2c2", "address": 112)", 6004, "112",
          "'mux' already has address 112 on 'i2c2'");
  refused(R"("type": "register_bank", "name": "rb", "mux": "mux", "channel": 7, "address": 112)", 6004, "112",
          "'mux' already has address 112 on 'i2c2'");
  refused(R"("type": "ist8310", "name": "rb", "port": "i2c2", "address": 64)", 6004, "64", "has address 64 on");
  refused(R"("type": "tca9548a", "name": "m2", "port": "i2c2")", 6004, "\"i2c2", "'mux' already has address 112");
  refused(R"("type": "h30_imu", "name": "i2", "port": "usart1", "baud": 460800)", 6004, "\"usart1",
          "'imu' already has the serial port 'usart1'");
  refused(R"("type": "thruster", "name": "t9", "pwm": "pwm", "channel": 0)", 6004, "0}",
          "already has output 0 of 'pwm'");
  refused(R"("type": "h30_imu", "name": "i2", "port": "usart3", "baud": 460800)", 6007, "\"usart3",
          "the robot has no bus at port 'usart3'");
  refused(R"("type": "register_bank", "name": "rb", "port": "i2c3", "address": 80)", 6007, "\"i2c3",
          "did you mean 'i2c2'");
  refused(R"("type": "register_bank", "name": "rb", "port": "i2c2")", 6004, "{\"type", "'address' is missing");
  refused(R"("type": "tca9548a", "name": "m2", "mux": "m2", "channel": 1, "address": 113)", 6004, "\"m2\", \"channel",
          "'m2' must be listed before the parts that are connected to it");
  refuses(with(R"("parts": [{"type": "register_bank", "name": "a", "port": "i2c2", "address": 80}, )"
               R"({"type": "register_bank", "name": "b", "port": "i2c2", "address": 80}])"),
          6004, "80}]", "'a' already has address 80 on 'i2c2'", world);
}

TEST_CASE("an output is observed once, and a pulse of another part may be observed too") {
  const Case rov = example("finsrov");
  const scenario::World world =
      gen::scenario_world(*rov.robot, gen::emulated_parts(*rov.robot, {}), gen::milliseconds(100));
  const auto outputs = [](const std::string& first, const std::string& second) {
    const std::string output = R"({"type": "pwm_output", "pwm": "pwm", "name": )";
    return with("\"parts\": [" + output + first + "}, " + output + second + "}]");
  };
  CHECK(check(outputs(R"("a", "channel": 0)", R"("b", "channel": 9)"), world).good);
  refuses(outputs(R"("a", "channel": 9)", R"("b", "channel": 9)"), 6004, "9}]",
          "'a' already observes output 9 of 'pwm'", world);
}

TEST_CASE("chip selects the board does not have are refused at the word") {
  scenario::World world = kWorld;
  for (const char* port : {"spi1", "spi2", "spi3"}) world.ports->push_back(port);
  world.selects = {{"spi1", 2}, {"spi2", 1}};
  const auto sensor = [](const std::string& port, int channel, int gyro) {
    return with(R"("parts": [{"type": "bmi088", "name": "b", "port": ")" + port + R"(", "channel": )" +
                std::to_string(channel) + R"(, "gyro": )" + std::to_string(gyro) + "}]");
  };
  CHECK(check(sensor("spi1", 1, 0), world).good);
  refuses(sensor("spi2", 0, 1), 6009, "1}]", "'spi2' has no chip select 1", world);
  refuses(sensor("spi1", 0, 0), 6009, "0}]", "'channel' and 'gyro' are both chip select 0", world);
  CHECK(check(sensor("spi3", 0, 1), world).findings.size() == 2);
}

TEST_CASE("a joint with a weight is carried by one above it") {
  const auto weights = [](const std::string& joints) {
    return with(R"("parts": [{"type": "weights", "name": "w", "body": "hand", "joints": [)" + joints + "]}]");
  };
  const std::string first = R"({"part": "wheel", "mass": 1})",
                    second = R"({"part": "bank", "mass": 1, "before": "wheel"})";
  CHECK(check(weights(first + ", " + second), kWorld).good);
  refuses(weights(second + ", " + first), 6004, "\"wheel\"}", "no joint above this one is that of 'wheel'");
  refuses(weights(R"({"part": "wheel", "mass": 1, "before": "wheel"})"), 6004, "\"wheel\"}",
          "no joint above this one is that of 'wheel'");
}

TEST_CASE("what can happen and what can be looked at has a function that does it") {
  for (const scenario::Target& target : scenario::targets()) {
    for (const scenario::Verb& verb : *target.verbs) {
      INFO(target.title << " " << verb.name);
      CHECK(verb.act);
      CHECK_FALSE(verb.summary.empty());
    }
  }
  for (const scenario::Model& model : scenario::models()) {
    INFO(model.type);
    CHECK(model.make != nullptr);
    for (const scenario::Quantity& value : model.values) CHECK(value.look);
  }
}

TEST_CASE("a fault at what the robot does not have is refused, as it would switch judging off for nothing") {
  const Case rov = example("finsrov");
  const scenario::World world =
      gen::scenario_world(*rov.robot, gen::emulated_parts(*rov.robot, {}), gen::milliseconds(100));
  refuses(event(R"("t_ns": 1, "port": "adc3", "do": "silent")"), 6007, "\"adc3", "uses the converter 'adc3'", world);
  refuses(event(R"("t_ns": 1, "port": "i2c2", "do": "nack", "address": 119, "times": 1)"), 6007, "119",
          "no part at 'i2c2' has address 119", world);
  for (const char* address : {"112", "118", "64"}) {
    const std::string nack = R"("t_ns": 1, "port": "i2c2", "do": "nack", "times": 1, "address": )";
    CHECK(check(event(nack + address), world).good);
  }
  const std::string folder = kSource + "/tests/emulator/images/onboard";
  const Case onboard(folder + "/onboard.urdf", folder);
  CHECK(check(event(R"("t_ns": 1, "port": "adc3", "do": "silent")"),
              gen::scenario_world(*onboard.robot, gen::emulated_parts(*onboard.robot, {}), gen::nanoseconds(1)))
            .good);
}

TEST_CASE("figures that do not fit each other are found at their member") {
  const auto part = [](const std::string& members) { return with("\"parts\": [{" + members + "}]"); };
  scenario::World world = kWorld;
  world.ports->push_back("pwm1");
  const std::string thruster = R"("type": "thruster", "name": "t", "port": "pwm1", )";
  refuses(part(thruster + R"("neutral": 1500)"), 6009, "1500}",
          "'neutral' must be between 'min', 1100000 ns, and 'max', 1900000 ns, got 1500 ns", world);
  refuses(part(thruster + R"("min": 1600000)"), 6009, "1600000", "between 'min', 1600000 ns", world);
  refuses(part(R"("type": "submerged_body", "name": "b", "inertia": [0,0,0,0,0,0])"), 6009, "[0,0", "cannot turn");
}

TEST_CASE("deep nesting and no JSON at all are answered, not followed") {
  const std::string deep = with("\"events\": " + std::string(100'000, '[') + std::string(100'000, ']'));
  for (const std::string& text :
       {deep, std::string(), std::string("{"), std::string("nan"), std::string("{\"schema\"")}) {
    const Answer answer = check(text, kWorld);
    CHECK_FALSE(answer.good);
    REQUIRE(answer.findings.size() == 1);
    CHECK(answer.findings[0].code.number == 6004);
  }
}

TEST_CASE("all mistakes of a scenario are reported together, in file order") {
  const Answer answer =
      check(with("\"events\": [{\"t_ns\": -1, \"part\": \"remote\", \"do\": \"move\", \"lefty\": 1},\n"
                 "{\"t_ns\": 1, \"part\": \"imu\", \"do\": \"sleep\"}],\n"
                 "\"expect\": [{\"from_ns\": 0, \"part\": \"nobody\", \"value\": \"x\", \"min\": 0, \"max\": 1}]"),
            kWorld);
  INFO(answer.text);
  REQUIRE(answer.findings.size() == 4);
  const std::uint32_t lines[] = {1, 1, 2, 3};
  for (std::size_t i = 0; i < 4; ++i) CHECK(answer.findings[i].at.line == lines[i]);
}

TEST_CASE("times that are rarely meant, and scenarios that say nothing, are warned of") {
  const auto warns = [](const std::string& text, unsigned code) {
    const Answer answer = check(text, kWorld);
    INFO(text << answer.text);
    CHECK(answer.good);
    REQUIRE(answer.findings.size() == 1);
    CHECK(answer.findings[0].code.number == code);
  };
  warns(with(R"("events": [{"t_ns": 2, "do": "reset"}, {"t_ns": 1, "do": "reset"}])"), 6010);
  warns(expectation(R"("from_ns": 200000000, "part": "wheel", "value": "speed", "min": 0, "max": 1)"), 6010);
  warns(with(R"("events": [])"), 6011);
  // Events lengthen the run.
  CHECK(check(with(R"("events": [{"t_ns": 3e8, "do": "reset"}],
                      "expect": [{"from_ns": 200000000, "part": "wheel", "value": "speed", "min": 0, "max": 1}])"),
              kWorld)
            .findings.empty());
}

TEST_CASE("a part of the scenario may stand in for a device without a model") {
  const std::string parts = R"("parts": [{"type": "standing_body", "name": "chassis"}], )";
  CHECK(check(with(parts + R"("events": [{"t_ns": 1, "part": "chassis", "do": "move", "yaw": 5}])"), kWorld).good);
}

TEST_CASE("numbers may be written as JSON allows, with equal meaning") {
  CHECK(check(event(R"("t_ns": 1e6, "part": "imu", "do": "damage", "frames": 3.0)"), kWorld).good);
  CHECK(check(event(R"("t_ns": 0, "part": "remote", "do": "move", "left_y": -0.0)"), kWorld).good);
  CHECK(check(event(R"("t_ns": 0, "part": "remote", "do": "move", "left_y": 1e-999)"), kWorld).good);
}

TEST_CASE("a body is driven through composites, and what drives nothing is named") {
  const std::string folder = kSource + "/tests/emulator/composite_wheels";
  const Case c(folder + "/robot.urdf", folder);
  const gen::EmulatedParts parts = gen::emulated_parts(*c.robot, {});
  CHECK(parts.undriven.empty());
  const Json& body = parts.scenario["parts"][0];
  INFO(body.dump(1));
  CHECK(body["type"] == "mecanum_base");
  CHECK(body["mass"] == Approx(15));
  REQUIRE(body["wheels"].size() == 4);
  CHECK(body["wheels"][0]["part"] == "front_left_motor");
  CHECK(body["wheels"][3]["part"] == "rear_right_motor");
  unsigned loads = 0;
  for (const Json& part : parts.scenario["parts"]) loads += part.contains("load_inertia") ? 1 : 0;
  CHECK(loads == 4);

  gen::Robot without = *c.robot;
  for (gen::Device& device : without.devices) {
    if (device.name.text == "front_left" || device.name.text == "rear_left_motor") device.joint.clear();
  }
  const gen::EmulatedParts fewer = gen::emulated_parts(without, {});
  REQUIRE(fewer.undriven.size() == 1);
  CHECK(fewer.undriven[0].message == "on the emulated board only 2 wheels of 'chassis' drive the robot's body");
  CHECK(fewer.undriven[0].notes ==
        std::vector<std::string>{"'front_left' has no 'joint'", "'rear_left' has no 'joint'"});
  for (gen::Device& device : without.devices) device.joint.clear();
  CHECK(gen::emulated_parts(without, {}).undriven[0].message ==
        "on the emulated board no wheels of 'chassis' drive the robot's body");
  CHECK(gen::emulated_parts(without, {}).scenario["parts"][0]["type"] == "standing_body");
}
