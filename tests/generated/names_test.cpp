// A name that `generate` accepts disturbs no generated code, whatever it is: every word of the generated sources, as
// the name of buses, expanders, channels, roots and leaves (with FINEMOTE_ALL_NAMES=1 those of the runtime's headers
// too). No macro is accepted.
#include <array>
#include <cstdlib>
#include <filesystem>
#include <regex>
#include <set>

#include "catch.hpp"
#include "cli/program.hpp"
#include "errors/pipeline.hpp"
#include "generated/batch.hpp"
#include "generated/compiler.hpp"
#include "generator/descriptor/cpp_words.hpp"
#include "generator/model/names.hpp"

using namespace finemote;
using namespace finemote::test;
namespace fs = std::filesystem;

namespace {

/// A robot with something of everything; `$1` to `$14` are its names.
constexpr const char* kRobot = R"(<robot name="$0"><finemote version="1"><board name="robomaster_type_c"/>
  <bus name="$1" type="i2c" port="i2c2" clock="400kHz"/>
  <bus name="$2" type="uart" port="usart6" baud="460800baud"/>
  <bus name="$3" type="i2c" port="i2c3" clock="400kHz"/>
  <bus name="$4" type="uart" port="usart1" baud="460800baud"/>
  <expander name="$5" model="pca9685" bus="$1" address="0x40"/>
  <expander name="$6" model="tca9548a" bus="$3" address="0x70"><channel index="0" name="$7"/></expander>
  <device name="$8" type="host_link" bus="$2" period="10ms">
    <device name="$9" type="ms5837" bus="$7" address="0x76" period="5ms"/>
    <device name="$10" type="pwm_servo" bus="$5" channel="0"/></device>
  <device name="$11" type="sim_load" period="5ms">
    <device name="$12" type="sim_load" period="2ms"/>
    <device name="$13" type="ms5837" bus="$1" address="0x76"/>
    <reads device="$14" role="children"/></device>
  <device name="$14" type="h30_imu" bus="$4" period="5ms"/></finemote></robot>)";
constexpr std::size_t kNames = 14;
using Names = std::array<std::string, kNames>;

Names plain_names() {
  Names names;
  for (std::size_t i = 0; i < kNames; ++i) names.at(i) = "part_" + std::to_string(i + 1) + "_x";
  return names;
}

std::string robot_of(const std::string& name, const Names& names) {
  std::string text = kRobot;
  const auto put = [&](const std::string& hole, const std::string& word) {
    for (auto at = text.find(hole); at != std::string::npos; at = text.find(hole)) text.replace(at, hole.size(), word);
  };
  for (std::size_t i = kNames; i > 0; --i) put("$" + std::to_string(i), names.at(i - 1));
  put("$0", name);
  return text;
}

/// Words outside comments and strings.
void add_words(const std::string& text, std::set<std::string>& words) {
  static const std::regex comment(R"(//[^\n]*|/\*[^*]*\*/|"[^"\n]*")"), word(R"([A-Za-z_]\w*)");
  const std::string code = std::regex_replace(text, comment, " ");
  for (std::sregex_iterator match(code.begin(), code.end(), word), end; match != end; ++match)
    words.insert(match->str());
}

void add_words_below(const std::string& folder, std::set<std::string>& words) {
  for (const auto& entry : fs::recursive_directory_iterator(source_path(folder))) {
    const std::string end = entry.path().extension().string();
    if (end == ".hpp" || end == ".cpp" || end == ".mustache") add_words(read_file(entry.path().string()), words);
  }
}

/// The macros defined at the end of a source.
std::set<std::string> macros_of(const Compiler& compiler, const std::string& source) {
  std::set<std::string> words;
  std::vector<std::string> command = compiler.command;
  command.insert(command.end(), {"-dM", "-E", source});
  const auto result = gen::run_process(command, std::chrono::seconds(60));
  static const std::regex macro(R"(#define ([A-Za-z]\w*))");
  for (std::sregex_iterator match(result.output.begin(), result.output.end(), macro), end; match != end; ++match)
    words.insert((*match)[1]);
  return words;
}

class Words {
 public:
  explicit Words(gen::Pipeline& pipeline) : pipeline_(pipeline) {}

  /// The words that `generate` takes in one place of the robot.
  std::vector<std::string> accepted(const std::set<std::string>& words, std::size_t place) {
    std::vector<std::string> taken;
    for (const std::string& word : words) {
      Names names = plain_names();
      names.at(place) = word;
      const gen::Outcome outcome = pipeline_.run(robot_of("r", names));
      INFO(word << ": " << outcome.said);
      if (!outcome.files.empty()) {
        taken.push_back(word);
      } else {
        CHECK(std::regex_search(outcome.said, std::regex("error.FM(304[6-9]|3202)")));
      }
    }
    return taken;
  }

 private:
  gen::Pipeline& pipeline_;
};

std::string said_by_all(const std::vector<Generated>& robots) {
  const TemporaryFolder folder;
  write_file(folder.path("batch.cpp"), translation_unit(robots));
  std::string said;
  for (const Compiler& compiler : compilers()) said += complaint(compiler, folder.path("batch.cpp"), {});
  return said;
}

std::string by_file(const Generated& robot) {
  const TemporaryFolder folder;
  for (const gen::OutputFile& file : robot.files) write_file(folder.path(file.name), file.text);
  std::string said;
  for (const Compiler& compiler : compilers()) said += complaint_about(compiler, folder.path());
  return said;
}

}  // namespace

