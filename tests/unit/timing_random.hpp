// Random forests for properties of the timing analysis: small periods, so that every phase is met soon.
#pragma once

#include <algorithm>
#include <set>
#include <string>

#include "generator/simulate/random.hpp"
#include "generator/timing/model.hpp"

namespace finemote::gen::timing {

enum class ForestClass { same_period, parent_slower, parent_faster, non_harmonic };
inline constexpr ForestClass kForestClasses[] = {ForestClass::same_period, ForestClass::parent_slower,
                                                 ForestClass::parent_faster, ForestClass::non_harmonic};

class RandomForest {
 public:
  explicit RandomForest(std::uint64_t seed) : random_(seed) {}

  Model make(ForestClass kind) {
    Model model;
    model.tick = nanoseconds(kTick);
    periods_ = periods(kind);
    zero_one_in_ = random_.one_in(2) ? random_.between(2, 3) : 1'000'000;
    const std::int64_t trees = random_.between(1, 3);
    for (std::int64_t tree = 0; tree < trees; ++tree) grow(model, kind, random_.between(1, 6));
    scale_costs(model);
    add_buses(model);
    return model;
  }

  /// Costs, interrupt sources with budgets, copies and flushes on top.
  void extend(Model& model) {
    model.has_target = true;
    model.costs.release = up_to(3);
    model.costs.release_per_bucket = up_to(2);
    model.costs.interrupt = up_to(1);
    model.costs.job = up_to(4);
    model.costs.stage = up_to(1);
    model.costs.masked = up_to(4);
    for (Device& d : model.devices) {
      d.update_bcet = random_.between({}, d.update_wcet);
      d.update_extra = up_to(2);
      d.handle_extra = up_to(2);
    }
    std::set<Duration> periods;
    for (const Device& d : model.devices) periods.insert(d.period);
    for (const Duration period : periods) {
      if (random_.one_in(2)) model.flushes.push_back({period, up_to(6), {}, {}, 1, {}, {}, {}, {}});
    }
    for (const BusPlace place : model.buses.ids()) {
      Bus& bus = model.buses[place];
      if (random_.one_in(3)) continue;
      bus.sources.emplace();
      for (std::int64_t i = random_.between(1, 2); i > 0; --i) {
        InterruptSource source{"source", up_to(4), nanoseconds(random_.between(5, 80)), {}};
        source.ends_frame = random_.one_in(4);
        for (std::int64_t budgets = random_.between(-2, 3); budgets > 0; --budgets) {
          const Rank device{
              static_cast<std::size_t>(random_.between(0, static_cast<std::int64_t>(model.devices.size()) - 1))};
          source.budgets.push_back({device, random_.between(0, 3), random_.between(1, 3), {}});
          let_cause(model.devices[device], place, source.budgets.back());
        }
        if (asks_alone(source) && random_.one_in(2)) source.min_interval = nanoseconds(1);
        bus.sources->push_back(source);
      }
    }
  }

  /// Lets some devices read devices of other trees, without cycles: readers are in later trees than what they read, or
  /// in earlier ones, but not both.
  void observe(Model& model) {
    Table<Rank, std::int64_t> tree(model.devices.size());
    std::int64_t trees = 0;
    for (const Rank d : tree.ids()) {
      tree[d] = trees;
      if (!model.devices[d].parent) ++trees;
    }
    const bool forward = random_.one_in(2);
    const auto last = static_cast<std::int64_t>(model.devices.size()) - 1;
    for (std::int64_t i = random_.between(1, 3); i > 0; --i) {
      const Rank reader{static_cast<std::size_t>(random_.between(0, last))};
      const Rank observed{static_cast<std::size_t>(random_.between(0, last))};
      if (forward ? tree[observed] < tree[reader] : tree[reader] < tree[observed]) {
        model.devices[reader].reads.push_back(observed);
      }
    }
  }

 private:
  static bool asks_alone(const InterruptSource& source) {
    return !source.budgets.empty() &&
           std::all_of(source.budgets.begin(), source.budgets.end(),
                       [](const FrameBudget& b) { return b.cause == InterruptCause::request; });
  }

