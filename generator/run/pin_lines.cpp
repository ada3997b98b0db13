#include "generator/run/pin_lines.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/diagnostic/code_scenario.hpp"
#include "generator/image/exception.hpp"
#include "generator/units/checked.hpp"

namespace finemote::gen {
namespace {

/// Of a pin `PA0`: each of the first five numbers has a line of its own, the others share two.
std::optional<std::uint32_t> line_of(const std::string& pin) {
  constexpr std::uint32_t kFirst = 6, kAlone = 5, k5To9 = 23, k10To15 = 40;
  if (pin.size() < 3) return std::nullopt;
  std::uint32_t number = 0;
  for (std::size_t i = 2; i < pin.size(); ++i) {
    if (pin[i] < '0' || pin[i] > '9') return std::nullopt;
    number = 10 * number + static_cast<std::uint32_t>(pin[i] - '0');
  }
  if (number < kAlone) return kFirst + number;
  return number < 10 ? k5To9 : k10To15;
}

/// What the model has of an entry of a type's `interrupts`; null: it is documentation.
/// @param place  among those of the device that have this name
const timing::InterruptSource* source_of(const timing::Model& model, const std::string& name, std::size_t place) {
  for (const timing::Bus& bus : model.buses) {
    if (!bus.sources) continue;
    for (const timing::InterruptSource& source : *bus.sources) {
      if (source.name == name && place-- == 0) return &source;
    }
  }
  return nullptr;
}

std::int64_t most_runs(const timing::Model& model, const timing::InterruptSource& source, Duration window) {
  if (source.budgets.empty()) return add(floor_div(window, source.min_interval), 1);
  std::int64_t runs = 0;
  for (const timing::FrameBudget& budget : source.budgets)
    runs = add(runs, multiply(budget.count, add(ceil_div(window, model.devices[budget.device].period), 2)));
  return runs;
}

bool is_given(const Device& device, const Interrupt& entry) {
  return std::any_of(device.uses.begin(), device.uses.end(),
                     [&](const Use& use) { return use.spec->role == entry.use; });
}

/// Adds an entry of a device's type to the lines so far.
void add_entry(const Device& device, std::size_t index, const timing::Model& model, Duration window,
               std::vector<PinLine>& lines) {
  const std::vector<Interrupt>& entries = device.type->interrupts;
  const Interrupt& entry = entries[index];
  const auto place =
      std::count_if(entries.begin(), entries.begin() + static_cast<std::ptrdiff_t>(index),
                    [&](const Interrupt& one) { return one.source == entry.source && is_given(device, one); });
  const auto use =
      std::find_if(device.uses.begin(), device.uses.end(), [&](const Use& one) { return one.spec->role == entry.use; });
  const timing::InterruptSource* source =
      source_of(model, device.name.text + ": " + entry.source, static_cast<std::size_t>(place));
  if (use == device.uses.end() || use->named == nullptr || source == nullptr) return;
  const auto number = line_of(use->named->pin);
  if (!number) return;
  auto line = std::find_if(lines.begin(), lines.end(),
                           [&](const PinLine& one) { return one.exception == exception_of(*number); });
  if (line == lines.end()) line = lines.insert(line, PinLine{exception_of(*number), device.at});
  line->devices += (line->devices.empty() ? "'" : ", '") + device.name.text + "'";
  line->wcet += source->wcet;
  line->is_assumed = line->is_assumed && source->source != timing::WcetSource::computed;
  line->runs = add(line->runs, most_runs(model, *source, window));
}

}  // namespace

std::vector<PinLine> pin_lines(const Robot& robot, const timing::Model& model, Duration window) {
  std::vector<PinLine> lines;
  try {
    for (const Device& device : robot.devices) {
      if (device.type == nullptr) continue;
      for (std::size_t i = 0; i < device.type->interrupts.size(); ++i)
        add_entry(device, i, model, with_clock_error(window), lines);
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
