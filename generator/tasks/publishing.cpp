#include "generator/tasks/publishing.hpp"

#include <cstdint>
#include <optional>
#include <set>

#include "generator/forest/stage.hpp"

namespace finemote::gen::timing {
namespace {

Duration& extra_of(Model& model, const Stage& stage) {
  Device& device = model.devices[stage.rank];
  return stage.is_handle ? device.handle_extra : device.update_extra;
}

/// The one that follows in the job: updates in the order of the devices, then handles against it.
std::optional<Stage> next(const Model& model, const Stage& stage) {
  std::optional<Stage> earlier, later;
  bool is_behind = false;
  const Duration period = model.devices[stage.rank].period;
  for (const Rank device : model.devices.ids()) {
    if (device == stage.rank) {
      is_behind = true;
    } else if (model.devices[device].period == period) {
      if (is_behind && !later) later = Stage{device, false};
      if (!is_behind) earlier = Stage{device, true};
    }
  }
  if (stage.is_handle) return earlier;
  return later ? later : Stage{stage.rank, true};
}

}  // namespace

void charge_publishing(const Robot& robot, const Forest& forest, const Schedule& schedule, Model& model) {
  std::set<std::uint32_t> charged;  // numbers of stages
  for (const Crossing& crossing : schedule.crossings) {
    if (crossing.kind != Crossing::Kind::to_fast) continue;
    const Stage stage{forest.rank[crossing.producer], crossing.direction == Crossing::Direction::command};
    if (!charged.insert(stage.number()).second) continue;
    const std::optional<Stage> following = next(model, stage);
    if (!following) {
      extra_of(model, stage) += robot.computed->behind_jobs(model.devices[stage.rank].period);
      continue;
    }
    const ComputedCosts::Before& before = robot.computed->before[forest.order[following->rank]];
    const Duration between = following->is_handle ? before.handle : before.update;
    extra_of(model, *following) -= between;
    extra_of(model, stage) += between;
  }
}

}  // namespace finemote::gen::timing
