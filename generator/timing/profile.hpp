// Model to the results of one profile.
#pragma once

#include <memory>

#include "generator/timing/hand_over_store.hpp"
#include "generator/timing/releases.hpp"
#include "generator/timing/topology.hpp"

namespace finemote::gen::timing {

/// Everything one profile computed, kept for the questions that follow (chains, windows of pairs).
struct ProfileAnalysis {
  ProfileResult result;
  TaskSet set;
  Responses responses;
  ReleaseTable table;
  std::shared_ptr<HandOverStore> hand_overs;  ///< never null; a cache that questions fill further
  std::int64_t most_releases = 0;             ///< of one bucket, and of the root of one path, that are examined
};

/// Requires a model that read_model accepts. Throws Overflow.
ProfileAnalysis analyse_profile(const Model& model, const Topology& topology, Profile profile,
                                const Limits& limits = {});

/// The same without windows and latencies of trees: whether every bucket meets its deadline, and how soon.
ProfileAnalysis analyse_deadlines(const Model& model, Profile profile, const Limits& limits = {});

}  // namespace finemote::gen::timing