TEST_CASE("every word of generated code and its headers is refused as a name, or compiles as one") {
  std::set<std::string> words;
  add_words_below("tests/golden/infantry.urdf", words);
  add_words_below("templates", words);
  if (std::getenv("FINEMOTE_ALL_NAMES") != nullptr) add_words_below("runtime/include/finemote", words);
  gen::Pipeline pipeline({});
  // One of each kind stands for the others; the words are then spread over all places of the kind.
  const std::vector<std::vector<std::size_t>> kinds{{0, 1, 2, 3, 4, 5, 6}, {7, 10, 13}, {8, 9, 11, 12}};
  std::vector<Generated> batch;
  std::size_t robots = 0;
  Words reader(pipeline);
  for (const auto& kind : kinds) {
    const std::vector<std::string> taken = reader.accepted(words, kind.front());
    const std::size_t rows = (taken.size() + kind.size() - 1) / kind.size();  // neighbours may differ by case alone
    for (std::size_t i = 0; i < rows; ++i) {
      Names names = plain_names();
      std::set<std::string> folded;
      for (std::size_t k = 0; k < kind.size() && i + k * rows < taken.size(); ++k) {
        const std::string& word = taken[i + k * rows];
        if (folded.insert(gen::fold_case(word)).second) names.at(kind[k]) = word;
      }
      Generated robot;
      robot.space = "r" + std::to_string(robots++);
      robot.input = robot_of(robot.space, names);
      gen::Outcome outcome = pipeline.run(robot.input);
      INFO(outcome.said);
      CHECK(!outcome.files.empty());
      robot.files = std::move(outcome.files);
      batch.push_back(std::move(robot));
    }
  }
  CHECK(robots > 100);
  constexpr std::size_t kBatch = 50;
  for (std::size_t i = 0; i < batch.size(); i += kBatch) {
    const std::vector<Generated> some(batch.begin() + static_cast<std::ptrdiff_t>(i),
                                      batch.begin() + static_cast<std::ptrdiff_t>(std::min(i + kBatch, batch.size())));
    CHECK(said_by_all(some).substr(0, 4000) == "");
  }
}

TEST_CASE("no macro that generated sources see is a name") {
  const TemporaryFolder folder;
  const gen::Outcome plain = gen::Pipeline({}).run(robot_of("r", plain_names()));
  REQUIRE(!plain.files.empty());
  write_file(folder.path("all.cpp"), translation_unit({{"r", plain.files, {}}}));
  for (const Compiler& compiler : compilers()) {
    const std::set<std::string> macros = macros_of(compiler, folder.path("all.cpp"));
    CHECK(macros.size() > 20);
    for (const std::string& macro : macros) {
      INFO(compiler.name << ": " << macro);
      CHECK(gen::invalid_name(macro).has_value());
    }
  }
}

TEST_CASE("no root hides a generated file from another") {
  gen::Pipeline pipeline({});
  for (const char* name : {"buses", "Buses", "schedule", "constants", "link", "r", "trees"}) {
    Names names = plain_names();
    names.at(7) = name;
    const gen::Outcome outcome = pipeline.run(robot_of("r", names));
    if (outcome.files.empty()) continue;
    INFO(name);
    CHECK(by_file({"r", outcome.files, {}}).substr(0, 2000) == "");
  }
}

TEST_CASE("a bus may have the name of a device, and of what is generated beside devices") {
  gen::Pipeline pipeline({});
  Names names = plain_names();
  names.at(8) = names.at(0);   // a sensor, its slot, and its bus
  names.at(11) = names.at(1);  // a device, and the bus of another tree
  std::vector<Names> robots{names};
  for (const char* name : {"ports", "Stage", "stage", "update_5ms", "handle_10ms"}) {
    names = plain_names();
    names.at(0) = name;
    robots.push_back(names);
    names = plain_names();
    names.at(1) = name;
    robots.push_back(names);
  }
  for (const Names& shared : robots) {
    const gen::Outcome outcome = pipeline.run(robot_of("r", shared));
    INFO(shared.at(0) << " " << shared.at(1) << ": " << outcome.said);
    REQUIRE(!outcome.files.empty());
    CHECK(by_file({"r", outcome.files, {}}).substr(0, 2000) == "");
  }
}
