// CAN: latest frame per device, groups sent once, bus-off.
#include "finemote/can.hpp"

#include "bench.hpp"
#include "catch.hpp"

namespace {

using namespace finemote;

struct Fixture {
  Fixture() {
    bench::reset();
    bus.start();
  }
  static CanFrame frame(std::uint16_t id, std::uint8_t first) {
    CanFrame f;
    f.id = id;
    f.size = 8;
    f.data[0] = first;
    return f;
  }
  CanSlot one{bus, 1, 0x201, 1}, two{bus, 2, 0x202, 1};
  CanSlot* const table[2] = {&one, &two};
  CanBus bus{ports::can1, 1000000, table};
};

}  // namespace

TEST_CASE_METHOD(Fixture, "each device gets the last frame with its identifier, and when") {
  CHECK(one.received().count == 0);
  host::can1.feed(1 * kMillisecond, frame(0x201, 7));
  host::can1.feed(2 * kMillisecond, frame(0x202, 8));
  host::can1.feed(3 * kMillisecond, frame(0x201, 9));
  host::can1.feed(3 * kMillisecond, frame(0x777, 1));
  host::advance(5 * kMillisecond);
  CHECK(one.received().count == 2);
  CHECK(one.received().frame.data[0] == 9);
  CHECK(one.received().at == 3 * kMillisecond);
  CHECK(two.received().count == 1);
  CHECK(two.received().frame.data[0] == 8);
  CHECK(host::can1.accepted == std::vector<std::uint16_t>{0x201, 0x202});
}

TEST_CASE_METHOD(Fixture, "an identifier nobody knows is counted and touches nothing") {
  bus.on_frame(frame(0x333, 1), 0);
  CHECK(bus.counters().lost == 1);
  CHECK(one.received().count == 0);
}

TEST_CASE_METHOD(Fixture, "a group is one frame with four big-endian words, sent once per flush") {
  CHECK(bus.set_group(0x200, 0, 0x1234));
  CHECK(bus.set_group(0x200, 3, -2));
  bus.flush();
  bus.flush();
  host::advance(1 * kMillisecond);
  REQUIRE(host::can1.sent.size() == 1);
  const CanFrame& sent = host::can1.sent[0].frame;
  CHECK(sent.id == 0x200);
  CHECK(std::vector<std::uint8_t>(sent.data, sent.data + 8) ==
        std::vector<std::uint8_t>{0x12, 0x34, 0, 0, 0, 0, 0xFF, 0xFE});
}

TEST_CASE_METHOD(Fixture, "groups run out after five identifiers") {
  for (std::uint16_t id = 1; id <= 5; ++id) CHECK(bus.set_group(id, 0, 1));
  CHECK_FALSE(bus.set_group(6, 0, 1));
  CHECK(bus.set_group(3, 1, 1));
}

TEST_CASE_METHOD(Fixture, "more frames than mailboxes all leave, without any received frame") {
  for (std::uint16_t id = 1; id <= 5; ++id) bus.set_group(id, 0, 1);
  bus.flush();
  CHECK(one.send(frame(0x140, 1)));
  CHECK_FALSE(one.send(frame(0x140, 2)));
  CHECK(two.send(frame(0x141, 1)));
  host::advance(5 * kMillisecond);
  CHECK(host::can1.sent.size() == 7);
  CHECK(one.send(frame(0x140, 2)));
}

TEST_CASE_METHOD(Fixture, "after bus-off the groups go to zero first, and what waited is dropped") {
  bus.set_group(0x200, 0, 1000);
  host::can1.off = true;
  bus.flush();
  one.send(frame(0x140, 1));
  host::advance(1 * kMillisecond);
  CHECK(bus.unreachable());
  bus.supervise();
  host::advance(1 * kMillisecond);
  CHECK_FALSE(bus.unreachable());
  REQUIRE(host::can1.sent.size() == 1);
  CHECK(host::can1.sent[0].frame.id == 0x200);
  CHECK(host::can1.sent[0].frame.data[0] == 0);
  CHECK(host::can1.sent[0].frame.data[1] == 0);
  bus.supervise();
  CHECK(bus.counters().recoveries == 1);
}
