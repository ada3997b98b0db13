#include "generator/timing_file/use.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "generator/timing_file/computed_costs.hpp"

namespace finemote::gen {
namespace {

using State = TimingFileUse::State;

bool is_declared(const Wcet& wcet) {
  return wcet.source == Wcet::Source::budget || wcet.source == Wcet::Source::static_analysis;
}

/// A stage's time where a bound of it is known.
Duration with_bound(const Wcet& wcet, Duration given, const std::optional<Duration>& bound) {
  if (!bound) return given;
  return is_declared(wcet) ? std::max(given, *bound) : *bound;
}

void take_bounds(const StageBounds& bounds, Wcet& wcet) {
  wcet.update_static = bounds.update;
  wcet.handle_static = bounds.handle;
  const Duration update = with_bound(wcet, wcet.update, bounds.update);
  const Duration handle = with_bound(wcet, wcet.handle, bounds.handle);
  wcet.is_above_declared = is_declared(wcet) && (update > wcet.update || handle > wcet.handle);
  wcet.update = update;
  wcet.handle = handle;
  if (bounds.update) wcet.per_frame = Duration::zero();
  if (bounds.update && bounds.handle) wcet.source = Wcet::Source::computed;
}

/// Figures of a stale file are the best guess there is, and no more.
void take_guess(const StageBounds& bounds, Wcet& wcet) {
  if (wcet.source != Wcet::Source::assumed) return;
  wcet.is_of_stale_file = bounds.update && bounds.handle;
  wcet.update = bounds.update.value_or(wcet.update);
  wcet.handle = bounds.handle.value_or(wcet.handle);
  if (bounds.update) wcet.per_frame = Duration::zero();
}

/// The same of what runs beside stages, where the file knows every device that there is now.
std::optional<ComputedCosts> guessed_costs(const TimingFile& file, const Robot& robot) {
  for (const Device& device : robot.devices) {
    if (file.devices.count(device.name.text) == 0) return std::nullopt;
  }
  auto costs = computed_costs(file, robot);
  if (costs) costs->is_guess = true;
  return costs;
}

std::string words_of(const std::vector<std::string>& arguments, const std::string& board) {
  std::string text = fmt::format("{}", fmt::join(arguments, " "));
  if (!board.empty()) text += fmt::format("{}--board {}", text.empty() ? "" : " ", board);
  return text.empty() ? "no arguments" : "'" + text + "'";
}

State state_of(const TimingFile& file, const TimingQuestion& question) {
  if (file.arguments != question.arguments || file.board != question.board) return State::other;
  const bool is_same = !file.hash.empty() && file.hash == question.hash;
  return file.model == cost_model() && is_same ? State::fits : State::stale;
}

std::string why_stale(const TimingFile& file) {
  if (file.hash.empty()) return "it is of an image that was linked elsewhere, and does not say from what";
  if (file.model != cost_model())
    return fmt::format("it was computed with the cost model {} {}, this is {} {}", file.model.name, file.model.version,
                       cost_model().name, cost_model().version);
  return "the robot, its device types, the runtime or the options are not those it was computed from";
}

}  // namespace

State use_timing_file(const TimingFile& file, const TimingQuestion& question, Robot& robot, Diagnostics& diagnostics) {
  const State state = state_of(file, question);
  const std::string name = file.at.file->name;
  if (state == State::other) {
    diagnostics
        .remark(code::timing_unused, file.at,
                fmt::format("'{}' is not used: it was computed with {}, and this run is with {}", name,
                            words_of(file.arguments, file.board), words_of(question.arguments, question.board)))
        .hint(fmt::format("bounds for these arguments: finemote wcet {} ... -o {}", question.robot, name));
    return state;
  }
  if (state == State::stale) {
    diagnostics
        .warning(code::timing_stale, file.at,
                 fmt::format("the execution times in '{}' are stale: they count as assumed", name))
        .note(why_stale(file))
        .hint(fmt::format("compute them anew: finemote wcet {} -o {}", question.robot, name));
  }
  robot.computed = state == State::fits ? computed_costs(file, robot) : guessed_costs(file, robot);
  for (const DeviceId id : robot.devices.ids()) {
    const auto bounds = file.devices.find(robot.devices[id].name.text);
    if (bounds == file.devices.end()) continue;
    Wcet& wcet = robot.devices[id].wcet;
    state == State::fits ? take_bounds(bounds->second, wcet) : take_guess(bounds->second, wcet);
  }
  return state;
}

}  // namespace finemote::gen
