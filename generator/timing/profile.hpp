// Model to the results of one profile.
#pragma once

#include "generator/timing/releases.hpp"
#include "generator/timing/walk.hpp"

namespace finemote::gen::timing {

/// Everything one profile computed, kept for the questions that follow (chains, windows of pairs).
struct ProfileAnalysis {
  ProfileResult result;
  TaskSet set;
  Responses responses;
  ReleaseTable table;
  std::shared_ptr<HandOverStore> hand_overs;  ///< never null; a cache that questions fill further
};

/// Requires a model that read_model accepts. Throws Overflow, TooLong.
ProfileAnalysis analyse_profile(const Model& model, const Topology& topology, Profile profile,
                                std::int64_t steps = kMostSteps);

/// The same without windows and latencies of trees: whether every bucket meets its deadline, and how soon.
ProfileAnalysis analyse_deadlines(const Model& model, Profile profile, std::int64_t steps = kMostSteps);

}  // namespace finemote::gen::timing
