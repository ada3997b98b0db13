// The most that buses carry in a time, and how often they interrupt.
#include "generator/timing/traffic_limits.hpp"
#include "catch.hpp"
#include "duration_literals.hpp"

using namespace finemote::gen;
using namespace finemote::gen::timing;

namespace {

constexpr BusPlace kBus{0};

Transfer transfer(Transfer::After after, Duration wire) {
  Transfer t;
  t.bus = kBus;
  t.after = after;
  t.wire = wire;
  return t;
}

/// A device of 1 us on a bus, which asks for 100 ns of it in every period.
Model robot() {
  Model model;
  model.has_target = true;
  model.tick = 1000_ns;
  Bus bus;
  bus.sources.emplace();
  model.buses.push_back(bus);
  Device device;
  device.name = "d";
  device.period = 1000_ns;
  device.transfers.push_back(transfer(Transfer::After::update, 100_ns));
  model.devices.push_back(device);
  return model;
}

TrafficLimit limit(const Model& model, Duration window) { return traffic_limits(model, window)[kBus]; }

}  // namespace

TEST_CASE("a transfer of each release, of one before them, and of one that began at the end") {
  CHECK(limit(robot(), 10'000_ns).wire == 1200_ns);
  CHECK(limit(robot(), 10'001_ns).wire == 1300_ns);
  CHECK(limit(robot(), 1_ns).wire == 300_ns);
}

TEST_CASE("what a part sends by itself goes by its own interval") {
  Model model = robot();
  Transfer by_itself = transfer(Transfer::After::autonomous, 10_ns);
  by_itself.min_interval = 250_ns;
  model.devices[Rank{0}].transfers.push_back(by_itself);
  CHECK(limit(model, 10'000_ns).wire == 1200_ns + 42 * 10_ns);
}

TEST_CASE("a bus with two lines: what is received meets nothing that is sent, and answers may take as long") {
  Model model = robot();
  Transfer by_itself = transfer(Transfer::After::autonomous, 10_ns);
  by_itself.receive = true;
  model.devices[Rank{0}].transfers.push_back(by_itself);
  CHECK(limit(model, 10'000_ns).wire == 1200_ns);
  CHECK(limit(model, 10'000_ns).received == 120_ns);
  model.devices[Rank{0}].transfers.front().reads = true;
  CHECK(limit(model, 10'000_ns).wire == 1200_ns);
  CHECK(limit(model, 10'000_ns).received == 1320_ns);
}

TEST_CASE("a flush counts like a transfer of its bucket") {
  Model model = robot();
  Flush flush;
  flush.period = 1000_ns;
  flush.bus = kBus;
  flush.wire = 7_ns;
  model.flushes.push_back(flush);
  CHECK(limit(model, 10'000_ns).wire == 1284_ns);
}

TEST_CASE("somebody who does not say what it sends takes the limit of the wire, and not that of interrupts") {
  Model model = robot();
  model.buses[kBus].sources = {InterruptSource{"s", 5_ns, 100_ns, {}}};
  model.devices[Rank{0}].undeclared.push_back(kBus);
  const TrafficLimit found = limit(model, 10'000_ns);
  CHECK_FALSE(found.wire);
  CHECK_FALSE(found.received);
  CHECK(found.interrupts == 100);
}

TEST_CASE("interrupts of all sources: as far apart as they are, or as often as they are allowed") {
  Model model = robot();
  InterruptSource budgeted{"s", 5_ns, 1_ns, {}};
  budgeted.budgets.push_back({Rank{0}, 3, 1, {}});
  model.buses[kBus].sources = {budgeted, InterruptSource{"t", 2_ns, 500_ns, {}}};
  CHECK(limit(model, 10'000_ns).interrupts == 3 * 11 + 20);

  SECTION("what the DMA takes is no routine") {
    InterruptSource dma{"dma", 1_ns, 10_ns, {}};
    dma.steals = true;
    model.buses[kBus].sources->push_back(dma);
    CHECK(limit(model, 10'000_ns).interrupts == 3 * 11 + 20);
  }
  SECTION("a routine that takes no time is in no task set, so nobody counts it") {
    model.buses[kBus].sources->push_back(InterruptSource{"free", {}, 500_ns, {}});
    CHECK_FALSE(limit(model, 10'000_ns).interrupts);
  }
}