  /// Most budgets are caused by jobs; where a transfer does, it is mostly known how long it lasts.
  void let_cause(Device& device, BusPlace bus, FrameBudget& budget) {
    static constexpr InterruptCause kCauses[] = {InterruptCause::clock, InterruptCause::request,
                                                 InterruptCause::transfer, InterruptCause::look};
    budget.cause = kCauses[random_.between(0, 3)];
    if (budget.cause == InterruptCause::look) budget.every = 1, budget.carry_in = 2;
    static constexpr AskedIn kStages[] = {AskedIn::handle, AskedIn::update, AskedIn::flush};
    if (budget.cause != InterruptCause::look) budget.asked_in = kStages[random_.between(0, 2)];
    if (budget.cause != InterruptCause::transfer || random_.one_in(4)) return;
    Transfer transfer;
    transfer.bus = bus;
    transfer.wire = up_to(device.period.ns());
    transfer.after = budget.asked_in == AskedIn::update  ? Transfer::After::update
                     : budget.asked_in == AskedIn::flush ? Transfer::After::bucket
                                                         : Transfer::After::handle;
    device.transfers.push_back(transfer);
  }

  Duration up_to(std::int64_t most_ns) { return nanoseconds(random_.between(0, most_ns)); }

  static constexpr std::int64_t kTick = 20;  ///< [ns]

  std::vector<std::int64_t> periods(ForestClass kind) {
    static const std::vector<std::vector<std::int64_t>> kHarmonic{{5, 10, 20}, {4, 8, 16}, {3, 6, 12}, {2, 10, 20}};
    static const std::vector<std::vector<std::int64_t>> kOther{{4, 6, 10}, {2, 3, 5},  {3, 5, 7},
                                                               {4, 6, 9},  {5, 7, 10}, {6, 7, 8}};
    if (kind == ForestClass::same_period) return {random_.between(4, 20)};
    const auto& sets = kind == ForestClass::non_harmonic ? kOther : kHarmonic;
    return sets[static_cast<std::size_t>(random_.between(0, static_cast<std::int64_t>(sets.size()) - 1))];
  }

  /// One tree in registration order: a random parent for every device but the last.
  void grow(Model& model, ForestClass kind, std::int64_t count) {
    const std::size_t begin = model.devices.size(), end = begin + static_cast<std::size_t>(count);
    std::vector<std::size_t> rank(end, 0);  // index into periods_
    std::vector<Device> tree;               // root first
    for (std::size_t d = end; d-- > begin;) {
      Device device;
      device.name = "d" + std::to_string(d);
      std::int64_t low = 0, high = static_cast<std::int64_t>(periods_.size()) - 1;
      if (d + 1 < end) {
        const auto parent = static_cast<std::size_t>(
            random_.between(static_cast<std::int64_t>(d) + 1, static_cast<std::int64_t>(end) - 1));
        device.parent = Rank{parent};
        const auto limit = static_cast<std::int64_t>(rank[parent]);
        if (kind == ForestClass::parent_slower) high = limit;
        if (kind == ForestClass::parent_faster) low = limit;
      }
      rank[d] = static_cast<std::size_t>(random_.between(low, high));
      device.period = nanoseconds(periods_[rank[d]] * kTick);
      tree.push_back(device);
    }
    for (auto device = tree.rbegin(); device != tree.rend(); ++device) model.devices.push_back(*device);
  }

  void scale_costs(Model& model) {
    const std::int64_t load = random_.between(10, 90);  // percent of the processor, roughly
    const auto count = static_cast<std::int64_t>(model.devices.size());
    for (Device& d : model.devices) {
      const std::int64_t share = std::max<std::int64_t>(1, d.period.ns() * load / 100 / count);
      d.update_wcet = random_.one_in(zero_one_in_) ? Duration::zero() : up_to(share);
      d.handle_wcet = random_.one_in(zero_one_in_) ? Duration::zero() : up_to(share);
      if (zero_one_in_ > 3) {
        d.update_wcet = std::max(d.update_wcet, nanoseconds(1));
        d.handle_wcet = std::max(d.handle_wcet, nanoseconds(1));
      }
    }
  }

  void add_buses(Model& model) {
    for (std::int64_t i = random_.between(0, 3); i > 0; --i) {
      Bus bus;
      bus.name = "b" + std::to_string(i);
      bus.baud_bps = 300'000'000;  // one bit is 10/3 ns: frame times are fractions
      bus.min_frame_bits = random_.between(3, 40);
      bus.frame = floor_div(bus.min_frame_bits * seconds(1), bus.baud_bps);
      bus.wcet = random_.between({}, std::max(nanoseconds(1), floor_div(bus.frame, 5)));
      model.buses.push_back(bus);
    }
  }

  Random random_;
  std::vector<std::int64_t> periods_;  ///< in ticks
  std::int64_t zero_one_in_ = 3;
};

}  // namespace finemote::gen::timing
