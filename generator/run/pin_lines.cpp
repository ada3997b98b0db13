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

/// The clock of the board is off by less.
constexpr Duration with_clock_error(Duration window) { return window + ceil_div(window, 1'000); }

/// The device that a line of interrupts is of; none: a driver's.
const Device* owner(const Robot& robot, const timing::InterruptSource& source) {
  const auto found = std::find_if(robot.devices.begin(), robot.devices.end(), [&](const Device& device) {
    return source.name.rfind(device.name.text + ": ", 0) == 0;
  });
  return found == robot.devices.end() ? nullptr : &*found;
}

std::int64_t most_runs(const timing::Model& model, const timing::InterruptSource& source, Duration window) {
  if (source.budgets.empty()) return add(floor_div(window, source.min_interval), 1);
  std::int64_t runs = 0;
  for (const timing::FrameBudget& budget : source.budgets)
    runs = add(runs, multiply(budget.count, add(ceil_div(window, model.devices[budget.device].period), 2)));
  return runs;
}

}  // namespace

std::set<std::uint32_t> pin_exceptions(const Robot& robot) {
  std::set<std::uint32_t> all;
  for (const Device& device : robot.devices) {
    for (const Use& use : device.uses) {
      const auto line =
          use.spec->function == "interrupt" && use.named != nullptr ? line_of(use.named->pin) : std::nullopt;
      if (line) all.insert(exception_of(*line));
    }
  }
  return all;
}

std::optional<PinWork> declared_pin_work(const Robot& robot, const timing::Model& model, Duration window) {
  std::optional<PinWork> work;
  for (const timing::Bus& bus : model.buses) {
    for (const timing::InterruptSource& source : bus.sources.value_or(std::vector<timing::InterruptSource>())) {
      const Device* device = owner(robot, source);
      if (device == nullptr) continue;
      if (!work) work = PinWork{device->at, {}, true, 0};
      work->wcet += source.wcet;
      work->is_computed = work->is_computed && source.source == timing::WcetSource::computed;
      work->runs = add(work->runs, most_runs(model, source, with_clock_error(window)));
    }
  }
  return work;
}

bool check_pin_edges(const Robot& robot, const timing::Model& model, const RunRecord& record,
                     Diagnostics& diagnostics) {
  const auto declared = declared_pin_work(robot, model, record.traffic_window);
  const std::set<std::uint32_t> pins = pin_exceptions(robot);
  std::int64_t seen = 0;
  for (const RoutineTime& routine : record.routine_times) {
    if (pins.count(routine.exception) != 0) seen += routine.runs;
  }
  if (!declared || seen <= declared->runs) return true;
  diagnostics
      .error(
          code::undeclared_traffic, declared->at,
          fmt::format("pins interrupt more often than devices declare: in {:.3f} ms {} times, where what is declared "
                      "makes {} at most",
                      record.traffic_window.ns() / 1e6, seen, declared->runs))
      .note("bounds of all that these interrupts delay are made from what is declared")
      .hint("let 'interrupts' in the descriptors say how often their lines interrupt");
  return false;
}

}  // namespace finemote::gen
