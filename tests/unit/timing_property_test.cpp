// The analysis against its definitions and against simulations, over random forests.
// FINEMOTE_FORESTS sets how many forests of each class are tried.
#include <cstdlib>

#include "catch.hpp"
#include "duration_literals.hpp"
#include "generator/simulate/simulate.hpp"
#include "generator/timing/analyse.hpp"
#include "generator/timing/json.hpp"
#include "timing_random.hpp"
#include "timing_reference.hpp"

using namespace finemote::gen;
using namespace finemote::gen::timing;

namespace {

int forests(int fallback) {
  const char* text = std::getenv("FINEMOTE_FORESTS");
  return text != nullptr ? std::atoi(text) : fallback;
}

std::uint64_t seed_of(ForestClass kind, int i) {
  return static_cast<std::uint64_t>(i) * 4 + static_cast<std::uint64_t>(kind) + 1;
}

std::vector<ChainEnds> leaf_paths(const Topology& topology) {
  std::vector<ChainEnds> chains;
  for (const auto& leaves : topology.leaves) {
    for (const Rank leaf : leaves) chains.push_back({leaf, leaf});
  }
  return chains;
}

std::vector<ChainEnds> leaf_pairs(const Topology& topology) {
  std::vector<ChainEnds> chains;
  for (const auto& leaves : topology.leaves) {
    for (const Rank a : leaves) {
      for (const Rank b : leaves) chains.push_back({a, b});
    }
  }
  return chains;
}

Duration run_length(const Model& model) {
  Duration common = nanoseconds(1);
  for (const Device& d : model.devices) common = lcm(common, d.period);
  return 4 * common;
}

/// Empty when nothing that was simulated is above its bound.
std::string violation(const Model& model, const ProfileResult& bounds, const Simulation& run) {
  for (const Rank d : model.devices.ids()) {
    const DeviceResult& b = bounds.devices[d];
    const Simulation::DeviceWorst& w = run.devices[d];
    if (!b.r_minus) continue;
    if (w.update_response > *b.r_plus) return "R+ of " + model.devices[d].name;
    if (w.response > *b.r_minus) return "R- of " + model.devices[d].name;
    if (b.window && w.window > *b.window) return "window of " + model.devices[d].name;
  }
  std::size_t chain = 0;
  for (const TreeResult& tree : bounds.trees) {
    for (const PathResult& path : tree.paths) {
      const Duration seen = run.chains[chain++].latency;
      if (path.latency && seen > *path.latency) return "latency of " + model.devices[path.leaf].name;
    }
  }
  return {};
}

std::optional<Ns> ns(std::optional<Duration> time) { return time ? std::optional(time->ns()) : std::nullopt; }

void check_path(const PathResult& found, std::optional<Reference::Path> expected) {
  REQUIRE(found.latency.has_value() == expected.has_value());
  if (!expected) return;
  CHECK(found.latency->ns() == expected->value);
  CHECK(found.release->ns() == expected->release);
  CHECK(found.source_release->ns() == expected->source);
}

void check_profile(const Model& model, Profile profile) {
  const Topology topology = make_topology(model);
  const ProfileResult found = analyse_profile(model, topology, profile).result;
  Reference reference(model, profile == Profile::tight);
  for (const Rank d : model.devices.ids()) {
    CHECK(ns(found.devices[d].r_plus) == reference.r(d, false));
    CHECK(ns(found.devices[d].r_minus) == reference.r(d, true));
    if (profile == Profile::tight) CHECK(ns(found.devices[d].window) == reference.window(d));
  }
  for (const TreeResult& tree : found.trees) {
    Ns cross = 0;
    for (const PathResult& path : tree.paths) {
      check_path(path, reference.path(path.leaf, path.leaf));
      for (const PathResult& other : tree.paths) {
        if (!tree.cross_latency) break;
        cross = std::max(cross, reference.path(other.leaf, path.leaf)->value);
      }
    }
    if (tree.cross_latency) CHECK(tree.cross_latency->ns() == cross);
    if (tree.corollary) CHECK(*tree.corollary == *tree.latency);
  }
}

}  // namespace

TEST_CASE("the algorithms give what the definitions say") {
  for (const ForestClass kind : kForestClasses) {
    for (int i = 0; i < forests(60); ++i) {
      const Model model = RandomForest(seed_of(kind, i)).make(kind);
      INFO("seed " << seed_of(kind, i) << " " << model_json(model).dump());
      check_profile(model, Profile::paper);
      check_profile(model, Profile::tight);
    }
  }
}

