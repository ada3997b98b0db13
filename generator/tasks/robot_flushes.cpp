#include "generator/tasks/robot_flushes.hpp"

#include <algorithm>
#include <set>

#include "generator/bus/bus_type.hpp"
#include "generator/descriptor/runtime_limits.hpp"
#include "generator/model/shared_frame.hpp"
#include "generator/tasks/robot_costs.hpp"

namespace finemote::gen::timing {
namespace {

class FlushAdder {
 public:
  FlushAdder(const Robot& robot, const Forest& forest, const BusPlaces& places, Traffic& traffic, Model& model)
      : robot_(robot), forest_(forest), places_(places), traffic_(traffic), model_(model) {}

  void add(const gen::Bucket& bucket, SegmentId segment) {
    Flush flush;
    flush.period = bucket.period;
    std::int64_t channels = 0;  // of the bucket
    for (const DeviceId d : bucket.devices) {
      const gen::Device& device = robot_.devices[d];
      const auto used =
          std::count_if(device.uses.begin(), device.uses.end(), [&](const Use& use) { return use.segment == segment; });
      const std::int64_t mine = (device.segment == segment ? 1 : 0) + used;
      if (mine == 0) continue;
      flush.devices.push_back(forest_.rank[d]);
      channels += mine;
    }
    if (flush.devices.empty()) return;
    const gen::Costs& costs = board_costs(robot_);
    const Segment& output = robot_.segments[segment];
    if (output.kind == Segment::Kind::pwm_expander) {
      const auto [first, last] = channels_of(segment);
      const FlushTime usual{costs.flush_expander, bursts_of(output) * costs.flush_expander_per_channel};
      const FlushTime time = robot_.expanders[*output.expander].type->flush.value_or(usual);
      flush.wcet = time.once + (last - first + 1) * time.per_channel;
      set_expander_burst(segment, flush);
    } else {
      flush.wcet = costs.flush + channels * costs.flush_per_channel;
      if (bus_type(output.bus_kind).flush == BusType::Flush::shared_frames) set_shared_frames(segment, flush);
    }
    model_.flushes.push_back(std::move(flush));
  }

 private:
  /// How often a flush may fill its burst: a bucket that is faster, and thus here already, may set channels meanwhile,
  /// which are taken along (Pca9685::build_burst).
  [[nodiscard]] std::int64_t bursts_of(const Segment& output) const {
    const bool is_shared = std::any_of(model_.flushes.begin(), model_.flushes.end(),
                                       [&](const Flush& flush) { return flush.output == output.name.text; });
    return is_shared ? runtime_limits::kBursts : 1;
  }

  /// The first and the last channel of an output that are used.
  [[nodiscard]] std::pair<std::int64_t, std::int64_t> channels_of(SegmentId output) const {
    std::int64_t first = 255, last = 0;
    const auto note = [&](std::optional<SegmentId> place, std::optional<std::uint32_t> channel) {
      if (place != output || !channel) return;
      first = std::min<std::int64_t>(first, *channel);
      last = std::max<std::int64_t>(last, *channel);
    };
    for (const gen::Device& device : robot_.devices) {
      note(device.segment, device.channel);
      for (const Use& use : device.uses) note(use.segment, use.channel);
    }
    return {first, last};
  }

  void set_expander_burst(SegmentId segment, Flush& flush) {
    const Segment& output = robot_.segments[segment];
    const Expander& expander = robot_.expanders[*output.expander];
    const auto bus = places_.of(expander.segment);
    if (!bus) return;
    const auto [first, last] = channels_of(segment);
    const ExpanderFrames& frames = expander.type->frames;
    const WireRate rate{robot_.segments[expander.segment].bus_kind, model_.buses[*bus].baud_bps,
                        mover_of(robot_, robot_.segments[expander.segment].bus)};
    WireUse use;
    use.add(rate, gen::add(frames.per_flush.write_bytes, multiply(frames.per_channel.write_bytes, last - first + 1)),
            0);
    traffic_.add_selection(expander.segment, rate, use);
    flush.output = output.name.text;
    flush.bus = bus;
    traffic_.add_budget(*bus, flush.devices.front(), use, FrameStage::flush);
    if (frames.check) {
      WireUse check;
      check.add(rate, frames.check->write_bytes, frames.check->read_bytes);
      traffic_.add_budget(*bus, flush.devices.front(), check, FrameStage::flush, flushes_per_check(expander));
      use.add(rate, frames.check->write_bytes, frames.check->read_bytes);
    }
    flush.wire = use.wire;
    flush.interrupts = use.interrupts;
    flush.service = traffic_.service(*bus, use);
  }

