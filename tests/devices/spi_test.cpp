// SPI: order by priority, one exchange at a time, deadlines.
#include "finemote/spi.hpp"

#include "catch.hpp"
#include "finemote/bench/bench.hpp"

namespace {

using namespace finemote;
using Bytes = std::vector<std::uint8_t>;

struct Inverter : host::SpiPart {
  Bytes exchange(const Bytes& bytes) override {
    Bytes out;
    for (const std::uint8_t b : bytes) out.push_back(static_cast<std::uint8_t>(~b));
    times.push_back(now());
    return out;
  }
  std::vector<Time> times;
};

struct Fixture {
  Fixture() {
    bench::reset();
    host::spi1.connect(0, accel);
    host::spi1.connect(1, gyro);
    bus.start();
  }
  Inverter accel, gyro;
  SpiSlot gyro_slot{bus, 1, 1}, accel_slot{bus, 0, 2};
  SpiSlot* const table[2] = {&gyro_slot, &accel_slot};
  SpiBus bus{ports::spi1, 1000000, table};
  const std::uint8_t out[3] = {0x01, 0x02, 0x03};
  std::uint8_t in[3] = {};
};

}  // namespace

TEST_CASE_METHOD(Fixture, "the urgent chip goes first, bytes move both ways") {
  accel_slot.start(out, in, 3);
  gyro_slot.start(out, nullptr, 3);
  host::advance(1 * kMillisecond);
  REQUIRE(gyro.times.size() == 1);
  REQUIRE(accel.times.size() == 1);
  CHECK(gyro.times[0] == 24 * kMicrosecond);
  CHECK(accel.times[0] == 48 * kMicrosecond);
  CHECK(Bytes(in, in + 3) == Bytes{0xFE, 0xFD, 0xFC});
  CHECK(accel_slot.done());
}

TEST_CASE_METHOD(Fixture, "an exchange that never ends fails, and the next one runs") {
  host::spi1.block(true);
  gyro_slot.start(out, in, 3);
  host::advance(1 * kMillisecond);
  bus.supervise();
  host::advance(1 * kMillisecond);
  CHECK(gyro_slot.busy());  // it may only be late
  bus.supervise();
  host::advance(1);
  CHECK(gyro_slot.state() == SlotState::kFailed);
  CHECK(bus.counters().overdue == 1);
  host::spi1.block(false);
  accel_slot.start(out, in, 3);
  host::advance(1 * kMillisecond);
  CHECK(accel_slot.done());
}
