// Damaged robots end in a message with a place, or in files; never in a crash or a hang. All of the path is walked:
// xacro, model, forest, schedule, timing, lint, emit.
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>

#include "catch.hpp"
#include "errors/pipeline.hpp"
#include "errors/structure_mutator.hpp"
#include "generator/xml/parse.hpp"
#include "read.hpp"
#include "source_dir.hpp"

using namespace finemote::gen;
using finemote::test::read;
namespace fs = std::filesystem;
using Json = nlohmann::json;

namespace {

const fs::path kSource = finemote::test::source_dir();

/// Counts what becomes of mutants, and keeps the first that nothing explains.
struct Bench {
  Pipeline pipeline{(kSource / "examples").string()};
  std::size_t generated = 0, unschedulable = 0, refused = 0, unexplained = 0;
  std::string first_unexplained;

  void run(const std::string& text, bool is_xacro = false) {
    INFO(text);  // shown when a mutant throws
    const Outcome outcome = pipeline.run(text, is_xacro);
    switch (outcome.kind) {
      case Outcome::Kind::generated:
        ++generated;
        break;
      case Outcome::Kind::unschedulable:
        ++unschedulable;
        break;
      case Outcome::Kind::refused:
        ++refused;
        break;
      case Outcome::Kind::unexplained:
        if (++unexplained == 1) first_unexplained = text + "\n" + outcome.said;
    }
  }
  void check() const {
    INFO(first_unexplained);
    CHECK(unexplained == 0);
  }
};

/// An attribute of a text, with the blank before it.
struct Stretch {
  std::size_t begin, end;
};

std::vector<Stretch> find_attributes(const std::string& text) {
  std::vector<Stretch> found;
  for (std::size_t quote = text.find("=\""); quote != std::string::npos; quote = text.find("=\"", quote)) {
    const std::size_t begin = text.find_last_of(" \n", quote);
    const std::size_t close = text.find('"', quote + 2);
    if (begin == std::string::npos || close == std::string::npos) break;
    found.push_back({begin, close + 1});
    quote = close + 1;
  }
  return found;
}

#ifdef __SANITIZE_ADDRESS__
constexpr std::size_t kStride = 29;  // slow: a character in 29, an attribute in 3, a quarter of the random mutants
constexpr std::size_t kAttributeStride = 3;
constexpr int kMutants = 100;
#else
constexpr std::size_t kStride = 1;
constexpr std::size_t kAttributeStride = 1;
constexpr int kMutants = 400;
#endif

struct Example {
  std::string text;
  bool is_xacro;
};

/// `.urdf` and `.urdf.xacro` examples, by name.
std::vector<Example> examples() {
  std::vector<fs::path> paths;
  for (const auto& entry : fs::directory_iterator(kSource / "examples")) {
    if (entry.path().extension() == ".urdf" || entry.path().extension() == ".xacro") paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  std::vector<Example> found;
  for (const fs::path& path : paths) found.push_back({read(path), path.extension() == ".xacro"});
  return found;
}

/// FINEMOTE_MUTANTS multiplies the number of random mutants, for long runs by hand.
int effort() {
  const char* wish = std::getenv("FINEMOTE_MUTANTS");
  return wish == nullptr ? 1 : std::max(1, std::atoi(wish));
}

/// A descriptor in which one value became another one, or one member lost its name or itself.
class DescriptorMutator {
 public:
  explicit DescriptorMutator(Json descriptor) : descriptor_(std::move(descriptor)) {
    const Json flat = descriptor_.flatten();
    for (const auto& [place, value] : flat.items()) {
      for (Json::json_pointer at(place); !at.empty(); at.pop_back()) places_.push_back(at);
    }
  }
  [[nodiscard]] Json operator()(std::mt19937& random) const {
    static const std::vector<Json> kValues{nullptr,
                                           true,
                                           0,
                                           -1,
                                           1.5,
                                           18446744073709551615U,
                                           "",
                                           "x",
                                           "any",
                                           "1ms",
                                           "0x80",
                                           Json::array(),
                                           Json::object(),
                                           Json::array({1, "a"}),
                                           Json{{"name", "x"}}};
    Json mutant = descriptor_;
    for (std::size_t further = 1 + random() % 3; further > 0; --further) {
      const Json::json_pointer& place = places_[random() % places_.size()];
      const Json::json_pointer parent = place.parent_pointer();
      if (!mutant.contains(place) || place.empty()) continue;
      const bool is_member = mutant.at(parent).is_object();
      const Json value = mutant.at(place);
      if (random() % 3 == 0 || !is_member) {
        mutant[place] = kValues[random() % kValues.size()];
      } else {
        mutant[parent].erase(place.back());
        if (random() % 2 == 0) mutant[parent][place.back() + "s"] = value;
      }
    }
    return mutant;
  }

 private:
  Json descriptor_;
  std::vector<Json::json_pointer> places_;
};

/// A robot with one device of the type `mutant`, given all that the type asked for before it was damaged.
std::string robot_of(const Json& descriptor) {
  std::string bus, place;
  if (descriptor.contains("bus")) {
    const auto kind = descriptor["bus"]["types"][0].get<std::string>();
    const std::string port = kind == "uart" || kind == "rs485" ? "usart1"
                             : kind == "i2c"                   ? "i2c2"
                             : kind == "spi"                   ? "spi1"
                             : kind == "can"                   ? "can1"
                                                               : "pwm1";
    const std::string rate = kind == "uart" || kind == "rs485" ? " baud=\"100000baud\""
                             : kind == "spi"                   ? " clock=\"5250kHz\""
                                                               : "";
    bus = "<bus name=\"b\" type=\"" + kind + "\" port=\"" + port + "\"" + rate + "/>";
    place = " bus=\"b\"";
    for (const auto& [name, value] :
         {std::pair<const char*, const char*>{"address", "0x30"}, {"channel", "0"}, {"id", "1"}}) {
      if (descriptor["bus"].contains(name)) place += std::string(" ") + name + "=\"" + value + "\"";
    }
  }
  std::string params;
  for (const Json& param : descriptor.value("params", Json::array())) {
    params += "<param name=\"" + param.value("name", "x") + "\">1</param>";
  }
  return "<robot name=\"r\"><link name=\"l\"/><finemote version=\"1\"><board name=\"robomaster_type_c\"/>" + bus +
         "<device name=\"d\" type=\"mutant\" period=\"10ms\"" + place + ">" + params +
         "<device name=\"child\" type=\"sim_load\"/></device></finemote></robot>";
}

/// Shipped files of a kind, in order of name.
std::vector<fs::path> json_files(const char* kind) {
  std::vector<fs::path> paths;
  for (const auto& entry : fs::directory_iterator(kSource / "schemas" / kind)) paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  return paths;
}

/// A folder of robots whose `devices/` holds one damaged descriptor after the other.
class MutantFolder {
 public:
  explicit MutantFolder(const std::string& name)
      : folder_(fs::temp_directory_path() / ("finemote_mutants_" + name + "_" + std::to_string(getpid()))) {
    fs::create_directories(folder_ / "devices");
    std::ofstream(folder_ / "devices" / "mutant.hpp") << "#pragma once\n";
  }
  MutantFolder(const MutantFolder&) = delete;
  MutantFolder& operator=(const MutantFolder&) = delete;
  ~MutantFolder() { fs::remove_all(folder_); }

  void run(const Json& descriptor, const std::string& robot, int times) {
    const DescriptorMutator mutate(descriptor);
    for (int i = 0; i < times; ++i) {
      const std::string mutant = mutate(random_).dump(1);
      INFO(mutant);
      std::ofstream(folder_ / "devices" / "mutant.json") << mutant;
      Pipeline pipeline(folder_.string());
      const Outcome outcome = pipeline.run(robot, false);
      INFO(outcome.said);
      CHECK(outcome.kind != Outcome::Kind::unexplained);
      if (outcome.kind == Outcome::Kind::refused) ++refused;
    }
  }

  std::size_t refused = 0;

 private:
  fs::path folder_;
  std::mt19937 random_{20240609};  // fixed: the same mutants on every run
};

}  // namespace

TEST_CASE("every single character of finsrov may be missing") {
  const std::string text = read(kSource / "examples" / "finsrov.urdf");
  Bench bench;
  for (std::size_t i = 0; i < text.size(); i += kStride) bench.run(text.substr(0, i) + text.substr(i + 1));
  bench.check();
  CHECK(bench.refused > 1000 / kStride);
  CHECK(bench.generated > 1000 / kStride);  // blanks, comments, digits
  CHECK((bench.unschedulable > 0 || kStride > 1));
}

TEST_CASE("every attribute of every example may be missing") {
  Bench bench;
  for (const Example& example : examples()) {
    const std::vector<Stretch> attributes = find_attributes(example.text);
    for (std::size_t i = 0; i < attributes.size(); i += kAttributeStride) {
      const Stretch& at = attributes[i];
      bench.run(example.text.substr(0, at.begin) + example.text.substr(at.end), example.is_xacro);
    }
  }
  bench.check();
  CHECK(bench.refused > 100);
}

TEST_CASE("values and elements of the examples may be exchanged, copied, moved and removed, one or several at once") {
  std::mt19937 random(20240607);  // fixed: the same mutants on every run
  Bench bench;
  const StructureMutator::FindType find_type = [&](std::string_view name) { return bench.pipeline.device_type(name); };
  for (const Example& example : examples()) {
    const SourceFile file{"example", "", example.text};
    Diagnostics diagnostics;
    const auto document = xml::parse(file, diagnostics);
    REQUIRE(document);
    const StructureMutator mutate(*document, find_type);
    for (int i = 0; i < kMutants * effort(); ++i) bench.run(mutate(random, static_cast<unsigned>(i)), example.is_xacro);
  }
  bench.check();
  CHECK(bench.refused > 100);
}

TEST_CASE("descriptors may be damaged, and the robot is read on") {
  MutantFolder folder("devices");
  for (const fs::path& path : json_files("devices")) {
    Json descriptor = Json::parse(read(path));
    descriptor["type"] = "mutant";
    descriptor["header"] = "mutant.hpp";
    folder.run(descriptor, robot_of(descriptor), kMutants * effort() / 10);
  }
  CHECK(folder.refused > 100);
}

TEST_CASE("descriptors of expanders may be damaged") {
  MutantFolder folder("expanders");
  for (const fs::path& path : json_files("expanders")) {
    Json descriptor = Json::parse(read(path));
    const bool is_mux = descriptor["kind"] == "mux";
    descriptor["model"] = "mutant";
    if (!is_mux) descriptor["header"] = "mutant.hpp";
    const std::string inside = is_mux ? "<channel index=\"0\" name=\"c\"/>" : "";
    const std::string device =
        is_mux ? "type=\"ms5837\" bus=\"c\" address=\"0x76\"" : "type=\"pwm_esc\" bus=\"x\" channel=\"0\"";
    const std::string robot =
        "<robot name=\"r\"><finemote version=\"1\"><board name=\"robomaster_type_c\"/>"
        "<bus name=\"b\" type=\"i2c\" port=\"i2c2\"/><expander name=\"x\" model=\"mutant\" bus=\"b\" "
        "address=\"0x70\">" +
        inside + "</expander><device name=\"d\" period=\"20ms\" " + device + "/></finemote></robot>";
    folder.run(descriptor, robot, kMutants * effort() / 4);
  }
  CHECK(folder.refused > 100 / kStride);
}
