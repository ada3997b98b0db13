// Another order of registration, and what it does to latencies.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/timing/analyse.hpp"

namespace finemote::gen::timing {

/// Another order of registration: the device of each new rank, by its rank in the model as it is.
using Order = Table<Rank, Rank>;

/// An order of the same devices (siblings and roots exchanged, children before parents) with smaller latencies of
/// trees. The order as it is when no better one was found within the budget of trials.
Order suggest_order(const Model& model, Profile profile);

/// The model with its devices registered in another order.
Model reorder(const Model& model, const Order& order);

/// A bound before and after.
struct ChangedBound {
  std::string what;  ///< the root of a tree, or `imu -> esc`
  std::optional<Duration> before, after;
};

struct OrderEffect {
  std::vector<ChangedBound> trees;   ///< all of the verdict's profile
  std::vector<ChangedBound> chains;  ///< those of `timing` whose bound is another one
};

/// Analyses the model of `timing` in another order.
/// @param order  as of suggest_order
OrderEffect effect_of_order(const Timing& timing, const Order& order);

}  // namespace finemote::gen::timing
