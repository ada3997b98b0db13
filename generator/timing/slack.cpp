#include "generator/timing/slack.hpp"

#include <algorithm>

#include "generator/timing/profile.hpp"

namespace finemote::gen::timing {
namespace {

bool is_schedulable(const Model& model, Profile profile) {
  try {
    return analyse_deadlines(model, profile, kTrialLimits).result.schedulable;
  } catch (const Overflow&) {
    return false;
  }
}

/// Rounded up: a time that still fits fits exactly.
Duration scaled(Duration time, std::int64_t permille) { return ceil_div(time * permille, 1000); }

bool survives(const Model& model, Profile profile, std::optional<Rank> only, std::int64_t permille) {
  Model trial = model;
  try {
    for (const Rank d : trial.devices.ids()) {
      if (only && *only != d) continue;
      Device& device = trial.devices[d];
      device.update_wcet = scaled(device.update_wcet, permille);
      device.handle_wcet = scaled(device.handle_wcet, permille);
    }
  } catch (const Overflow&) {
    return false;
  }
  return is_schedulable(trial, profile);
}

}  // namespace

std::int64_t slack_permille(const Model& model, Profile profile, std::optional<Rank> only) {
  if (!survives(model, profile, only, 0)) return 0;
  std::int64_t good = 0, bad = 1000;
  while (survives(model, profile, only, bad)) {
    if (bad == kMostSlack) return kMostSlack;
    good = bad;
    bad = std::min(2 * bad, kMostSlack);
  }
  while (bad - good > 1) {
    const std::int64_t middle = good + (bad - good) / 2;
    (survives(model, profile, only, middle) ? good : bad) = middle;
  }
  return good;
}

Slack find_slack(const Model& model, Profile profile) {
  constexpr std::size_t kMostDevices = 500;
  Slack slack{slack_permille(model, profile), {}};
  if (model.devices.size() > kMostDevices) return slack;
  for (const Rank d : model.devices.ids()) slack.one.push_back(slack_permille(model, profile, d));
  return slack;
}

}  // namespace finemote::gen::timing
