// End-to-end age of a command: acquire + decide + wire along any chain from one device to another.
#pragma once

#include "generator/timing/decision.hpp"
#include "generator/timing/wire.hpp"

namespace finemote::gen::timing {

/// What an end-to-end bound adds up.
enum class ChainPart { acquire, decide, wire };

/// A chain `from -> to`: the sample `from` reads, up to the root of the tree of `to`, and down to the output of `to`.
struct ChainResult {
  Rank from, to;
  std::optional<Duration> acquire;     ///< sample to start of update(from)
  std::optional<Duration> decide;      ///< start of update(from) to end of handle(to)
  std::optional<Duration> wire;        ///< end of handle(to) to the last bit
  std::optional<Duration> age;         ///< of the sample at the end of handle(to): acquire + decide
  std::optional<Duration> end_to_end;  ///< age + wire
  bool assumed = false;                ///< some execution time or acquisition behind it is an assumption
  bool through_reads = false;          ///< passes a `reads` edge: outside Theorem 3
  bool closed_form = false;

  [[nodiscard]] std::optional<Duration> bound_of(ChainPart part) const {
    return part == ChainPart::acquire ? acquire : part == ChainPart::decide ? decide : wire;
  }
};

class ChainAnalysis {
 public:
  static constexpr std::size_t kMostPairs = 1024;

  /// @param ages        of every device: of its samples when its update() begins, which is the `acquire` of its chains
  /// @param most_pairs  up to this many pairs of leaves of one tree `defaults()` looks at each; beyond, at groups of
  /// them.
  ChainAnalysis(const Model& model, const Topology& topology, const ProfileAnalysis& profile, const WireAnalysis& wire,
                Table<Rank, std::optional<Duration>> ages, Effort& effort, std::size_t most_pairs = kMostPairs);
  ChainAnalysis(const ChainAnalysis&) = delete;
  ChainAnalysis& operator=(const ChainAnalysis&) = delete;

  /// Whether data of `from` reaches commands of `to`.
  [[nodiscard]] bool connected(Rank from, Rank to) const { return reach_.connected(from, to); }

  /// Requires connected(from, to). Throws Overflow.
  [[nodiscard]] ChainResult bound(Rank from, Rank to) const;

  /// For every leaf that takes a command (every root where its tree has none): the chain from the oldest data its
  /// command can rest on, of all sources whose data reach it, over `reads` edges too. A source has no children, or
  /// samples of its own. Where too many pairs would have to be looked at and groups of them cannot stand in, closed
  /// forms do. Throws Overflow.
  [[nodiscard]] std::vector<ChainResult> defaults() const;

  /// The same for every device below another that takes a command, leaf or not. Throws Overflow.
  [[nodiscard]] std::vector<ChainResult> oldest_inputs() const;

  /// From every source to every device that its data reach as a command, leaf or not: the first kMostPairs of them.
  /// Throws Overflow.
  [[nodiscard]] std::vector<ChainResult> every() const;

 private:
  [[nodiscard]] ChainResult complete(Rank from, Rank to, const Decision& decision) const;
  [[nodiscard]] std::vector<ChainResult> worst_of_pairs(const std::vector<Rank>& sources,
                                                        const std::vector<Rank>& terminals) const;
  [[nodiscard]] std::vector<ChainResult> worst_in_closed_form(Rank root, const std::vector<Rank>& sources,
                                                              const std::vector<Rank>& terminals) const;
  [[nodiscard]] std::optional<Rank> first_unbounded(const std::vector<Rank>& sources) const;
  [[nodiscard]] std::vector<ChainResult> worst_of_groups(Rank root, const std::vector<Rank>& leaves,
                                                         const std::vector<Rank>& terminals) const;
  [[nodiscard]] std::vector<ChainResult> worst_of(const std::vector<Rank>& sources,
                                                  const std::vector<Rank>& terminals) const;
  [[nodiscard]] std::vector<ChainResult> worst_of_all(const std::vector<Rank>& terminals,
                                                      const std::function<Reach::Turns(Rank)>& turns_of) const;
  [[nodiscard]] Duration repetition(const std::vector<Rank>& devices) const;
  [[nodiscard]] bool is_assumed(Rank from, Rank to) const;

  const Model& model_;
  const Topology& topology_;
  const ProfileAnalysis& profile_;
  const WireAnalysis& wire_;
  Effort& effort_;
  std::size_t most_pairs_;
  Reach reach_;
  DecisionAnalysis decisions_;
  Table<Rank, std::optional<Duration>> acquire_;
  Duration assumed_from_ = kNever;  ///< shortest period of a device whose execution times are assumed
};

}  // namespace finemote::gen::timing
