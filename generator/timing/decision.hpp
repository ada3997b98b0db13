// Decision latency of one chain: from the start of update() at its source to the end of handle() at its terminal.
#pragma once

#include <map>

#include "generator/timing/pair_window.hpp"
#include "generator/timing/profile.hpp"
#include "generator/timing/reach.hpp"

namespace finemote::gen::timing {

struct Decision {
  std::optional<Duration> latency;  ///< none: a device on the way may miss its deadline
  bool closed_form = false;         ///< a safe bound instead of the maximum
  bool through_reads = false;       ///< passes a `reads` edge: outside Theorem 3
};

/// Looks at one chain after the other in one analysed profile.
class DecisionAnalysis {
 public:
  /// Everything must outlive this.
  DecisionAnalysis(const Model& model, const Topology& topology, const Reach& reach, const ProfileAnalysis& profile,
                   Effort& effort);

  /// Requires that data of `from` reaches commands of `to`. Throws Overflow.
  [[nodiscard]] Decision decide(Rank from, Rank to) const;

  /// How data get from a device to a root, of all ways the oldest.
  struct WayUp {
    bool reaches = false;
    std::optional<Duration> age;  ///< at the release of the root, from that of the device on; none: as in Decision
    bool through_reads = false;
  };
  /// Of the sources and all devices on their ways, in closed form. Throws Overflow.
  [[nodiscard]] std::map<Rank, WayUp> ways_up(Rank root, const std::vector<Rank>& sources) const;
  /// The same as decide() in closed form, which is never smaller: of a source with this way to the root of `to`.
  [[nodiscard]] Decision decide(const WayUp& way, Rank to) const;

  /// Whether the bounds of a device, or of one between it and its root, may be larger than the exact ones.
  [[nodiscard]] bool is_general(Rank device) const { return is_general_[device]; }

 private:
  struct Route;

  void find_hand_overs();
  [[nodiscard]] Route route(Rank from, Rank to) const;
  [[nodiscard]] Duration join_hand_overs(Rank from, Rank to) const;
  [[nodiscard]] Duration walk(const Route& route, std::int64_t entries) const;
  [[nodiscard]] Duration hop(Rank producer, Rank consumer, Duration there) const;
  [[nodiscard]] Duration hop_up(Rank producer, Rank consumer) const;
  [[nodiscard]] Duration hop_down(Rank producer, Rank consumer) const;
  [[nodiscard]] Duration closed_form(const Route& route) const;
  [[nodiscard]] Duration hand_down(Duration release, Rank producer, Rank consumer) const;
  [[nodiscard]] Duration used(Duration use, Rank producer, Rank consumer) const;
  [[nodiscard]] Duration released_together(Rank from, Rank to, Duration release, Duration response) const;

  const Model& model_;
  const Topology& topology_;
  const Reach& reach_;
  const ProfileAnalysis& profile_;
  Effort& effort_;
  const PairWindow windows_;
  Table<Rank, std::shared_ptr<const HandOver>> hand_over_;  ///< null: not known
  Table<Rank, bool> is_general_;                            ///< general_up_to_root
};

}  // namespace finemote::gen::timing