TEST_CASE("no simulated value is above its bound") {
  int schedulable = 0;
  for (const ForestClass kind : kForestClasses) {
    for (int i = 0; i < forests(1000); ++i) {
      const std::uint64_t seed = seed_of(kind, i) + 1'000'000;
      RandomForest source(seed);
      Model model = source.make(kind);
      const Topology topology = make_topology(model);
      const auto check = [&](Profile profile, Profile simulated, std::uint64_t run_seed) {
        const ProfileResult bounds = analyse_profile(model, topology, profile).result;
        const Simulation run = simulate(model, {run_seed, run_length(model), simulated, leaf_paths(topology)});
        INFO("seed " << seed << " run " << run_seed << " " << model_json(model).dump());
        CHECK(violation(model, bounds, run) == "");
        if (bounds.schedulable) CHECK(run.misses == 0);
        schedulable += bounds.schedulable ? 1 : 0;
      };
      check(Profile::paper, Profile::paper, seed);
      check(Profile::tight, Profile::tight, seed + 1);
      source.extend(model);
      check(Profile::target, Profile::target, seed + 2);
    }
  }
  CHECK(schedulable > 4 * forests(1000));
}

TEST_CASE("no simulated pair of leaves is above the cross latency") {
  for (const ForestClass kind : kForestClasses) {
    for (int i = 0; i < forests(200); ++i) {
      const Model model = RandomForest(seed_of(kind, i) + 2'000'000).make(kind);
      const Topology topology = make_topology(model);
      const ProfileResult bounds = analyse_profile(model, topology, Profile::paper).result;
      const Simulation run = simulate(model, {7, run_length(model), Profile::paper, leaf_pairs(topology)});
      std::size_t chain = 0;
      for (const TreeResult& tree : bounds.trees) {
        for (std::size_t pair = 0; pair < tree.paths.size() * tree.paths.size(); ++pair) {
          const Duration seen = run.chains[chain++].latency;
          if (tree.cross_latency) CHECK(seen <= *tree.cross_latency);
        }
      }
    }
  }
}

TEST_CASE("no simulated chain is above its decision bound, through reads or not") {
  int compared = 0, through_reads = 0;
  for (const ForestClass kind : kForestClasses) {
    for (int i = 0; i < forests(300); ++i) {
      const std::uint64_t seed = seed_of(kind, i) + 4'000'000;
      RandomForest source(seed);
      Model model = source.make(kind);
      source.extend(model);
      source.observe(model);
      const Topology topology = make_topology(model);
      for (const Profile profile : {Profile::tight, Profile::target}) {
        const ProfileAnalysis analysis = analyse_profile(model, topology, profile);
        Effort effort;
        const WireAnalysis wire(model, analysis, effort);
        const ChainAnalysis chains(model, topology, analysis, wire, wire.acquisitions(), effort);
        std::vector<ChainEnds> ends;
        for (const Rank a : model.devices.ids()) {
          for (const Rank b : model.devices.ids()) {
            if (chains.connected(a, b)) ends.push_back({a, b});
          }
        }
        const Simulation run = simulate(model, {seed, run_length(model), profile, ends});
        for (const Simulation::ChainWorst& seen : run.chains) {
          const ChainResult bound = chains.bound(seen.ends.from, seen.ends.to);
          if (!bound.decide) continue;
          INFO("seed " << seed << " " << seen.ends.from.value() << "->" << seen.ends.to.value() << " "
                       << model_json(model).dump());
          CHECK(seen.latency <= *bound.decide);
          ++compared;
          through_reads += bound.through_reads ? 1 : 0;
        }
        for (const TreeResult& tree : analysis.result.trees) {
          for (const PathResult& path : tree.paths) {
            if (!model.devices[path.leaf].reads.empty() || !path.latency) continue;
            CHECK(*chains.bound(path.leaf, path.leaf).decide >= *path.latency);
          }
        }
      }
    }
  }
  CHECK(compared > 20 * forests(300));
  CHECK(through_reads > forests(300));
}

TEST_CASE("the default chains of a large tree are at least those of every pair") {
  int bounded = 0, through_reads = 0;
  for (const ForestClass kind : kForestClasses) {
    for (int i = 0; i < forests(60); ++i) {
      RandomForest source(seed_of(kind, i) + 5'000'000);
      Model model = source.make(kind);
      if (i % 2 == 0) source.observe(model);
      const Topology topology = make_topology(model);
      const ProfileAnalysis analysis = analyse_profile(model, topology, Profile::tight);
      Effort effort;
      const WireAnalysis wire(model, analysis, effort);
      const ChainAnalysis pairs(model, topology, analysis, wire, wire.acquisitions(), effort);
      const ChainAnalysis groups(model, topology, analysis, wire, wire.acquisitions(), effort, 0);
      const auto exact = pairs.defaults(), quick = groups.defaults();
      REQUIRE(exact.size() == quick.size());
      for (std::size_t c = 0; c < exact.size(); ++c) {
        REQUIRE(exact[c].to == quick[c].to);
        REQUIRE(exact[c].decide.has_value() == quick[c].decide.has_value());
        if (!exact[c].decide) continue;
        CHECK(*quick[c].decide >= *exact[c].decide);
        CHECK(*quick[c].decide >= *pairs.bound(quick[c].from, quick[c].to).decide);
        ++bounded;
        through_reads += quick[c].through_reads ? 1 : 0;
      }
    }
  }
  CHECK(bounded > 4 * forests(60));
  CHECK(through_reads > 0);
}

