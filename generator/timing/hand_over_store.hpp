// Cache of the hand-overs that were walked, of bounded size.
#pragma once

#include <map>
#include <unordered_map>
#include <unordered_set>

#include "generator/timing/hand_over.hpp"

namespace finemote::gen::timing {

/// What has been walked so far. Paths of the same periods and lags, in whatever tree, share their staircases, and a
/// tree asked for again is not walked again. Holds a bounded number of steps; what no longer fits is computed again.
class HandOverStore {
 public:
  /// One edge further than `above`; null: the root itself.
  struct Edge {
    std::shared_ptr<const Staircase> above;
    Duration above_period;
    Duration period = nanoseconds(1);
    Lags lags;
    friend bool operator==(const Edge&, const Edge&) = default;
  };
  struct Ends {
    Duration period = nanoseconds(1);  ///< of the device: staircases do not tell
    std::shared_ptr<const Staircase> down, up;
    friend bool operator==(const Ends&, const Ends&) = default;
  };
  struct Hash {
    static void mix(std::uint64_t& hash, std::int64_t value) {
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
  /// Oldest first, as the latencies of leaves (latency.hpp) need them.
  std::unordered_map<std::shared_ptr<const HandOver>, std::vector<OldestUse>> oldest_uses;

  /// closed_form_of, which is asked for again and again.
  ClosedForm closed_form(const std::shared_ptr<const HandOver>& exact, Duration period, Duration root_period);

  /// Counts the steps of a staircase as long as it lives. Small ones of the same content become one.
  std::shared_ptr<const Staircase> keep(Staircase stairs);
  /// Whether this many more steps may live beside those in use; forgets what is not in use when it has to.
  bool make_room(std::int64_t steps);

  /// The groups of a tree that was walked to its end, in the order of that walk; null when not known.
  [[nodiscard]] const std::vector<HandOverGroup>* walked(Rank root) const;
  void begin_tree() { tree_.clear(), is_whole_ = true; }
  void add(HandOverGroup group);
  void end_tree(Rank root);

 private:
  static constexpr std::int64_t kMostLive = std::int64_t{1} << 23;  ///< steps alive at one time
  void forget();

  static constexpr std::size_t kSmall = 8;  ///< steps
  struct SameSteps {
    bool operator()(const std::shared_ptr<const Staircase>& a, const std::shared_ptr<const Staircase>& b) const {
      return a->length == b->length && a->root_releases == b->root_releases && a->steps == b->steps;
    }
  };

  std::unordered_map<std::shared_ptr<const HandOver>, ClosedForm> closed_forms_;
  std::shared_ptr<std::int64_t> live_ = std::make_shared<std::int64_t>(0);
  std::unordered_set<std::shared_ptr<const Staircase>, Hash, SameSteps> small_;
  std::map<Rank, std::vector<HandOverGroup>> walked_;  ///< by root
  std::vector<HandOverGroup> tree_;                    ///< of the walk that is going on
  bool is_whole_ = true;
};

}  // namespace finemote::gen::timing
