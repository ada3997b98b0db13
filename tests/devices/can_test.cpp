// CAN: latest frame per device, groups sent once, bus-off.
#include "finemote/can.hpp"

#include "catch.hpp"
#include "finemote/bench/bench.hpp"
#include "runtime/src/start.hpp"

namespace {

using namespace finemote;

constexpr Duration kLongestFrame = 135 * kMicrosecond;  // eight bytes with all stuff bits, at 1 Mbit/s

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
  /// It arrived then, and its interrupt saw it at once.
  static Moment at(Time time) { return {time, time}; }
  static bool set_word(CanSlot& slot, std::int16_t value) {
    const auto word = static_cast<std::uint16_t>(value);
    const std::uint8_t bytes[]{static_cast<std::uint8_t>(word >> 8), static_cast<std::uint8_t>(word & 0xFF)};
    return slot.set_shared(bytes);
  }
  /// A slot of a device that owns the first word of a frame.
  CanSlot at_frame(std::uint16_t frame) {
    return CanSlot{bus, 9, CanIds{}, CanSlot::kAnyTime, 1, CanShare{frame, 0, 2}};
  }
  static std::vector<std::uint8_t> sent_bytes(std::size_t index) {
    const CanFrame& frame = host::can1.sent.at(index).frame;
    return {frame.data, frame.data + frame.size};
  }

  CanSlot one{bus, 1, 0x201, CanSlot::kAnyTime, 1, CanShare{0x200, 0, 2}},
      two{bus, 2, 0x202, CanSlot::kAnyTime, 1, CanShare{0x200, 6, 2}};
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
  CHECK(one.received().at == 3 * kMillisecond - kLongestFrame);
  CHECK(two.received().count == 1);
  CHECK(two.received().frame.data[0] == 8);
  REQUIRE(host::can1.accepted.size() == 2);
  CHECK(host::can1.accepted[0].first == 0x201);
  CHECK(host::can1.accepted[1].first == 0x202);
}

TEST_CASE_METHOD(Fixture, "a frame is as old as the bus was busy before it: it may have waited that long") {
  const Time start = 10 * kMillisecond;
  bus.on_frame(frame(0x201, 1), at(start));
  CHECK(one.received().at == start - kLongestFrame);
  bus.on_frame(frame(0x202, 1), at(start + 120 * kMicrosecond));  // directly after it
  CHECK(two.received().at == start - kLongestFrame);
  bus.on_frame(frame(0x201, 1), at(start + 300 * kMicrosecond));  // after a pause
  CHECK(one.received().at == start + 300 * kMicrosecond - kLongestFrame);
  // The routine was late: the frame may have come with the one before.
  bus.on_frame(frame(0x202, 1), {start + 400 * kMicrosecond, start + 500 * kMicrosecond});
  CHECK(two.received().at == start + 300 * kMicrosecond - kLongestFrame);
}

