#include "generator/timing/one_wire.hpp"

#include <algorithm>

namespace finemote::gen::timing {
namespace {

constexpr std::int64_t kBitsApart = 2;

/// As often as both together, each kind no more often than by itself. Two of different kinds are `slack` closer than
/// two of one.
void add_kind(const Stream& kind, Duration slack, Stream& kinds) {
  const bool has_limit = !kinds.budgets.empty() && !kind.budgets.empty();
  if (!has_limit) kinds.budgets.clear();
  for (std::size_t i = 0; has_limit && i < kind.budgets.size(); ++i) {
    kinds.budgets.push_back(kind.budgets[i]);
    kinds.budgets.back().separation = kind.separation;
  }
  kinds.separation = std::max(std::min(kinds.separation, kind.separation - slack), nanoseconds(1));
  kinds.source += " and " + kind.source;
  kinds.name = kinds.bus + "." + kinds.source;
}

/// The first kind of several.
Stream first_of(Stream kind, Duration slack) {
  for (Stream::Budget& budget : kind.budgets) budget.separation = kind.separation;
  kind.separation = std::max(kind.separation - slack, nanoseconds(1));
  return kind;
}

}  // namespace

std::vector<Stream> one_wire(std::vector<Stream> sources, Duration bit) {
  const auto kinds =
      std::stable_partition(sources.begin(), sources.end(), [](const Stream& s) { return !s.ends_frame; });
  if (sources.end() - kinds < 2) return sources;
  std::stable_sort(kinds, sources.end(), [](const Stream& a, const Stream& b) { return a.cost > b.cost; });
  const Duration slack = kBitsApart * bit;
  std::vector<Stream> streams(sources.begin(), kinds);
  Stream together = first_of(*kinds, slack);
  for (auto kind = kinds; kind != sources.end(); ++kind) {
    if (kind != kinds) add_kind(*kind, slack, together);
    together.cost = kind->cost - (kind + 1 != sources.end() ? (kind + 1)->cost : Duration::zero());
    if (together.cost > Duration::zero()) streams.push_back(together);
  }
  return streams;
}

}  // namespace finemote::gen::timing
