#include "generator/tasks/streamed_work.hpp"

#include "generator/model/streamed_frames.hpp"
#include "generator/timing/response.hpp"

namespace finemote::gen::timing {
namespace {

bool is_streamed(const gen::Device& device) {
  return device.wcet.source == Wcet::Source::assumed && device.wcet.per_frame > Duration::zero();
}

}  // namespace

void shorten_streamed_work(const Robot& robot, const Forest& forest, Model& model) {
  std::vector<Rank> streamed;
  for (const Rank d : model.devices.ids()) {
    const bool is_assumed = model.devices[d].source == WcetSource::assumed;
    if (is_assumed && is_streamed(robot.devices[forest.order[d]])) streamed.push_back(d);
  }
  if (streamed.empty()) return;
  Effort effort;
  const TaskSet set = make_task_set(model, Profile::target);
  const Responses responses = bound_responses(set, effort);
  for (const Rank d : streamed) {
    if (!responses.ok(set.bucket_of[d])) continue;
    const gen::Device& device = robot.devices[forest.order[d]];
    const std::int64_t fewer =
        most_frames(robot, device) - frames_in(robot, device, device.period + responses.r_plus[d]);
    model.devices[d].update_wcet -= fewer * device.wcet.per_frame;
  }
}

}  // namespace finemote::gen::timing