TEST_CASE_METHOD(Fixture, "a frame is no older than the longest that such frames wait, however long the bus was busy") {
  CanSlot patient{bus, 1, 0x201, 300'000, 1}, other{bus, 2, 0x202, CanSlot::kAnyTime, 1};
  CanSlot* const slots[2] = {&patient, &other};
  CanBus two_slots{ports::can1, 1000000, slots};
  two_slots.start();
  const Time start = 10 * kMillisecond;
  for (unsigned i = 0; i < 8; ++i) two_slots.on_frame(frame(0x202, 1), at(start + i * 120 * kMicrosecond));
  const Time last = start + 8 * 120 * kMicrosecond;
  two_slots.on_frame(frame(0x201, 1), {last - 10 * kMicrosecond, last});
  CHECK(patient.received().at == last - 310 * kMicrosecond);
  two_slots.on_frame(frame(0x202, 1), at(last + 120 * kMicrosecond));
  CHECK(other.received().at == start - kLongestFrame);
}

TEST_CASE_METHOD(Fixture,
                 "where nobody knows how long frames wait, one may have waited for as long as the bus was busy") {
  const Time start = 10 * kMillisecond;
  Time last = start;
  for (; last < start + 3 * kSecond; last += 130 * kMicrosecond) bus.on_frame(frame(0x202, 1), at(last));
  bus.on_frame(frame(0x201, 1), at(last));
  CHECK(one.received().at == start - kLongestFrame);
}

TEST_CASE_METHOD(Fixture, "a frame may have waited for ours") {
  host::advance(10 * kMillisecond);
  const Time sent = now();
  CHECK(set_word(one, 1));
  bus.flush();
  host::advance(kMillisecond);
  bus.on_frame(frame(0x201, 1), at(sent + 240 * kMicrosecond));
  CHECK(one.received().at == sent - kMicrosecond);  // a bit earlier: both wait for the same one to begin
  bus.on_frame(frame(0x202, 1), at(sent + 500 * kMicrosecond));
  CHECK(two.received().at == sent + 500 * kMicrosecond - kLongestFrame);
}

TEST_CASE_METHOD(Fixture, "what came before the first release is not kept, as nobody knows how old it is") {
  bus.on_frame(frame(0x201, 1), {});
  CHECK(one.received().count == 0);
  bus.on_frame(frame(0x201, 2), at(1 * kMillisecond));
  CHECK(one.received().count == 1);
  CHECK(one.received().at > -1 * kMillisecond);
}

TEST_CASE_METHOD(Fixture, "an identifier nobody knows is counted and touches nothing") {
  bus.on_frame(frame(0x333, 1), at(1 * kMillisecond));
  CHECK(bus.counters().lost == 1);
  CHECK(one.received().count == 0);
}

TEST_CASE_METHOD(Fixture, "a device keeps the last frame of each entry apart, and hears only its identifiers") {
  CanInbox more[]{CanInbox{0x281, &more[1]}, CanInbox{CanIds{0x020, 32}}};
  CanSlot many{bus, 1, 0x181, CanSlot::kAnyTime, 1, CanShare{}, more};
  CanSlot silent{bus, 3, CanIds{}, CanSlot::kAnyTime, 1};
  CanSlot* const slots[2] = {&many, &silent};
  CanBus two_slots{ports::can1, 1000000, slots};
  two_slots.start();
  REQUIRE(host::can1.accepted.size() == 3);  // none for the silent one
  two_slots.on_frame(frame(0x181, 1), at(10 * kMillisecond));
  two_slots.on_frame(frame(0x281, 2), at(20 * kMillisecond));
  two_slots.on_frame(frame(0x021, 3), at(30 * kMillisecond));
  two_slots.on_frame(frame(0x03F, 4), at(40 * kMillisecond));
  CHECK(many.received().frame.data[0] == 1);
  CHECK(many.received(1).frame.data[0] == 2);
  CHECK(many.received(1).at == 20 * kMillisecond - kLongestFrame);
  CHECK(many.received(2).frame.id == 0x03F);
  CHECK(many.received(2).count == 2);
  CHECK(many.received(3).count == 0);
  for (const std::uint16_t id : {0x000, 0x01F, 0x040, 0x182}) two_slots.on_frame(frame(id, 1), at(50 * kMillisecond));
  CHECK(two_slots.counters().lost == 4);
}

TEST_CASE_METHOD(Fixture, "devices fill one frame, which is sent once per flush") {
  CHECK(set_word(one, 0x1234));
  CHECK(set_word(two, -2));
  bus.flush();
  bus.flush();
  host::advance(1 * kMillisecond);
  REQUIRE(host::can1.sent.size() == 1);
  CHECK(host::can1.sent[0].frame.id == 0x200);
  CHECK(sent_bytes(0) == std::vector<std::uint8_t>{0x12, 0x34, 0, 0, 0, 0, 0xFF, 0xFE});
}

TEST_CASE_METHOD(Fixture, "a frame waits for the end of the bucket that fills it") {
  CanSlot fast{bus, 3, CanIds{}, CanSlot::kAnyTime, 0, CanShare{0x1FF, 0, 2}};
  set_word(one, 1);  // of priority 1; a faster bucket preempts it before its second device
  set_word(fast, 2);
  bus.flush(0);
  host::advance(1 * kMillisecond);
  REQUIRE(host::can1.sent.size() == 1);
  CHECK(host::can1.sent[0].frame.id == 0x1FF);
  set_word(two, 3);
  bus.flush(1);
  host::advance(1 * kMillisecond);
  REQUIRE(host::can1.sent.size() == 2);
  CHECK(sent_bytes(1) == std::vector<std::uint8_t>{0, 1, 0, 0, 0, 0, 0, 3});
}

TEST_CASE_METHOD(Fixture, "a device's part of a frame may be any of its bytes") {
  CanSlot byte{bus, 3, CanIds{}, CanSlot::kAnyTime, 1, CanShare{0x300, 5, 1}},
      half{bus, 4, CanIds{}, CanSlot::kAnyTime, 1, CanShare{0x300, 0, 4}};
  const std::uint8_t bytes[]{1, 2, 3, 4};
  CHECK(byte.set_shared(bytes));
  CHECK(half.set_shared(bytes));
  bus.flush();
  host::advance(1 * kMillisecond);
  REQUIRE(host::can1.sent.size() == 1);
  CHECK(sent_bytes(0) == std::vector<std::uint8_t>{1, 2, 3, 4, 0, 1, 0, 0});
  CanSlot alone{bus, 5, CanIds{}, CanSlot::kAnyTime, 1};
  CHECK_FALSE(alone.set_shared(bytes));
}

TEST_CASE_METHOD(Fixture, "groups run out after five identifiers, of which the bus' own slots have the first") {
  for (std::uint16_t id = 1; id <= 4; ++id) {
    CanSlot slot = at_frame(id);
    CHECK(set_word(slot, 1));
  }
  CanSlot sixth = at_frame(6), third = at_frame(3);
  CHECK_FALSE(set_word(sixth, 1));
  CHECK(set_word(third, 1));
  CHECK(set_word(two, 1));
}

TEST_CASE_METHOD(Fixture, "more frames than mailboxes all leave, without any received frame") {
  for (std::uint16_t id = 1; id <= 4; ++id) {
    CanSlot slot = at_frame(id);
    set_word(slot, 1);
  }
  set_word(one, 1);
  bus.flush();
  CHECK(one.send(frame(0x140, 1)));
  CHECK_FALSE(one.send(frame(0x140, 2)));
  CHECK(two.send(frame(0x141, 1)));
  host::advance(5 * kMillisecond);
  CHECK(host::can1.sent.size() == 7);
  CHECK(one.send(frame(0x140, 2)));
}

TEST_CASE_METHOD(Fixture, "after bus-off the groups go to zero first, and what waited is dropped") {
  set_word(one, 1000);
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

TEST_CASE_METHOD(Fixture, "what is set before the zeros of a recovery have left does not take their place") {
  set_word(one, 1000);
  host::can1.off = true;
  bus.flush();
  host::advance(1 * kMillisecond);
  bus.supervise();
  set_word(one, 1000);
  bus.flush();
  host::advance(1 * kMillisecond);
  REQUIRE_FALSE(host::can1.sent.empty());
  for (const auto& sent : host::can1.sent) CHECK(sent.frame.data[0] == 0);
  set_word(one, 1000);
  bus.flush();
  host::advance(1 * kMillisecond);
  CHECK(host::can1.sent.back().frame.data[0] == 1000 >> 8);
}

TEST_CASE_METHOD(Fixture, "a frame whose request a stop of the robot cut off leaves, and the safe one after it") {
  struct Stop {};
  host::can1.when_pended = [] { throw Stop{}; };
  CHECK_THROWS_AS(one.send(frame(0x140, 1)), Stop);
  host::can1.when_pended = nullptr;
  detail::set_stopped(true);
  CHECK_FALSE(one.send(frame(0x140, 0)));  // the one before still waits
  bus.supervise();
  host::advance(1 * kMillisecond);
  CHECK(one.send(frame(0x140, 0)));
  host::advance(1 * kMillisecond);
  REQUIRE(host::can1.sent.size() == 2);
  CHECK(host::can1.sent[1].frame.data[0] == 0);
}
