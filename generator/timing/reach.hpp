// Which samples can be part of which commands: the ways data take up to a root, over `reads` edges, and down again.
#pragma once

#include <optional>
#include <vector>

#include "generator/timing/topology.hpp"

namespace finemote::gen::timing {

class Reach {
 public:
  /// Model and topology must outlive this.
  Reach(const Model& model, const Topology& topology);

  /// Who uses the state of a device: its parent, and who reads it.
  [[nodiscard]] const std::vector<Rank>& consumers(Rank device) const { return consumers_[device]; }

  /// Whether some device of the tree of `root` reads another one.
  [[nodiscard]] bool reads_in_tree_of(Rank root) const { return reads_in_tree_of_[root]; }

  /// Whether data of `from` reaches commands of `to`.
  [[nodiscard]] bool connected(Rank from, Rank to) const;

  /// Where data can turn from going up to going down to a terminal.
  struct Turns {
    std::optional<Rank> end;    ///< the terminal, where some of its children's data end at it
    std::vector<Rank> devices;  ///< the root last
    auto operator<=>(const Turns&) const = default;
  };

  /// The root, everything below an edge that data end at, and the terminal where data end at itself: whatever is
  /// between two of them is reached from the upper one.
  [[nodiscard]] Turns turns_above(Rank to) const;

  /// The same for data that become part of what the parent of `to` commands it: not where they end at `to`, and those
  /// of its own subtree only by way of the parent.
  [[nodiscard]] Turns turns_into_command(Rank to) const;

  /// Devices with a sample of their own whose data reach one of the turns, in registration order: those without
  /// children, and those that measure. Data of any other device are as old as what it was made from.
  [[nodiscard]] std::vector<Rank> sources_of(const Turns& turns) const;

 private:
  [[nodiscard]] bool ends_at(Rank producer, Rank consumer) const;
  /// From `from` up to the root.
  void add_turns(Rank from, Turns& turns) const;

  const Model& model_;
  const Topology& topology_;
  Table<Rank, std::vector<Rank>> consumers_;
  Table<Rank, bool> reads_in_tree_of_;  ///< of roots
};

}  // namespace finemote::gen::timing
