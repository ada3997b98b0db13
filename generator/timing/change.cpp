#include "generator/timing/change.hpp"

#include <algorithm>

namespace finemote::gen::timing {
namespace {

bool has_period(const Model& model, Duration period) {
  return std::any_of(model.devices.begin(), model.devices.end(),
                     [&](const Device& device) { return device.period == period; });
}

std::optional<Model> change_periods(Model model, const std::vector<Change>& changes) {
  const Model before = model;
  for (const Change& change : changes) {
    if (change.kind == Change::Kind::rate || change.kind == Change::Kind::bus) return std::nullopt;
    if (change.kind != Change::Kind::period) continue;
    for (const Rank d : change.devices) model.devices[d].period = change.period;
  }
  if (!keeps_outputs_together(before, model)) return std::nullopt;
  for (Flush& flush : model.flushes) {
    if (!flush.devices.empty()) flush.period = model.devices[flush.devices.front()].period;
    if (!has_period(model, flush.period)) return std::nullopt;
  }
  change_work(model, changes);
  return model;
}

}  // namespace

Remodel model_remodel(const Model& model) {
  return [model](const std::vector<Change>& changes) { return change_periods(model, changes); };
}

void change_work(Model& model, const std::vector<Change>& changes) {
  const auto scale = [](Duration& time, std::int64_t permille) {
    const Duration thousandth = floor_div(time, 1000);
    time = thousandth * permille + floor_div((time - thousandth * 1000) * permille, 1000);
  };
  for (const Change& change : changes) {
    if (change.kind != Change::Kind::work) continue;
    for (const Rank d : change.devices) {
      Device& device = model.devices[d];
      scale(device.update_wcet, change.value);
      scale(device.handle_wcet, change.value);
      device.update_bcet = std::min(device.update_bcet, device.update_wcet);
      device.handle_bcet = std::min(device.handle_bcet, device.handle_wcet);
    }
  }
}

bool keeps_outputs_together(const Model& before, const Model& after) {
  return std::all_of(before.flushes.begin(), before.flushes.end(), [&](const Flush& flush) {
    return std::all_of(flush.devices.begin(), flush.devices.end(),
                       [&](Rank d) { return after.devices[d].period == after.devices[flush.devices.front()].period; });
  });
}

}  // namespace finemote::gen::timing
