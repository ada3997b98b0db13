#include "generator/timing/one_wire.hpp"

#include <algorithm>

namespace finemote::gen::timing {
namespace {

constexpr std::int64_t kBitsApart = 2;

/// As often as both together.
void add_kind(const Stream& kind, Stream& kinds) {
  const bool has_limit = !kinds.budgets.empty() && !kind.budgets.empty();
  if (!has_limit) kinds.budgets.clear();
  if (has_limit) kinds.budgets.insert(kinds.budgets.end(), kind.budgets.begin(), kind.budgets.end());
  kinds.separation = std::min(kinds.separation, kind.separation);
  kinds.source += " and " + kind.source;
  kinds.name = kinds.bus + "." + kinds.source;
}

/// One of several kinds: it comes no more often than by itself, and two of different kinds are `slack` closer than two
/// of one.
void prepare(Stream& kind, std::size_t number, Duration slack) {
  for (Stream::Budget& budget : kind.budgets) {
    budget.kind = number;
    budget.separation = kind.separation;
  }
  kind.separation = std::max(kind.separation - slack, nanoseconds(1));
}

}  // namespace

std::vector<Stream> one_wire(std::vector<Stream> sources, Duration bit) {
  const auto kinds =
      std::stable_partition(sources.begin(), sources.end(), [](const Stream& s) { return !s.ends_frame; });
  if (sources.end() - kinds < 2) return sources;
  std::stable_sort(kinds, sources.end(), [](const Stream& a, const Stream& b) { return a.cost > b.cost; });
  for (auto kind = kinds; kind != sources.end(); ++kind)
    prepare(*kind, static_cast<std::size_t>(kind - kinds), kBitsApart * bit);
  std::vector<Stream> streams(sources.begin(), kinds);
  Stream together = *kinds;
  for (auto kind = kinds; kind != sources.end(); ++kind) {
    if (kind != kinds) add_kind(*kind, together);
    together.cost = kind->cost - (kind + 1 != sources.end() ? (kind + 1)->cost : Duration::zero());
    if (together.cost > Duration::zero()) streams.push_back(together);
  }
  return streams;
}

}  // namespace finemote::gen::timing
