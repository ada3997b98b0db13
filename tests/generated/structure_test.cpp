// What `generate` accepts compiles: structural mutations of the examples and of robots of the tests, for host and
// board.
//
//   structure_test [--mutations N] [--seed S] [--keep DIR]
//
// Without arguments the fixed part that every test run does. The full run is `structure_test --mutations 20000 --keep
// DIR`: every robot that fails is left in DIR with what was said of it. The last line counts mutations, accepted and
// compiled robots, and failures; exit 1 when there are any.
//
// Robots are compiled many to a translation unit (batch.hpp), as far as assembly: without optimisation for the host,
// with that of the firmware for the board. One in forty is compiled file by file too, as a user's project does it; only
// that sees includes that are missing. Robots that differ in their name alone are compiled once.
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <functional>
#include <future>
#include <map>
#include <random>
#include <set>

#include "cli/program.hpp"
#include "errors/pipeline.hpp"
#include "errors/structure_mutator.hpp"
#include "generated/batch.hpp"
#include "generated/compiler.hpp"
#include "generator/xml/parse.hpp"

using namespace finemote;
using namespace finemote::test;
namespace fs = std::filesystem;

namespace {

struct Wish {
  unsigned mutations = 600;
  unsigned seed = 20261122;
  std::string keep;
};

constexpr std::size_t kBatch = 40;
constexpr std::size_t kByFile = 40;  ///< one robot in this many is compiled file by file

const std::vector<std::string> kRobots{"examples/finsrov.urdf",
                                       "examples/infantry.urdf",
                                       "examples/six_joint_arm.urdf",
                                       "examples/two_devices.urdf",
                                       "examples/deep_forest.urdf",
                                       "examples/user_device.urdf",
                                       "tests/link/link.urdf",
                                       "tests/unit/idle_buses.urdf",
                                       "tests/emulator/robots/rover.urdf",
                                       "tests/emulator/robots/rig.urdf",
                                       "tests/emulator/robots/crane.urdf",
                                       "tests/emulator/images/onboard/onboard.urdf",
                                       "tests/emulator/images/sensors/sensors.urdf",
                                       "tests/generated/robots/probes.urdf"};

/// Where the descriptors and headers of users' types are.
std::vector<std::string> user_folders() {
  return {source_path("examples/devices"), source_path("tests/generated/robots/devices"),
          source_path("tests/emulator/images/onboard/devices"), source_path("tests/emulator/images/sensors/devices")};
}

/// Compiles what is accepted, and counts.
class Judge {
 public:
  explicit Judge(std::string keep) : keep_(std::move(keep)) {}

  void take(Generated robot) {
    ++accepted_;
    if (const std::string line = not_finite(robot); !line.empty()) fail(robot, "not finite: " + line);
    if (!known_.insert(std::hash<std::string>{}(nameless(robot))).second) return;
    if (!spaces_.insert(robot.space).second) {
      compile_batch();
      spaces_.insert(robot.space);
    }
    if (compiled_++ % kByFile == 0) compile_by_file(robot);
    batch_.push_back(std::move(robot));
    if (batch_.size() == kBatch) compile_batch();
  }
  void fail(const Generated& robot, const std::string& said) {
    ++failures_;
    std::printf("FAILED: %s\n", said.substr(0, 1500).c_str());
    if (keep_.empty()) {
      std::printf("%s\n", robot.input.c_str());
    } else {
      const std::string stem = keep_ + "/" + std::to_string(failures_);
      write_file(stem + ".urdf", robot.input);
      write_file(stem + ".txt", said);
    }
    std::fflush(stdout);
  }
  void compile_batch() {
    if (!batch_.empty()) compile(batch_);
    batch_.clear();
    spaces_.clear();
  }
  [[nodiscard]] bool report(unsigned mutations) const {
    std::printf("%u mutations, %zu accepted, %zu compiled for %zu targets, %zu failures\n", mutations, accepted_,
                compiled_, compilers_.size(), failures_);
    return failures_ == 0;
  }
  [[nodiscard]] std::size_t accepted() const { return accepted_; }

