// Hand-overs of a tree to its oldest data: per release of the root, the source with the oldest sample.
#pragma once

#include <map>

#include "generator/timing/walk.hpp"

namespace finemote::gen::timing {

/// First every source is added, then terminals are asked for. Two repetitions of different length meet where their
/// root releases agree modulo the common divisor of their lengths (Chinese remainder), so none is unrolled.
class OldestSources {
 public:
  struct Oldest {
    Duration age = floor_div(Duration::min(), 2);  ///< below every age: none; two of them add without overflow
    Rank source;                                   ///< of equally old ones the first
    void offer(Duration new_age, Rank new_source) {
      const bool is_longer = new_age > age, is_equal = new_age == age, is_first = new_source < source;
      const bool is_older = is_longer | (is_equal & is_first);  // without a branch: either is likely
      age = is_older ? new_age : age;
      source = is_older ? new_source : source;
    }
    void offer(const Oldest& other) { offer(other.age, other.source); }
  };

  OldestSources(Duration root_period, Effort& effort) : root_period_(root_period), effort_(effort) {}

  /// @param best  of the devices of the group: how old its sample is when its update() begins, and which device it is.
  void add_group(const HandOverGroup& group, const Oldest& best);

  /// The oldest sample a device of the group uses, at its own release: the sum of its use of a root release and of what
  /// that release uses. Not one nanosecond younger than what is possible, and with closed forms maybe older.
  Oldest worst(const HandOverGroup& group);

  /// Whether answers so far may be larger than the exact ones.
  [[nodiscard]] bool has_closed_form() const { return closed_.age >= Duration::zero() || gave_up_; }

 private:
  using List = std::vector<Oldest>;  ///< per root release of one repetition

  void spread(List& list) const;
  void gather();
  const List& folded(std::size_t whole, std::size_t common);

  [[nodiscard]] std::int64_t steps_of_worst(const Staircase& down) const;

  Duration root_period_;
  Effort& effort_;
  struct Source {
    std::shared_ptr<const Staircase> up;
    Oldest best;
  };
  std::vector<Source> sources_;
  std::vector<List> wholes_;  ///< of lengths that do not divide each other, with everything of a length that divides
  std::map<std::pair<std::size_t, std::size_t>, List> folded_;  ///< by place in wholes_ and entries
  Oldest closed_;
  Oldest oldest_;  ///< of all root releases
  bool is_gathered_ = false, gave_up_ = false;
};

}  // namespace finemote::gen::timing
