#include "generator/timing/stamps.hpp"

#include <algorithm>

#include "generator/timing/demand.hpp"
#include "generator/timing/frame_waits.hpp"
#include "generator/units/slow_sender.hpp"

namespace finemote::gen::timing {
namespace {

/// An event is no older than the row of routines of which the last serves it, each begun so soon after the one before
/// that it may have waited. The longest such row; none where it may never end. Routines of I2C and SPI, which are less
/// urgent, count too: the model does not tell them apart.
std::optional<Duration> longest_row(const Model& model, const TaskSet& set, Effort& effort) {
  std::vector<Stream> streams = set.sources;
  for (Stream& stream : streams) stream.cost += model.costs.event_pause;
  streams.insert(streams.end(), set.dma.begin(), set.dma.end());
  Demand demand(effort);
  demand.add_streams(streams);
  const Duration base = set.blocking + model.costs.event_entry;
  const Duration row = least_fit(demand, base, std::max(base, nanoseconds(1)), seconds(1));
  return row == kNever ? std::nullopt : std::optional(row);
}

/// On a line of two: the firmware dates a frame by the silence after it, and one that is read before that by two bytes
/// and kEventSlack of uart.cpp. Where there may be no silence, as another frame follows at once, all bytes that came
/// together are dated as if as much silence lay between them: for each twice its time. They are part of what the device
/// receives.
Duration early_on_line(const Model& model, const Device& device) {
  constexpr std::int64_t kLongestByteBits = 12;
  constexpr Duration kEventSlack = microseconds(2);
  Duration all, longest, two_bytes;
  std::int64_t kinds = 0;
  bool has_gap = true;
  for (const Transfer& transfer : device.transfers) {
    if (!transfer.receive) continue;
    const Duration least = 2 * ceil_div(kLongestByteBits * seconds(1), model.buses[transfer.bus].baud_bps);
    two_bytes = std::max(two_bytes, least);
    all += transfer.wire;
    longest = std::max(longest, transfer.wire);
    has_gap = has_gap && transfer.min_interval - transfer.wire > least;
    ++kinds;
  }
  const Duration unseen = kinds == 1 && has_gap ? two_bytes : 2 * all + two_bytes;
  return of_slow_sender(longest) - longest + of_slow_sender(unseen) + kEventSlack;
}

/// How much earlier than the truth samples are dated at most.
class EarlyStamps {
 public:
  EarlyStamps(const Model& model, const SampleAges& waits, std::optional<Duration> row)
      : model_(model), waits_(waits), row_(row) {}

  /// None: there is no bound.
  [[nodiscard]] std::optional<Duration> of(Rank d) const {
    const Device& device = model_.devices[d];
    if (!device.acquisition) return Duration::zero();
    const auto& all = device.transfers;
    const auto arbitrates = [&](const Transfer& t) { return is_arbitrated_answer(model_, t); };
    const auto comes = [&](const Transfer& t) { return t.after == Transfer::After::autonomous && t.receive; };
    const bool has_frames = std::any_of(all.begin(), all.end(), arbitrates);
    const bool is_asked_alone =
        device.acquisition->periods > 0 && !has_frames && std::none_of(all.begin(), all.end(), comes);
    if (is_asked_alone) return Duration::zero();  // dated by when it asks
    if (!row_ || (has_frames && !waits_[d])) return std::nullopt;
    Duration early = has_frames ? *waits_[d] : Duration::zero();
    if (std::any_of(all.begin(), all.end(), comes)) early = std::max(early, early_on_line(model_, device));
    return early + *row_;
  }

 private:
  const Model& model_;
  const SampleAges& waits_;
  std::optional<Duration> row_;
};

}  // namespace

SampleAges stamped_ages(const Model& model, const TaskSet& set, const SampleAges& ages, const SampleAges& waits,
                        Effort& effort) {
  const EarlyStamps early_stamps(model, waits, longest_row(model, set, effort));
  SampleAges stamped;
  for (const Rank d : model.devices.ids()) {
    const auto early = early_stamps.of(d);
    stamped.push_back(ages[d] && early ? std::optional(*ages[d] + *early) : std::nullopt);
  }
  return stamped;
}

}  // namespace finemote::gen::timing
