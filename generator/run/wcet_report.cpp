#include "generator/run/wcet_report.hpp"

#include <fmt/format.h>

#include "generator/forest/stage.hpp"
#include "generator/run/code_line.hpp"
#include "generator/run/wcet_scheduler.hpp"
#include "generator/timing_file/timing_file.hpp"

namespace finemote::gen {
namespace {

using Json = nlohmann::ordered_json;
using wcet::Cycles;

const char* name_of(wcet::Placement placement) { return placement == wcet::Placement::sram ? "sram" : "flash"; }

Json place_of(std::uint32_t address, const std::string& function, const TimedRobot& timed) {
  const auto line = code_line(timed.lines, address);
  return {{"function", function},
          {"file", line ? Json(timed.names.of(line->file)) : Json()},
          {"line", line ? Json(line->line) : Json()}};
}

Json stage_json(const TimedRobot& timed, Stage stage, const wcet::BracketTime& bracket) {
  Json loops = Json::array();
  for (const wcet::LoopTime& loop : bracket.loops) {
    Json place = place_of(loop.address, loop.function, timed);
    place["bound"] = loop.rounds;
    place["from"] = loop.is_by_mark ? "mark" : "code";
    loops.push_back(std::move(place));
  }
  return {{"device", timed.robot.devices[timed.forest.order[stage.rank]].name.text},
          {"stage", stage_name(stage.is_handle)},
          {"wcet_ns", ns_of(bracket.cycles, timed)},
          {"without_faults_ns", ns_of(bracket.without_faults.value_or(bracket.cycles), timed)},
          {"wcet_cycles", bracket.cycles},
          {"label", "static"},
          {"loops", std::move(loops)}};
}

/// Times of a stage or a routine: with faults, and without them where that is less.
std::string row(const std::string& name, Cycles cycles, std::optional<Cycles> without_faults, const TimedRobot& timed) {
  const auto us = [&](Cycles c) { return static_cast<double>(ns_of(c, timed)) / 1e3; };
  return fmt::format("  {:<32} {:>9} {:>12.3f} {:>12.3f}\n", name, cycles, us(cycles),
                     us(without_faults.value_or(cycles)));
}

std::string head(const char* what) {
  return fmt::format("  {:<32} {:>9} {:>12} {:>12}\n", what, "cycles", "us", "no fault, us");
}

/// Stages without a bound, for whatever reason: all of a bucket are of one routine.
std::string unbounded_stages(const TimedRobot& timed) {
  std::string text;
  for (const Stage stage : stages_of(timed)) {
    if (bracket_of(timed, stage) != nullptr) continue;
    text += (text.empty() ? "  " : ", ") + name_of(timed, stage);
  }
  return text.empty() ? "" : "\nwithout a bound therefore, as a bucket is bounded as a whole\n" + text + "\n";
}

}  // namespace

std::vector<Stage> stages_of(const TimedRobot& timed) {
  std::vector<Stage> stages;
  for (const Rank rank : timed.forest.order.ids()) {
    stages.push_back({rank, false});
    stages.push_back({rank, true});
  }
  return stages;
}

std::string name_of(const TimedRobot& timed, Stage stage) {
  return timed.robot.devices[timed.forest.order[stage.rank]].name.text + "." + stage_name(stage.is_handle);
}

std::string name_of(const TimedRobot& timed, const wcet::RoutineTime& routine) {
  const auto task = task_of(timed, routine.exception);
  return task ? task->name : interrupt_name(timed, routine);
}

const wcet::BracketTime* bracket_of(const TimedRobot& timed, Stage stage) {
  const std::uint32_t mark = 2 * stage.number();
  for (const wcet::RoutineTime& routine : timed.times.routines) {
    for (const wcet::BracketTime& bracket : routine.brackets) {
      if (bracket.mark == mark) return &bracket;
    }
  }
  return nullptr;
}

std::string code_place(std::uint32_t address, const TimedRobot& timed) {
  const auto line = code_line(timed.lines, address);
  return line ? fmt::format("{}:{}", timed.names.of(line->file), line->line) : fmt::format("0x{:08x}", address);
}

Json wcet_document(const TimedRobot& timed) {
  Json document{{"schema", kTimingSchema}, {"robot", timed.robot.name.text}};
  Json stages = Json::array(), unresolved = Json::array();
  for (const Stage stage : stages_of(timed)) {
    if (const auto* bracket = bracket_of(timed, stage)) stages.push_back(stage_json(timed, stage, *bracket));
  }
  for (const wcet::TimeGap& gap : timed.times.gaps) {
    Json place = place_of(gap.address, gap.function, timed);
    place["why"] = gap.why;
    place["called_from"] = Json::array();
    for (const wcet::CodePlace& call : gap.calls)
      place["called_from"].push_back(place_of(call.address, call.function, timed));
    unresolved.push_back(std::move(place));
  }
  document["stages"] = std::move(stages);
  document["interrupts"] = interrupts_json(timed);
  document["scheduler"] = scheduler_json(timed);
  document["unresolved"] = std::move(unresolved);
  document["model"] = {
      {"name", cost_model().name}, {"version", cost_model().version}, {"placement", name_of(timed.inputs.placement)}};
  const auto or_null = [](const std::string& text) { return text.empty() ? Json() : Json(text); };
  document["inputs"] = {{"compiler", or_null(timed.inputs.compiler)},
                        {"options", {{"board", or_null(timed.inputs.board)}}},
                        {"arguments", timed.inputs.arguments},
                        {"hash", or_null(timed.inputs.hash)}};
  return document;
}

std::string wcet_text(const TimedRobot& timed) {
  std::string text = fmt::format("longest execution times, code in {}, {} MHz\n\n", name_of(timed.inputs.placement),
                                 timed.inputs.clock_hz / 1'000'000);
  text += head("stage");
  for (const Stage stage : stages_of(timed)) {
    const auto* bracket = bracket_of(timed, stage);
    if (bracket != nullptr) text += row(name_of(timed, stage), bracket->cycles, bracket->without_faults, timed);
  }
  text += "\n" + head("interrupt");
  for (const wcet::RoutineTime& routine : timed.times.routines)
    text += row(name_of(timed, routine), routine.cycles, routine.without_faults, timed);
  if (timed.times.gaps.empty()) return text;
  text += "\nwithout a bound\n";
  for (const wcet::TimeGap& gap : timed.times.gaps) {
    text += fmt::format("  {}: in '{}': {}\n", code_place(gap.address, timed), gap.function, gap.why);
    for (const wcet::CodePlace& call : gap.calls)
      text += fmt::format("    called at {}, in '{}'\n", code_place(call.address, timed), call.function);
  }
  return text + unbounded_stages(timed);
}

}  // namespace finemote::gen
