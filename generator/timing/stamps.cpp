#include "generator/timing/stamps.hpp"

#include <algorithm>

#include "generator/timing/demand.hpp"
#include "generator/timing/frame_waits.hpp"
#include "generator/timing/utilization.hpp"

namespace finemote::gen::timing {
namespace {

/// An event is no older than the row of routines of which the last serves it, each begun so soon behind the one before
/// that it may have waited. So long is a row at most; none where it may never end.
std::optional<Duration> longest_row(const Model& model, const TaskSet& set, Effort& effort) {
  std::vector<Stream> buses(set.streams.begin(), set.streams.begin() + static_cast<std::ptrdiff_t>(set.bus_streams));
  for (Stream& stream : buses) stream.cost += model.costs.event_pause;
  Demand demand(effort);
  demand.add_streams(buses);
  const Duration base = set.blocking + model.costs.event_entry;
  const Duration row = least_fit(demand, base, std::max(base, nanoseconds(1)), seconds(1));
  return row == kNever ? std::nullopt : std::optional(row);
}

/// On a line of two: the firmware dates a frame by the silence behind it, and as if the sender's bits were as long as
/// can be, 1 in 22 (RM0090 30.3.5). Where there may be no silence, as another frame follows at once, all bytes that
/// came together are dated as if as much silence lay between them: for each twice its time. They are part of what the
/// device receives.
Duration early_on_line(const Model& model, const Device& device) {
  constexpr std::int64_t kLongestByteBits = 12, kMostDeviation = 22;
  Duration all, longest;
  std::int64_t kinds = 0;
  bool has_gap = true;
  for (const Transfer& transfer : device.transfers) {
    if (!transfer.receive) continue;
    const Duration least = 2 * ceil_div(kLongestByteBits * seconds(1), model.buses[transfer.bus].baud_bps);
    all += transfer.wire;
    longest = std::max(longest, transfer.wire);
    has_gap = has_gap && transfer.min_interval - transfer.wire > least;
    ++kinds;
  }
  const Duration slow = nanoseconds(ceil_div(longest.ns(), kMostDeviation));
  return kinds == 1 && has_gap ? slow : slow + 2 * all;
}

class Stamps {
 public:
  Stamps(const Model& model, const SampleAges& waits, std::optional<Duration> row)
      : model_(model), waits_(waits), row_(row) {}

  /// Less the age of the sample; none where unbounded.
  [[nodiscard]] std::optional<Duration> early(Rank d) const {
    const Device& device = model_.devices[d];
    if (!device.acquisition) return Duration::zero();
    const auto& all = device.transfers;
    const auto arbitrates = [&](const Transfer& t) { return is_arbitrated_answer(model_, t); };
    if (std::any_of(all.begin(), all.end(), arbitrates)) {
      return waits_[d] && row_ ? std::optional(*waits_[d] + *row_) : std::nullopt;
    }
    const auto comes = [](const Transfer& t) { return t.after == Transfer::After::autonomous; };
    if (std::none_of(all.begin(), all.end(), comes)) return Duration::zero();
    return row_ ? std::optional(early_on_line(model_, device) + *row_) : std::nullopt;
  }

 private:
  const Model& model_;
  const SampleAges& waits_;
  std::optional<Duration> row_;
};

}  // namespace

SampleAges stamped_ages(const Model& model, const TaskSet& set, const SampleAges& ages, const SampleAges& waits,
                        Effort& effort) {
  const Stamps stamps(model, waits, longest_row(model, set, effort));
  SampleAges stamped;
  for (const Rank d : model.devices.ids()) {
    const auto early = stamps.early(d);
    stamped.push_back(ages[d] && early ? std::optional(*ages[d] + *early) : std::nullopt);
  }
  return stamped;
}

}  // namespace finemote::gen::timing
