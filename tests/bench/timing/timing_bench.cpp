// Prints how tight the bounds are and what the analysis costs (docs/timing.md, "How tight the bounds are"). Ratios have
// fixed seeds and effort and are the same on every machine; times are only for people.
#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <map>

#include "generator/simulate/simulate.hpp"
#include "generator/timing/analyse.hpp"
#include "generator/timing/words.hpp"
#include "tests/unit/timing_random.hpp"

using namespace finemote::gen;
using namespace finemote::gen::timing;

namespace {

constexpr int kForests = 150;
constexpr int kRuns = 12;  ///< simulations of each forest, other seeds

Duration repetition(const Model& model) {
  Duration common = nanoseconds(1);
  for (const Device& d : model.devices) common = lcm(common, d.period);
  return common;
}

std::vector<ChainEnds> leaf_paths(const Topology& topology) {
  std::vector<ChainEnds> chains;
  for (const auto& leaves : topology.leaves) {
    for (const Rank leaf : leaves) chains.push_back({leaf, leaf});
  }
  return chains;
}

/// Bound over worst simulated latency, of every path with at least two devices.
struct Ratios {
  std::vector<double> paper, tight;
};

void compare(const Model& model, Ratios& ratios) {
  const Topology topology = make_topology(model);
  const ProfileResult paper = analyse_profile(model, topology, Profile::paper).result;
  const ProfileResult tight = analyse_profile(model, topology, Profile::tight).result;
  if (!paper.schedulable || !tight.schedulable) return;
  const auto chains = leaf_paths(topology);
  std::vector<Duration> worst(chains.size(), kNothing);
  for (int run = 0; run < kRuns; ++run) {
    const Simulation s =
        simulate(model, {static_cast<std::uint64_t>(run) + 1, 40 * repetition(model), Profile::tight, chains});
    for (std::size_t c = 0; c < chains.size(); ++c) worst[c] = std::max(worst[c], s.chains[c].latency);
  }
  std::size_t chain = 0;
  for (std::size_t t = 0; t < tight.trees.size(); ++t) {
    for (std::size_t p = 0; p < tight.trees[t].paths.size(); ++p, ++chain) {
      if (!model.devices[chains[chain].from].parent || worst[chain] <= Duration::zero()) continue;
      ratios.paper.push_back(ratio(*paper.trees[t].paths[p].latency, worst[chain]));
      ratios.tight.push_back(ratio(*tight.trees[t].paths[p].latency, worst[chain]));
    }
  }
}

double quantile(std::vector<double> values, double q) {
  std::sort(values.begin(), values.end());
  return values.empty() ? 0 : values[static_cast<std::size_t>(q * static_cast<double>(values.size() - 1))];
}

void print_tightness() {
  static constexpr std::string_view kNames[] = {"same period", "parent slower", "parent faster", "non-harmonic"};
  fmt::print("bound / worst simulated latency      paths   paper: median  p95    tight: median  p95\n");
  for (const ForestClass kind : kForestClasses) {
    Ratios ratios;
    for (int i = 0; i < kForests; ++i) {
      compare(RandomForest(static_cast<std::uint64_t>(i) * 4 + static_cast<std::uint64_t>(kind) + 9'000'000).make(kind),
              ratios);
    }
    fmt::print("  {:<34} {:>6} {:>15.3f} {:>6.3f} {:>14.3f} {:>6.3f}\n", kNames[static_cast<int>(kind)],
               ratios.tight.size(), quantile(ratios.paper, 0.5), quantile(ratios.paper, 0.95),
               quantile(ratios.tight, 0.5), quantile(ratios.tight, 0.95));
  }
}

/// `count` devices in trees up to eight deep, three buses, periods drawn from `periods_ms`, half of the processor
/// used.
Model large_model(std::size_t count, const std::vector<std::int64_t>& periods_ms) {
  Random random(42);
  Model model;
  model.tick = milliseconds(1);
  model.buses.resize(3);
  const std::int64_t frames[] = {86'805, 22'500, 47'000};
  for (const BusPlace b : model.buses.ids()) {
    model.buses[b].name = "b" + std::to_string(b.value());
    model.buses[b].frame = nanoseconds(frames[b.value()]);
    model.buses[b].wcet = nanoseconds(1'500);
  }
  std::vector<int> depth(count, 0);
  model.devices.resize(count);
  for (std::size_t d = count; d-- > 0;) {
    Device& device = model.devices[Rank{d}];
    device.name = "d" + std::to_string(d);
    device.period = milliseconds(
        periods_ms[static_cast<std::size_t>(random.between(0, static_cast<std::int64_t>(periods_ms.size()) - 1))]);
    if (d + 1 < count && d % 100 != 99) {
      const std::size_t last = std::min(count - 1, d / 100 * 100 + 99);
      const auto parent =
          static_cast<std::size_t>(random.between(static_cast<std::int64_t>(d) + 1, static_cast<std::int64_t>(last)));
      if (depth[parent] < 7) device.parent = Rank{parent}, depth[d] = depth[parent] + 1;
    }
    const Duration share = std::max(floor_div(device.period, static_cast<std::int64_t>(count) * 4), nanoseconds(1));
    device.update_wcet = random.between(nanoseconds(1), share);
    device.handle_wcet = random.between(nanoseconds(1), share);
  }
  return model;
}

/// `count` devices on random periods, below the last of them, that use so much of the processor.
Model hostile_star(std::size_t count, const std::vector<std::int64_t>& periods_ms, std::int64_t percent) {
  Random random(1);
  Model model;
  model.tick = milliseconds(1);
  model.devices.resize(count);
  const auto last_period = static_cast<std::int64_t>(periods_ms.size()) - 1;
  for (const Rank d : model.devices.ids()) {
    Device& device = model.devices[d];
    device.name = "d" + std::to_string(d.value());
    device.period = milliseconds(periods_ms[static_cast<std::size_t>(random.between(0, last_period))]);
    device.update_wcet = device.handle_wcet =
        floor_div(device.period * percent, static_cast<std::int64_t>(count) * 200);
    if (d.value() + 1 < count) device.parent = Rank{count - 1};
  }
  return model;
}

/// `count` devices on periods of 50 to 130 ms, each of which asks for a transfer on one of four buses in every job.
Model busy_buses(std::size_t count) {
  static constexpr std::int64_t kPeriodsMs[] = {50, 70, 110, 130};
  Model model;
  model.tick = milliseconds(1);
  model.has_target = true;
  model.devices.resize(count);
  for (int i = 0; i < 4; ++i) {
    Bus bus;
    bus.name = "b" + std::to_string(i);
    bus.baud_bps = 100'000'000;
    bus.sources = std::vector<InterruptSource>{{"request", nanoseconds(100), nanoseconds(1), {}},
                                               {"end", nanoseconds(100), nanoseconds(200), {}}};
    model.buses.push_back(std::move(bus));
  }
  for (const Rank d : model.devices.ids()) {
    Device& device = model.devices[d];
    device.name = "d" + std::to_string(d.value());
    device.period = milliseconds(kPeriodsMs[d.value() % 4]);
    device.update_wcet = device.handle_wcet = nanoseconds(100);
    Transfer transfer;
    transfer.bus = BusPlace{d.value() / 4 % 4};
    transfer.wire = nanoseconds(300);
    device.transfers.push_back(transfer);
    FrameBudget budget{d, 1, 1, {}};
    for (InterruptSource& source : *model.buses[transfer.bus].sources) {
      budget.cause = source.name == "end" ? InterruptCause::transfer : InterruptCause::request;
      source.budgets.push_back(budget);
    }
  }
  return model;
}

void print_cost(std::string_view name, const Model& model) {
  // Processor time of this program, so that a busy machine does not count.
  const auto time = [](const auto& work) {
    double best = 1e9;
    for (int i = 0; i < 3; ++i) {
      const std::clock_t begin = std::clock();
      work();
      best = std::min(best, 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
    }
    return best;
  };
  const Topology topology = make_topology(model);
  const double paper = time([&] { (void)analyse_profile(model, topology, Profile::paper); });
  const double tight = time([&] { (void)analyse_profile(model, topology, Profile::tight); });
  const double all = time([&] {
    Diagnostics diagnostics;
    if (!analyse(model, {}, diagnostics)) fmt::print("no result\n");
  });
  fmt::print("  {:<34} {:>6} {:>10.1f} {:>10.1f} {:>14.1f}\n", name, model.devices.size(), paper, tight, all);
}

}  // namespace

int main(int argc, char** argv) {
  const std::string wanted = argc > 1 ? argv[1] : "";  // only the analyses whose name contains it, to profile them
  if (wanted.empty()) print_tightness();
  const auto print_cost = [&](std::string_view name, std::size_t count, const std::vector<std::int64_t>& periods_ms) {
    if (name.find(wanted) != std::string_view::npos) ::print_cost(name, large_model(count, periods_ms));
  };
  fmt::print("\nanalysis [ms], best of three        devices      paper      tight     everything\n");
  print_cost("one period", 10'000, {10});
  print_cost("1, 2, 5, 10, 20, 25, 50, 100 ms", 10'000, {1, 2, 5, 10, 20, 25, 50, 100});
  print_cost("2, 3, 4, 5, 6, 10, 15 ms", 10'000, {2, 3, 4, 5, 6, 10, 15});
  print_cost("7, 11, 13, 17 ms", 10'000, {7, 11, 13, 17});
  print_cost("twenty periods from 1 to 30 ms", 10'000,
             {1, 2, 3, 4, 5, 6, 8, 9, 10, 12, 14, 15, 16, 18, 20, 21, 24, 25, 28, 30});
  print_cost("1, 2, 5, 10, 20, 25, 50, 100 ms", 100'000, {1, 2, 5, 10, 20, 25, 50, 100});
  const std::string_view busy = "four buses that all devices use";
  if (busy.find(wanted) != std::string_view::npos) ::print_cost(busy, busy_buses(10'000));
  const std::vector<std::int64_t> primes{2, 3, 5, 7, 11, 13, 17, 19};
  const std::vector<std::int64_t> twenty{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20};
  for (const std::int64_t percent : {30, 70, 97, 100, 120}) {
    const auto print_hostile = [&](std::string_view periods, std::size_t count, const auto& periods_ms) {
      const std::string name = fmt::format("{}, {} % load", periods, percent);
      if (name.find(wanted) != std::string::npos) ::print_cost(name, hostile_star(count, periods_ms, percent));
    };
    print_hostile("hostile: eight primes", 10'000, primes);
    print_hostile("hostile: 1 to 20 ms", 10'000, twenty);
    print_hostile("hostile: 1 to 20 ms", 60, twenty);
  }
}
