// Beyond the limits of exactness the analysis still answers: never less than the exact value, and marked; and at
// exactly the limit of the processor it agrees with the simulation.
#include "catch.hpp"
#include "duration_literals.hpp"
#include "generator/simulate/simulate.hpp"
#include "generator/timing/analyse.hpp"
#include "generator/timing/json.hpp"
#include "timing_random.hpp"

using namespace finemote::gen;
using namespace finemote::gen::timing;

namespace {

constexpr int kForests = 60;

/// From nothing at all to almost enough.
constexpr Limits kTooLow[] = {{0, 0, 1 << 26},        {3, 2, 1 << 26},         {1'000'000, 1'000, 0},
                              {1'000'000, 1'000, 60}, {1'000'000, 1'000, 400}, {1'000'000, 1'000, 3'000}};

/// No bound counts as the largest.
Duration value(std::optional<Duration> bound) { return bound.value_or(kNever); }

/// Counts what was compared, and checks it: a bound is not smaller, and where it differs, it is marked.
struct Comparison {
  int closed = 0, larger = 0;

  void of(std::optional<Duration> bound, std::optional<Duration> exact, bool closed_form) {
    CHECK(value(bound) >= value(exact));
    if (bound != exact) CHECK(closed_form);
    closed += closed_form ? 1 : 0;
    larger += bound != exact ? 1 : 0;
  }

  void of(const ProfileResult& bounds, const ProfileResult& exact) {
    for (std::size_t w = 0; w < exact.buckets.size(); ++w) {
      of(bounds.buckets[w].response, exact.buckets[w].response, bounds.buckets[w].closed_form);
    }
    for (const Rank d : exact.devices.ids()) {
      const DeviceResult &b = bounds.devices[d], &e = exact.devices[d];
      of(b.r_plus, e.r_plus, b.closed_form);
      of(b.r_minus, e.r_minus, b.closed_form);
      of(b.window, e.window, b.closed_form);
    }
    for (std::size_t t = 0; t < exact.trees.size(); ++t) of(bounds.trees[t], exact.trees[t]);
  }

  void of(const TreeResult& bounds, const TreeResult& exact) {
    // Where a deadline is no longer proven, nothing else of the tree is.
    const bool lost = exact.latency && !bounds.latency;
    if (exact.cross_latency) of(bounds.cross_latency, exact.cross_latency, bounds.closed_form || lost);
    for (std::size_t p = 0; p < exact.paths.size(); ++p) {
      const PathResult &b = bounds.paths[p], &e = exact.paths[p];
      of(b.latency, e.latency, b.closed_form || (e.latency && !b.latency));
      if (b.closed_form) CHECK_FALSE(b.release.has_value());
    }
  }
};

std::vector<ChainEnds> leaf_paths(const Topology& topology) {
  std::vector<ChainEnds> chains;
  for (const auto& leaves : topology.leaves) {
    for (const Rank leaf : leaves) chains.push_back({leaf, leaf});
  }
  return chains;
}

/// Whether a run stayed below the bounds.
bool holds(const ProfileResult& bounds, const Simulation& run) {
  bool good = true;
  for (const Rank d : bounds.devices.ids()) {
    const DeviceResult& b = bounds.devices[d];
    good &= run.devices[d].update_response <= value(b.r_plus) && run.devices[d].response <= value(b.r_minus);
    good &= bounds.profile == Profile::paper || run.devices[d].window <= value(b.window);
  }
  std::size_t chain = 0;
  for (const TreeResult& tree : bounds.trees) {
    for (const PathResult& path : tree.paths) good &= run.chains[chain++].latency <= value(path.latency);
  }
  return good;
}

/// `count` devices on periods of 1 to 20 ms, in one tree of random shape or as a star.
Model on_twenty_periods(std::size_t count, std::int64_t percent, bool is_star) {
  Random random(7);
  Model model;
  model.tick = milliseconds(1);
  model.devices.resize(count);
  const auto last = static_cast<std::int64_t>(count) - 1;
  for (std::int64_t d = last; d >= 0; --d) {
    Device& device = model.devices[Rank{static_cast<std::size_t>(d)}];
    device.name = "d" + std::to_string(d);
    device.period = milliseconds(d % 20 + 1);
    if (d < last) device.parent = Rank{static_cast<std::size_t>(is_star ? last : random.between(d + 1, last))};
    device.update_wcet = device.handle_wcet =
        floor_div(device.period * percent, static_cast<std::int64_t>(count) * 200);
  }
  return model;
}

}  // namespace

TEST_CASE("a closed form is never smaller than the exact bound, nor than what is simulated, and it is marked") {
  Comparison compared;
  for (const ForestClass kind : kForestClasses) {
    for (std::uint64_t i = 0; i < kForests; ++i) {
      RandomForest source(i * 4 + static_cast<std::uint64_t>(kind) + 6'000'000);
      Model model = source.make(kind);
      if (i % 2 == 0) source.extend(model);
      const Topology topology = make_topology(model);
      for (const Profile profile : {Profile::paper, Profile::tight, Profile::target}) {
        if (profile == Profile::target && !model.has_target) continue;
        const ProfileResult exact = analyse_profile(model, topology, profile).result;
        const Profile simulated = profile == Profile::target ? profile : Profile::tight;
        const Simulation run = simulate(model, {i, 20'000_ns, simulated, leaf_paths(topology)});
        for (const Limits& limits : kTooLow) {
          INFO("limits " << limits.releases << " " << limits.steps << " " << model_json(model).dump());
          const ProfileResult bounds = analyse_profile(model, topology, profile, limits).result;
          compared.of(bounds, exact);
          CHECK(holds(bounds, run));
          if (bounds.schedulable) CHECK(run.misses == 0);
        }
      }
    }
  }
  CHECK(compared.closed > 20'000);
  CHECK(compared.larger > 2'000);
}

TEST_CASE("a chain beyond the limits is bounded by a closed form, through reads or not") {
  int closed = 0;
  for (const ForestClass kind : kForestClasses) {
    for (std::uint64_t i = 0; i < kForests; ++i) {
      RandomForest source(i * 4 + static_cast<std::uint64_t>(kind) + 7'000'000);
      Model model = source.make(kind);
      source.observe(model);
      const Topology topology = make_topology(model);
      const ProfileAnalysis exact = analyse_profile(model, topology, Profile::tight);
      Effort effort;
      const WireAnalysis wire(model, exact, effort);
      const ChainAnalysis exact_chains(model, topology, exact, wire, wire.acquisitions(), effort);
      for (const Limits& limits : kTooLow) {
        const ProfileAnalysis analysis = analyse_profile(model, topology, Profile::tight, limits);
        Effort little(limits.steps, analysis.most_releases);
        const WireAnalysis other_wire(model, analysis, little);
        const ChainAnalysis chains(model, topology, analysis, other_wire, other_wire.acquisitions(), little);
        for (const Rank from : model.devices.ids()) {
          for (const Rank to : model.devices.ids()) {
            if (!chains.connected(from, to)) continue;
            const ChainResult bound = chains.bound(from, to), other = exact_chains.bound(from, to);
            INFO("limits " << limits.releases << " " << limits.steps << " " << from.value() << "->" << to.value() << " "
                           << model_json(model).dump());
            CHECK(value(bound.decide) >= value(other.decide));
            if (bound.decide && bound.decide != other.decide) CHECK(bound.closed_form);
            closed += bound.closed_form ? 1 : 0;
          }
        }
      }
    }
  }
  CHECK(closed > 5'000);
}

TEST_CASE("many periods need few steps, whatever the load and the shape of the tree") {
  for (const bool is_star : {true, false}) {
    for (const std::int64_t percent : {30, 70, 97, 100, 120}) {
      const Model model = on_twenty_periods(60, percent, is_star);
      const Topology topology = make_topology(model);
      for (const Profile profile : {Profile::paper, Profile::tight}) {
        const ProfileResult whole = analyse_profile(model, topology, profile).result;
        const ProfileResult little = analyse_profile(model, topology, profile, {1'000'000, 1'000, 4'000'000}).result;
        CHECK(profile_json(model, whole) == profile_json(model, little));
        if (profile == Profile::tight) CHECK(whole.devices[Rank{19}].closed_form == whole.buckets.back().ok);
      }
    }
  }
}

TEST_CASE("periods whose common multiple leaves 64 bits have bounds") {
  Model model;
  model.devices.resize(2);
  model.devices[Rank{0}] = {};
  model.devices[Rank{0}].name = "leaf";
  model.devices[Rank{0}].parent = Rank{1};
  model.devices[Rank{0}].period = 4'294'967'291_ns;
  model.devices[Rank{0}].update_wcet = model.devices[Rank{0}].handle_wcet = 10_ns;
  model.devices[Rank{1}] = model.devices[Rank{0}];
  model.devices[Rank{1}].name = "root";
  model.devices[Rank{1}].parent = std::nullopt;
  model.devices[Rank{1}].period = 4'294'967'279_ns;
  Diagnostics diagnostics;
  const auto timing = analyse(model, {}, diagnostics);
  REQUIRE(timing);
  CHECK(timing->schedulable);
  CHECK(timing->tight.trees.front().paths.front().closed_form);
  REQUIRE(diagnostics.size() == 1);
  CHECK(diagnostics.in_file_order().front().code == code::timing_closed_form);
}

TEST_CASE("on a fully used processor with empty stages anywhere, what is schedulable misses nothing") {
  int full = 0, at_the_period = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    Random random(seed);
    Model model;
    model.tick = 10_ns;
    // Buckets of 20, 40 and 80 ns; the slowest one takes what the others leave.
    const Duration cost[] = {nanoseconds(random.between(1, 12)), nanoseconds(random.between(1, 14)), {}};
    const Duration rest = 80_ns - 4 * cost[0] - 2 * cost[1];
    const int buckets = rest > Duration::zero() ? 3 : 2;
    for (int w = buckets; w-- > 0;) {
      const auto count = random.between(1, 3);
      const std::size_t first = model.devices.size();
      for (std::int64_t d = 0; d < count; ++d) {
        Device device;
        device.name = "d" + std::to_string(model.devices.size());
        device.period = 20_ns * (std::int64_t{1} << w);
        model.devices.push_back(device);
      }
      // All of it in one stage or in two; every other stage is empty.
      Duration left = buckets == 2 && w == 1 ? 40_ns - 2 * cost[0] : w == 2 ? rest : cost[w];
      while (left > Duration::zero()) {
        const Duration part = random.one_in(2) ? left : random.between(1_ns, left);
        Device& device = model.devices[Rank{first + static_cast<std::size_t>(random.between(0, count - 1))}];
        (random.one_in(2) ? device.update_wcet : device.handle_wcet) += part;
        left -= part;
      }
    }
    const Topology topology = make_topology(model);
    const ProfileResult bounds = analyse_profile(model, topology, Profile::tight).result;
    INFO("seed " << seed << " " << model_json(model).dump());
    CHECK(test_utilization(model).utilization.exact == "1/1");
    for (std::uint64_t run_seed = 1; run_seed <= 4; ++run_seed) {
      const Simulation run = simulate(model, {run_seed, 8'000_ns, Profile::tight, leaf_paths(topology)});
      CHECK(holds(bounds, run));
      if (bounds.schedulable) CHECK(run.misses == 0);
    }
    full += bounds.schedulable ? 1 : 0;
    for (const BucketResult& bucket : bounds.buckets) at_the_period += bucket.response == bucket.period ? 1 : 0;
  }
  CHECK(full > 100);
  CHECK(at_the_period > 100);
}

TEST_CASE("the run in which everything takes its longest misses a deadline exactly where the analysis says so") {
  int schedulable = 0, missed = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    Random random(seed);
    Model model;
    model.tick = 1_us;
    model.has_target = true;  // without any costs
    const std::int64_t percent = random.between(5, 11) * 10;
    const auto count = random.between(1, 80);
    for (std::int64_t i = 0; i < count; ++i) {
      Device device;
      device.name = "d" + std::to_string(i);
      device.period = microseconds(random.between(1, 20));
      const Duration share = floor_div(device.period * percent, count * 100);
      if (!random.one_in(3)) device.update_wcet = device.update_bcet = random.between({}, share);
      if (!random.one_in(3)) device.handle_wcet = device.handle_bcet = share - device.update_wcet;
      model.devices.push_back(device);
    }
    const ProfileResult bounds = analyse_profile(model, make_topology(model), Profile::target).result;
    const Simulation run = simulate(model, {seed, 40_us, Profile::target, {}});
    INFO("seed " << seed << " " << model_json(model).dump());
    CHECK(bounds.schedulable == (run.misses == 0));
    for (const Rank d : model.devices.ids()) {
      if (bounds.devices[d].r_minus) CHECK(run.devices[d].response == *bounds.devices[d].r_minus);
    }
    schedulable += bounds.schedulable ? 1 : 0;
    missed += run.misses > 0 ? 1 : 0;
  }
  CHECK(schedulable > 30);
  CHECK(missed > 30);
}

TEST_CASE("a simulation ends, however much there is to do") {
  Model model;
  model.tick = 1_ns;
  Device device;
  device.name = "d";
  device.period = 1_ns;
  model.devices.push_back(device);
  SimulationOptions options{1, 10_s, Profile::tight, {}};
  options.most_steps = 10'000;
  const Simulation many = simulate(model, options);
  CHECK(many.duration > Duration::zero());
  CHECK(many.duration <= 10_us);
  Bus bus;
  bus.name = "b";
  bus.frame = 1_ns;
  bus.wcet = 1_s;
  model.buses.push_back(bus);
  options.most_waiting = 10;
  CHECK(simulate(model, options).duration < 10_s);
}

TEST_CASE("an empty last stage that ends with its period is no miss, and a job that ends later is one") {
  Model model;
  model.tick = 10_ns;
  Device device;
  device.name = "d";
  device.period = 10_ns;
  device.update_wcet = 10_ns;
  model.devices.push_back(device);
  const auto misses = [&] { return simulate(model, {1, 1'000_ns, Profile::tight, {}}).misses; };
  CHECK(analyse_profile(model, make_topology(model), Profile::tight).result.schedulable);
  CHECK(misses() == 0);
  model.devices[Rank{0}].handle_wcet = 1_ns;
  CHECK_FALSE(analyse_profile(model, make_topology(model), Profile::tight).result.schedulable);
  CHECK(misses() > 0);
}
