// Follows data through a device tree: for every release of the root, which releases its devices hand over.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "generator/timing/releases.hpp"
#include "generator/timing/topology.hpp"

namespace finemote::gen::timing {

/// A monotone map between the releases of a root and those of a device below it: the steps of its staircase in one
/// repetition. Step k + n is step k one repetition later; both releases grow from step to step.
///
/// Both directions are the recurrence of the paper's Theorem 3, walked from the root instead of from every terminal.
/// Down: the releases of the device from `device` of the step before up to, without, `device` see the decision of
/// `root`. Up: the releases of the root after `root` of the step before up to and with `root` use the state of
/// `device`. There are at most as many steps as the slowest device on the way has releases.
struct Staircase {
  struct Step {
    Ns root = 0;    ///< which release: 0 is the one at time 0
    Ns device = 0;  ///< when
    friend bool operator==(const Step&, const Step&) = default;
  };
  Ns length = 1;         ///< of one repetition
  Ns root_releases = 1;  ///< in it
  std::vector<Step> steps;
};

/// What a root hands down to one device, and that device up to the root.
struct HandOver {
  Ns length = 1;  ///< both staircases repeat after it
  std::shared_ptr<const Staircase> down, up;

  /// Of one row of the device's release table the oldest use; a root that is its own terminal has age 0.
  struct Use {
    Ns age = 0;  ///< terminal release less source release
    Ns release = 0, source = 0;
    std::size_t row = 0;
  };
  mutable std::vector<Use> oldest;  ///< oldest first; filled when first asked for, by bound_latencies
};

/// The terminal releases before `next` and not before that of the use before: they use the state of `source`.
struct TerminalUse {
  Ns next = 0;
  Ns source = 0;
};

/// Every use of one repetition, in ascending order: down to one device what came up from another (or from itself).
/// @param length  a multiple of the lengths of both, which belong to the same root
std::vector<TerminalUse> join(const Staircase& down, const Staircase& up, Ns length);

/// Largest next - source.
Ns oldest_age(const std::vector<TerminalUse>& uses);

/// How long after its release a slower producer's data is there for sure, in whole multiples of the common divisor of
/// both periods (releases of both only differ by such).
struct Lags {
  Ns most = 0;              ///< of all rows of the producer's release table; 0: at once, as it is not slower
  std::vector<Ns> per_row;  ///< empty: `most` in every row
  friend auto operator<=>(const Lags&, const Lags&) = default;
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

/// What has been walked so far. Paths of the same periods and lags, in whatever tree, share their staircases, and a
/// tree asked for again is not walked again. Holds a bounded number of steps; what no longer fits is computed again.
class HandOverStore {
 public:
  /// One edge further than `above`; null: the root itself.
  struct Edge {
    std::shared_ptr<const Staircase> above;
    Ns above_period = 0;
    Ns period = 1;
    Lags lags;
    friend bool operator==(const Edge&, const Edge&) = default;
  };
  struct Ends {
    Ns period = 1;  ///< of the device: staircases do not tell
    std::shared_ptr<const Staircase> down, up;
    friend bool operator==(const Ends&, const Ends&) = default;
  };
  struct Hash {
    static void mix(std::uint64_t& hash, Ns value) {
      hash = (hash ^ static_cast<std::uint64_t>(value)) * 0x9E3779B97F4A7C15U;
      hash ^= hash >> 29;
    }
    std::size_t operator()(const Edge& edge) const;
    std::size_t operator()(const Ends& ends) const;
    std::size_t operator()(const std::shared_ptr<const Staircase>& stairs) const;  ///< of what it holds
  };
  using Known = std::unordered_map<Edge, std::shared_ptr<const Staircase>, Hash>;

  Known down, up;
  std::unordered_map<Ends, std::shared_ptr<const HandOver>, Hash> pairs;

  /// Counts the steps of a staircase as long as it lives. Small ones of the same content become one.
  std::shared_ptr<const Staircase> keep(Staircase stairs);
  /// Whether so many steps more may live beside those in use; forgets what is not in use when it has to.
  bool make_room(Ns steps);

  /// The groups of a tree that was walked to its end, in the order of that walk; null when not known.
  [[nodiscard]] const std::vector<HandOverGroup>* walked(std::size_t root) const;
  void begin_tree() { tree_.clear(), is_whole_ = true; }
  void add(HandOverGroup group);
  void end_tree(std::size_t root);

 private:
  static constexpr Ns kMostLive = Ns{1} << 23;  ///< steps alive at one time
  void forget();

  static constexpr std::size_t kSmall = 8;  ///< steps
  struct SameSteps {
    bool operator()(const std::shared_ptr<const Staircase>& a, const std::shared_ptr<const Staircase>& b) const {
      return a->length == b->length && a->root_releases == b->root_releases && a->steps == b->steps;
    }
  };

  std::shared_ptr<Ns> live_ = std::make_shared<Ns>(0);
  std::unordered_set<std::shared_ptr<const Staircase>, Hash, SameSteps> small_;
  std::map<std::size_t, std::vector<HandOverGroup>> walked_;  ///< by root
  std::vector<HandOverGroup> tree_;                           ///< of the walk that is going on
  bool is_whole_ = true;
};

/// Calls `visit` with groups that cover every device of the tree which can be reached through buckets that are ok.
/// Memory and time are bounded; `effort` counts the steps. Throws Overflow, TooLong.
void walk_tree(const Model& model, const Topology& topology, const Responses& responses, const TaskSet& set,
               const ReleaseTable& table, std::size_t root, HandOverStore& store, Effort& effort,
               const std::function<void(const HandOverGroup&)>& visit);

}  // namespace finemote::gen::timing
