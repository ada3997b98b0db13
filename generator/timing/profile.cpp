#include "generator/timing/profile.hpp"

#include <algorithm>

#include "generator/timing/job_streams.hpp"
#include "generator/timing/latency.hpp"
#include "generator/timing/release_interrupt.hpp"
#include "generator/timing/repetition.hpp"
#include "generator/timing/true_time.hpp"

namespace finemote::gen::timing {
namespace {

std::optional<Duration> known(Duration value) { return value == kNone ? std::nullopt : std::optional<Duration>(value); }

/// Where a release can be lost, all later ones are late, and nothing has a bound.
void mark_all_unbounded(Responses& responses) {
  for (Table<Rank, Duration>* bounds : {&responses.r_plus, &responses.r_minus})
    std::fill(bounds->begin(), bounds->end(), kNone);
  std::fill(responses.bucket.begin(), responses.bucket.end(), kNone);
}

void summarise(const TaskSet& set, const Responses& responses, const ReleaseTable& table, ProfileResult& result) {
  result.schedulable = true;
  for (std::size_t w = 0; w < set.buckets.size(); ++w) {
    const TaskBucket& bucket = set.buckets[w];
    result.schedulable &= responses.ok(w);
    result.buckets.push_back({bucket.period, bucket.cost, bucket.devices, known(responses.bucket[w]), responses.ok(w),
                              responses.closed_form[w]});
  }
  for (const Rank d : set.update.ids()) {
    DeviceResult device{responses.b_plus[d],         responses.b_minus[d], known(responses.r_plus[d]),
                        known(responses.r_minus[d]), std::nullopt,         table.is_general(set.bucket_of[d])};
    if (result.profile != Profile::paper) device.window = known(table.window(d));
    result.devices.push_back(device);
  }
}

/// From the board's clock, by which everything is calculated, to true time. Releases stay what the schedule says.
void stretch(const Model& model, ProfileResult& result) {
  if (result.profile != Profile::target) return;
  for (BucketResult& bucket : result.buckets) bucket.response = true_bound(model, bucket.response);
  for (DeviceResult& device : result.devices) {
    for (std::optional<Duration>* bound : {&device.r_plus, &device.r_minus, &device.window})
      *bound = true_bound(model, *bound);
  }
  for (TreeResult& tree : result.trees) {
    tree.latency = true_bound(model, tree.latency);
    for (PathResult& path : tree.paths) path.latency = true_bound(model, path.latency);
  }
}

/// Steps for the search of when transfers have ended.
constexpr std::int64_t kTransferSteps = std::int64_t{1} << 22;

/// How often what jobs cause is counted anew with the response times that follow from it. Further iterations gain
/// little.
constexpr int kRounds = 2;

/// Response times; those of profile target after its streams know what jobs cause. Each iteration begins with the
/// bounds of the one before, so that nothing rests on itself.
Responses refined_responses(const Model& model, Profile profile, TaskSet& set, Effort& effort) {
  Responses responses = bound_responses(set, effort);
  if (profile != Profile::target || set.bus_streams == 0) return responses;
  for (int round = 0; round < kRounds; ++round) {
    Effort transfers(kTransferSteps, effort.most_releases());
    separate_jobs(model, responses, set, transfers);
    Responses next = bound_responses(set, effort);
    if (effort.is_spent()) {  // the bounds of the iteration before hold as well, and nobody is to search on
      std::fill(responses.closed_form.begin(), responses.closed_form.end(), true);
      break;
    }
    responses = std::move(next);
  }
  return responses;
}

/// The same where no release is lost, else none; notes the release interrupt.
Responses responses_of(const Model& model, TaskSet& set, Effort& effort, ProfileResult& result) {
  if (result.profile == Profile::target) result.release = bound_release(model, set, effort);
  Responses responses = refined_responses(model, result.profile, set, effort);
  if (!result.release || result.release->ok()) return responses;
  result.release->is_alone =
      std::all_of(responses.bucket.begin(), responses.bucket.end(), [](Duration bucket) { return bucket != kNone; });
  mark_all_unbounded(responses);
  set = make_task_set(model, result.profile);  // from unbounded responses follows no end of a transfer
  return responses;
}

}  // namespace

std::string_view profile_name(Profile profile) {
  switch (profile) {
    case Profile::paper:
      return "paper";
    case Profile::tight:
      return "tight";
    case Profile::target:
      return "target";
  }
  return "";
}

Profile best_profile(const Model& model) { return model.has_target ? Profile::target : Profile::tight; }

ProfileAnalysis analyse_profile(const Model& model, const Topology& topology, Profile profile, const Limits& limits) {
  TaskSet set = make_task_set(model, profile);
  const std::int64_t releases = most_releases(set, limits);
  Effort searches(limits.steps / 2, releases), effort(limits.steps / 2, releases);
  ProfileResult result;
  result.profile = profile;
  Responses responses = responses_of(model, set, searches, result);
  ReleaseTable table =
      profile == Profile::paper ? ReleaseTable(set, responses) : ReleaseTable::refined(set, responses, effort);
  summarise(set, responses, table, result);
  auto hand_overs = std::make_shared<HandOverStore>();
  result.trees =
      bound_latencies(model, topology, set, responses, table, profile == Profile::paper, *hand_overs, effort);
  stretch(model, result);
  return {std::move(result), std::move(set), std::move(responses), std::move(table), std::move(hand_overs), releases};
}

ProfileAnalysis analyse_deadlines(const Model& model, Profile profile, const Limits& limits) {
  TaskSet set = make_task_set(model, profile);
  const std::int64_t releases = most_releases(set, limits);
  Effort searches(limits.steps / 2, releases);
  ProfileResult result;
  result.profile = profile;
  Responses responses = responses_of(model, set, searches, result);
  ReleaseTable table(set, responses);
  summarise(set, responses, table, result);
  stretch(model, result);
  return {std::move(result), std::move(set), std::move(responses), std::move(table), std::make_shared<HandOverStore>(),
          releases};
}

}  // namespace finemote::gen::timing