  /// The driver counts its flushes, whichever bucket they are of: the jobs of one bucket check no more often than this.
  static std::int64_t flushes_per_check(const Expander& expander) {
    return std::max<std::int64_t>(param_value(expander.params, expander.type->frames.checked_every, std::int64_t{1}),
                                  1);
  }

  /// A flush sends the shared frames that its own bucket fills: those that share a frame share a period.
  void set_shared_frames(SegmentId segment, Flush& flush) {
    const auto bus = places_.of(segment);
    if (!bus) return;
    std::set<std::uint32_t> identifiers, of_bus;
    for (const gen::Device& device : robot_.devices) {
      const auto frame = device.segment == segment ? shared_frame_of(device) : std::nullopt;
      if (!frame) continue;
      of_bus.insert(frame->identifier);
      if (device.period == flush.period) identifiers.insert(frame->identifier);
    }
    const WireRate rate{robot_.segments[segment].bus_kind, model_.buses[*bus].baud_bps};
    WireUse use;
    for (std::size_t i = 0; i < std::max<std::size_t>(identifiers.size(), 1); ++i) {
      use.add(rate, SharedFrame::kBytes, 0);
    }
    use.in_one_request = true;
    flush.bus = bus;
    flush.wire = use.wire;
    flush.interrupts = use.interrupts;
    flush.service = traffic_.service(*bus, use);
    traffic_.add_budget(*bus, flush.devices.front(), use, FrameStage::flush);
    if (!go_by_identifier(*bus, of_bus.size())) return;
    flush.identifiers.assign(identifiers.begin(), identifiers.end());
    flush.interrupts = 0;  // each frame finds a mailbox at once: the request that fills it runs before the job goes on
  }

  /// The controller sends by identifier among its mailboxes. With more frames of ours than those, or with others than
  /// the shared ones, declared or not, one that waits for a mailbox may be the more urgent.
  [[nodiscard]] bool go_by_identifier(BusPlace bus, std::size_t frames) const {
    const auto is_alone = [&](const Device& device) {
      return std::all_of(device.transfers.begin(), device.transfers.end(),
                         [&](const Transfer& t) { return t.bus != bus || t.after == Transfer::After::autonomous; });
    };
    if (!traffic_.is_counted(bus)) return false;
    return frames <= mailboxes_of(robot_, places_.buses()[bus]) &&
           std::all_of(model_.devices.begin(), model_.devices.end(), is_alone);
  }

  const Robot& robot_;
  const Forest& forest_;
  const BusPlaces& places_;
  Traffic& traffic_;
  Model& model_;
};

/// The end of a job holds all its flushes, and may hold them in any order: the first bears the whole of it.
void charge_first(Duration behind, std::size_t first, std::vector<Flush>& flushes) {
  for (std::size_t flush = first; flush < flushes.size(); ++flush)
    flushes[flush].wcet = flush == first ? behind : Duration::zero();
}

}  // namespace

void add_flushes(const Robot& robot, const Forest& forest, const Schedule& schedule, const BusPlaces& places,
                 Traffic& traffic, Model& model) {
  FlushAdder adder(robot, forest, places, traffic, model);
  for (const gen::Bucket& bucket : schedule.buckets) {
    const std::size_t first = model.flushes.size();
    for (const SegmentId segment : bucket.flushes) adder.add(bucket, segment);
    if (robot.computed) charge_first(robot.computed->behind_jobs(bucket.period), first, model.flushes);
  }
}

}  // namespace finemote::gen::timing
