#include "generator/run/wcet_explain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <vector>

namespace finemote::gen {
namespace {

using wcet::Cycles;

constexpr std::size_t kMostLines = 20;

struct Way {
  std::string title;
  Cycles cycles;
  const std::vector<wcet::PathStep>& path;
};

/// Of a stage or a routine. Where faults make it longer, the way without them follows, which the analysis counts.
template <class Timed>
std::vector<Way> ways_of(const Timed& timed) {
  std::vector<Way> ways = {{"on the longest way", timed.cycles, timed.path}};
  if (timed.without_faults && *timed.without_faults < timed.cycles)
    ways.push_back({"on the longest way without faults", *timed.without_faults, timed.path_without_faults});
  return ways;
}

/// None: there is no such row.
std::vector<Way> ways_named(const TimedRobot& timed, const std::string& name) {
  for (const Stage stage : stages_of(timed)) {
    const auto* bracket = name_of(timed, stage) == name ? bracket_of(timed, stage) : nullptr;
    if (bracket != nullptr) return ways_of(*bracket);
  }
  for (const wcet::RoutineTime& routine : timed.times.routines) {
    if (name_of(timed, routine) == name) return ways_of(routine);
  }
  return {};
}

/// A line of code and the function that it is in.
struct LineShare {
  std::string line;
  Cycles cycles = 0;
  std::size_t passes = 0;
};

/// Dearest first.
std::vector<LineShare> shares_of(const Way& way, const TimedRobot& timed) {
  std::map<std::string, LineShare> by_line;
  for (const wcet::PathStep& step : way.path) {
    const std::string line = fmt::format("{}, {}", code_place(step.address, timed), step.function);
    LineShare& share = by_line[line];
    share = {line, share.cycles + step.cycles, share.passes + 1};
  }
  std::vector<LineShare> shares;
  for (auto& [line, share] : by_line) shares.push_back(std::move(share));
  std::stable_sort(shares.begin(), shares.end(),
                   [](const LineShare& a, const LineShare& b) { return a.cycles > b.cycles; });
  return shares;
}

std::string pieces_text(const Way& way, const TimedRobot& timed) {
  std::string text = fmt::format("  {:>8} {:>8}  {:<10}  {}\n", "from", "cycles", "address", "line, function");
  Cycles begin = 0;
  for (const wcet::PathStep& step : way.path) {
    text += fmt::format("  {:>8} {:>8}  0x{:08x}  {}, {}\n", begin, step.cycles, step.address,
                        code_place(step.address, timed), step.function);
    begin += step.cycles;
  }
  return text;
}

std::string shares_text(const Way& way, const TimedRobot& timed) {
  const std::vector<LineShare> shares = shares_of(way, timed);
  const std::size_t count = std::min(shares.size(), kMostLines);
  std::string text = fmt::format("  {:>8} {:>7} {:>10}  {}\n", "cycles", "share", "passes", "line, function");
  for (std::size_t i = 0; i < count; ++i) {
    const double percent = 100.0 * static_cast<double>(shares[i].cycles) / static_cast<double>(way.cycles);
    text += fmt::format("  {:>8} {:>5.1f} % {:>10}  {}\n", shares[i].cycles, percent, shares[i].passes, shares[i].line);
  }
  if (count < shares.size()) text += fmt::format("  and {} more lines\n", shares.size() - count);
  return text;
}

}  // namespace

std::optional<std::string> explain_longest_way(const TimedRobot& timed, const std::string& name) {
  std::string text;
  for (const Way& way : ways_named(timed, name)) {
    text += fmt::format("{}{}: {} cycles {}\n\n{}\nby line\n{}", text.empty() ? "" : "\n", name, way.cycles, way.title,
                        pieces_text(way, timed), way.cycles > 0 ? shares_text(way, timed) : "");
  }
  return text.empty() ? std::nullopt : std::optional(text);
}

}  // namespace finemote::gen
