// Follows data through a device tree: for every release of the root, which releases its devices hand over.
#pragma once

#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <vector>

#include "generator/timing/releases.hpp"
#include "generator/timing/topology.hpp"

namespace finemote::gen::timing {

/// The hand-over between a root and one device, for the root releases x = 0, T_root, 2 T_root, ... below `length`.
/// It repeats after `length`: entry i + n is entry i plus `length`.
///
/// Both are the recurrence of the paper's Theorem 3, walked from the root instead of from every terminal: the floor
/// maps of the recurrence are monotone, so the terminals that use data of one root release form an interval, and the
/// last of them is the oldest use. One pass serves every path and every pair of devices.
struct HandOver {
  Ns length = 1;
  std::vector<Ns> next;    ///< first release of the device whose handle() sees a root decision later than x
  std::vector<Ns> source;  ///< release of the device whose update() the root uses at x

  /// The oldest use of every row of the device's release table; filled when first asked for, by bound_latencies.
  struct Use {
    Ns age = std::numeric_limits<Ns>::min() / 2;  ///< below every age: the row has no use
    Ns release = 0, source = 0;
  };
  mutable std::vector<Use> oldest;
};

/// The hand-overs computed so far: paths of the same periods and lags, in whatever tree, share one. Holds a bounded
/// number of entries; what no longer fits is computed again.
class HandOverStore {
 public:
  /// Path from the root to a device: the hand-over above it, the period, and the lags of the edge between.
  struct Key {
    const HandOver* above = nullptr;  ///< null: the device is a root
    Ns period = 1;
    std::vector<Ns> down, up;
    friend auto operator<=>(const Key&, const Key&) = default;
  };

  [[nodiscard]] std::shared_ptr<const HandOver> find(const Key& key) const;
  std::shared_ptr<const HandOver> keep(Key key, HandOver value);
  /// Whether so many entries more may live beside those in use; forgets what is not in use when it has to.
  bool make_room(Ns entries);

 private:
  static constexpr Ns kMostLive = Ns{1} << 24;  ///< entries alive at one time
  static constexpr Ns kMostKept = Ns{1} << 22;  ///< entries the store itself keeps alive

  std::shared_ptr<Ns> live_ = std::make_shared<Ns>(0);
  Ns kept_ = 0;
  std::map<Key, std::shared_ptr<const HandOver>> known_;
  std::set<const HandOver*> held_;  ///< the values of known_
};

/// Devices of one period that share a hand-over. Without `exact`, a least common multiple was too large to walk, and
/// only bounds are known: the closed form per edge (docs/timing.md).
struct HandOverGroup {
  Ns period = 1;
  std::vector<std::size_t> devices;
  std::shared_ptr<const HandOver> exact;
  Ns age = 0;   ///< closed form: terminal release less source release
  Ns down = 0;  ///< closed form: terminal release less root release
  Ns up = 0;    ///< closed form: root release less source release
};

/// Calls `visit` with groups that cover every device of the tree which can be reached through buckets that are ok.
/// Memory and time are bounded; `effort` counts the entries. Throws Overflow, TooLong.
void walk_tree(const Model& model, const Topology& topology, const Responses& responses, const TaskSet& set,
               const ReleaseTable& table, std::size_t root, HandOverStore& store, Effort& effort,
               const std::function<void(const HandOverGroup&)>& visit);

}  // namespace finemote::gen::timing