 private:
  /// What the compilers say of robots in one unit, each at the same time as the other.
  std::string said_of(const std::vector<Generated>& robots) {
    const std::string source = folder_.path("batch.cpp");
    write_file(source, translation_unit(robots));
    std::vector<std::future<std::string>> answers;
    for (const Compiler& compiler : compilers_)
      answers.push_back(std::async(std::launch::async, [&] { return complaint(compiler, source, user_folders()); }));
    std::string said;
    for (auto& answer : answers) said += answer.get();
    return said;
  }
  /// Halves a batch that does not compile until the robots to blame stand alone.
  void compile(const std::vector<Generated>& robots) {
    const std::string said = said_of(robots);
    if (said.empty()) return;
    if (robots.size() == 1) return fail(robots.front(), said);
    const auto middle = robots.begin() + static_cast<std::ptrdiff_t>(robots.size() / 2);
    const std::size_t before = failures_;
    compile({robots.begin(), middle});
    compile({middle, robots.end()});
    if (failures_ == before) fail(robots.front(), "only together with others: " + said);
  }
  void compile_by_file(const Generated& robot) {
    const TemporaryFolder folder;
    for (const gen::OutputFile& file : robot.files) write_file(folder.path(file.name), file.text);
    for (const Compiler& compiler : compilers_) {
      const std::string said = complaint_about(compiler, folder.path(), user_folders());
      if (!said.empty()) fail(robot, "by file: " + said);
    }
  }

  std::string keep_;
  std::vector<Compiler> compilers_ = test::compilers();
  TemporaryFolder folder_;
  std::vector<Generated> batch_;
  std::set<std::string> spaces_;
  std::set<std::size_t> known_;
  std::size_t accepted_ = 0, compiled_ = 0, failures_ = 0;
};

std::vector<gen::xml::Document> read_robots(gen::Sources& sources) {
  std::vector<gen::xml::Document> robots;
  for (const std::string& name : kRobots) {
    gen::Diagnostics diagnostics;
    auto document = gen::xml::parse(*sources.add({name, "", read_file(source_path(name))}), diagnostics);
    if (!document) throw std::runtime_error("cannot read " + name);
    robots.push_back(std::move(*document));
  }
  return robots;
}

bool run(const Wish& wish) {
  gen::Pipeline pipeline({}, user_folders());
  const gen::StructureMutator::FindType find_type = [&](std::string_view name) { return pipeline.device_type(name); };
  gen::Sources sources;
  const std::vector<gen::xml::Document> robots = read_robots(sources);
  std::mt19937 random(wish.seed);
  Judge judge(wish.keep);
  for (unsigned i = 0; i < wish.mutations; ++i) {
    Generated mutant;
    mutant.input = gen::StructureMutator(robots[i % robots.size()], find_type)(random, i);
    try {
      gen::Outcome outcome = pipeline.run(mutant.input);
      if (outcome.kind == gen::Outcome::Kind::unexplained) judge.fail(mutant, "unexplained: " + outcome.said);
      if (outcome.files.empty()) continue;
      mutant.files = std::move(outcome.files);
      mutant.space = outcome.space;
    } catch (const std::exception& bug) {
      judge.fail(mutant, std::string("exception: ") + bug.what());
      continue;
    }
    judge.take(std::move(mutant));
  }
  judge.compile_batch();
  const bool is_steered = judge.accepted() * 10 >= wish.mutations;
  if (!is_steered) std::printf("fewer than one in ten was accepted: the mutations say little\n");
  return judge.report(wish.mutations) && is_steered;
}

}  // namespace

int main(int argc, char** argv) {
  Wish wish;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string word = argv[i];
    if (word == "--mutations") wish.mutations = static_cast<unsigned>(std::strtoul(argv[i + 1], nullptr, 10));
    if (word == "--seed") wish.seed = static_cast<unsigned>(std::strtoul(argv[i + 1], nullptr, 10));
    if (word == "--keep") wish.keep = argv[i + 1];
  }
  return run(wish) ? 0 : 1;
}
