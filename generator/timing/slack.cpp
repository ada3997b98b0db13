#include "generator/timing/slack.hpp"

namespace finemote::gen::timing {

Slack find_slack(const Model& model, Profile profile) {
  constexpr std::size_t kMostDevices = 500;
  Slack slack{slack_permille(model, profile), {}};
  if (model.devices.size() > kMostDevices) return slack;
  for (const Rank d : model.devices.ids()) slack.one.push_back(slack_permille(model, profile, d));
  return slack;
}

}  // namespace finemote::gen::timing