TEST_CASE("every classic mistake is caught by the same property") {
  const auto caught = [](Mistakes mistakes) {
    int count = 0;
    for (const ForestClass kind : kForestClasses) {
      for (int i = 0; i < 300; ++i) {
        const Model model = RandomForest(seed_of(kind, i) + 3'000'000).make(kind);
        const Topology topology = make_topology(model);
        const ProfileAnalysis real = analyse_profile(model, topology, Profile::paper);
        if (!real.result.schedulable) continue;
        Reference wrong(model, false, mistakes);
        ProfileResult bounds = real.result;
        for (const Rank d : model.devices.ids()) {
          bounds.devices[d].r_plus = nanoseconds(*wrong.r(d, false));
          bounds.devices[d].r_minus = nanoseconds(*wrong.r(d, true));
        }
        for (TreeResult& tree : bounds.trees) {
          for (PathResult& path : tree.paths) path.latency = nanoseconds(wrong.path(path.leaf, path.leaf)->value);
        }
        const Simulation run = simulate(model, {11, run_length(model), Profile::tight, leaf_paths(topology)});
        count += violation(model, bounds, run).empty() ? 0 : 1;
      }
    }
    return count;
  };
  CHECK(caught({}) == 0);
  CHECK(caught({true, false, false}) > 0);
  CHECK(caught({false, true, false}) > 0);
  CHECK(caught({false, false, true}) > 0);
}

TEST_CASE(
    "below an empty bucket the data of an empty stage is there at once, and in profile target a nanosecond later") {
  Model model;
  model.tick = 10_ns;
  Device slow, fast;
  slow.name = "slow";
  slow.parent = Rank{1};
  slow.period = 40_ns;
  slow.handle_wcet = 1_ns;
  fast.name = "fast";
  fast.period = 10_ns;
  model.devices = {slow, fast};
  const Topology topology = make_topology(model);
  const auto bound = [&](Profile profile) {
    return *analyse_profile(model, topology, profile).result.trees.front().latency;
  };
  const auto simulated = [&](Profile profile) {
    return simulate(model, {1, 400_ns, profile, {{Rank{0}, Rank{0}}}}).chains.front().latency;
  };
  CHECK(bound(Profile::tight) == 1_ns);
  CHECK(simulated(Profile::tight) == 1_ns);
  CHECK(bound(Profile::target) == 41_ns);
  CHECK(simulated(Profile::target) == 41_ns);
}

TEST_CASE("no simulated chain between two devices takes longer than its bound, and some come near where jobs meet") {
  int together = 0;
  double nearest = 0;
  for (const ForestClass kind : kForestClasses) {
    for (int i = 0; i < forests(300); ++i) {
      const std::uint64_t seed = seed_of(kind, i) + 3'000'000;
      RandomForest source(seed);
      Model model = source.make(kind);
      source.extend(model);
      AnalysisRequest request;
      for (const ChainEnds& ends : leaf_pairs(make_topology(model))) request.chains.push_back({ends.from, ends.to});
      Diagnostics diagnostics;
      const auto timing = analyse(model, request, diagnostics);
      REQUIRE(timing);
      std::vector<ChainEnds> chains;
      for (const ChainResult& chain : timing->chains) chains.push_back({chain.from, chain.to});
      REQUIRE(chains.size() == request.chains.size());
      const Simulation run = simulate(model, {seed, run_length(model), Profile::target, chains});
      for (std::size_t c = 0; c < chains.size(); ++c) {
        const auto& decide = timing->chains[c].decide;
        if (!decide) continue;
        const Device &from = model.devices[chains[c].from], &to = model.devices[chains[c].to];
        INFO("seed " << seed << " " << from.name << " to " << to.name << " " << model_json(model).dump());
        const std::int64_t seen = run.chains[c].latency.ns(), bound = decide->ns();
        CHECK(seen <= bound);
        if (from.period >= to.period || *decide >= to.period) continue;
        ++together;
        nearest = std::max(nearest, static_cast<double>(seen) / static_cast<double>(bound));
      }
    }
  }
  CHECK(together > forests(300) / 2);
  CHECK(nearest > 0.9);
}
