#include "generator/run/pin_lines.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/board_sources/port_objects.hpp"
#include "generator/diagnostic/code_scenario.hpp"
#include "generator/image/exception.hpp"
#include "generator/model/part_clock.hpp"
#include "generator/units/checked.hpp"

namespace finemote::gen {
namespace {

std::int64_t most_runs(const timing::Model& model, const timing::InterruptSource& source, Duration window) {
  if (source.budgets.empty()) return add(floor_div(window, source.min_interval), 1);
  std::int64_t runs = 0;
  for (const timing::FrameBudget& budget : source.budgets)
    runs = add(runs, multiply(budget.count, add(ceil_div(window, model.devices[budget.device].period), 2)));
  return runs;
}

Position place_of(const Robot& robot, const std::string& device) {
  const auto found = std::find_if(robot.devices.begin(), robot.devices.end(),
                                  [&](const Device& one) { return one.name.text == device; });
  return found == robot.devices.end() ? Position{} : found->at;
}

void add_source(const Robot& robot, const timing::Model& model, const timing::InterruptSource& source, Duration window,
                std::vector<PinLine>& lines) {
  const std::string& device = model.devices[source.pin->device].name;
  const std::uint32_t exception = exception_of(edge_interrupt(pin_name(source.pin->name)));
  auto line = std::find_if(lines.begin(), lines.end(), [&](const PinLine& one) { return one.exception == exception; });
  if (line == lines.end()) line = lines.insert(line, PinLine{exception, place_of(robot, device)});
  line->devices += (line->devices.empty() ? "'" : ", '") + device + "'";
  line->wcet += source.wcet;
  line->is_assumed = line->is_assumed && source.source != timing::WcetSource::computed;
  line->runs = add(line->runs, most_runs(model, source, window));
}

}  // namespace

std::vector<PinLine> pin_lines(const Robot& robot, const timing::Model& model, Duration window) {
  std::vector<PinLine> lines;
  try {
    for (const timing::Bus& bus : model.buses) {
      if (!bus.sources) continue;
      for (const timing::InterruptSource& source : *bus.sources)
        if (source.pin) add_source(robot, model, source, longest_counted(robot, window), lines);
    }
  } catch (const Overflow&) {
    lines.clear();
  }
  return lines;
}

std::vector<MeasuredPins> measure_pins(const Robot& robot, const timing::Model& model, const RunRecord& record) {
  std::vector<MeasuredPins> all;
  for (PinLine& line : pin_lines(robot, model, record.traffic_window)) {
    std::int64_t seen = 0;
    for (const RoutineTime& routine : record.routine_times) {
      if (routine.exception == line.exception) seen = routine.runs;
    }
    const std::int64_t most = line.runs;
    all.push_back({std::move(line), record.traffic_window, {seen, most}});
  }
  return all;
}

bool check_pin_edges(const std::vector<MeasuredPins>& pins, Diagnostics& diagnostics) {
  bool holds = true;
  for (const MeasuredPins& measured : pins) {
    if (measured.judged() != Judgement::broken) continue;
    holds = false;
    diagnostics
        .error(code::undeclared_traffic, measured.line.at,
               fmt::format("the pins of {} interrupt more often than is declared: in {:.3f} ms {} times, where what is "
                           "declared makes {} at most",
                           measured.line.devices, measured.window.ns() / 1e6, measured.runs.seen, *measured.runs.most))
        .note("bounds of all that these interrupts delay are made from what is declared")
        .hint("let 'interrupts' in the descriptor say how often its line interrupts");
  }
  return holds;
}

}  // namespace finemote::gen
