#include "tests/emulator/routines.hpp"

#include <algorithm>
#include <fstream>

namespace finemote::test {
namespace {

using Json = nlohmann::json;

/// What runs at one level of preemption. Times in picoseconds.
struct Level {
  int exception = 0;  ///< 0: the idle loop
  std::int64_t begin = 0;
  std::int64_t own = 0, stages = 0;
  std::map<int, std::int64_t> open;  ///< stages, with `own` at their start
};

/// Follows the record from line to line.
class Follower {
 public:
  explicit Follower(std::map<int, Routine>& routines) : routines_(routines) {}

  void take(const std::string& what, std::int64_t t, const Json& line) {
    levels_.back().own += t - last_;
    last_ = t;
    if (what == "reset") levels_ = {Level{}};
    if (what == "tail" || what == "resume") leave();
    if (what == "enter" || what == "tail") levels_.push_back({line["exception"].get<int>(), t, 0, 0, {}});
    if (what == "begin") levels_.back().open[line["stage"]] = levels_.back().own;
    if (what == "end") end_stage(line["stage"]);
  }

 private:
  void end_stage(int stage) {
    Level& level = levels_.back();
    const auto open = level.open.find(stage);
    if (open == level.open.end()) return;
    level.stages += level.own - open->second;
    level.open.erase(open);
  }

  void leave() {
    if (levels_.size() < 2) return;
    const Level level = levels_.back();
    levels_.pop_back();
    Routine& routine = routines_[level.exception];
    routine.begins.push_back(static_cast<double>(level.begin) / 1000);
    routine.own.push_back(static_cast<double>(level.own) / 1000);
    routine.around.push_back(static_cast<double>(level.own - level.stages) / 1000);
  }

  std::map<int, Routine>& routines_;
  std::vector<Level> levels_{Level{}};
  std::int64_t last_ = 0;
};

}  // namespace

std::map<int, Routine> routines_of(const std::string& audit) {
  std::map<int, Routine> routines;
  Follower follower(routines);
  std::ifstream lines(audit);
  for (std::string text; std::getline(lines, text);) {
    const Json line = Json::parse(text);
    const std::string what = line["what"];
    if (what == "robot") {
      for (const auto& [number, meaning] : line["exceptions"].items()) routines[std::stoi(number)].meaning = meaning;
      continue;
    }
    constexpr const char* kSwitches[] = {"reset", "enter", "tail", "resume", "begin", "end"};
    if (std::find(std::begin(kSwitches), std::end(kSwitches), what) != std::end(kSwitches))
      follower.take(what, line["t"], line);
  }
  return routines;
}

double longest(const std::vector<double>& times) {
  return times.empty() ? 0 : *std::max_element(times.begin(), times.end());
}

}  // namespace finemote::test
