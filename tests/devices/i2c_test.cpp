// I2C: order on the wire, mux and transfer as one unit, deadlines, recovery, safe writes first.
#include "finemote/i2c.hpp"

#include <optional>

#include "catch.hpp"
#include "finemote/bench/bench.hpp"
#include "runtime/boards/host/ports/i2c_parts.hpp"
#include "runtime/src/start.hpp"

namespace {

using namespace finemote;
using Bytes = std::vector<std::uint8_t>;

/// Acknowledges everything; reads give back `answer`.
struct Echo : host::I2cPart {
  bool write(const Bytes& bytes) override {
    written.push_back(bytes);
    return true;
  }
  bool read(std::size_t size, Bytes& bytes) override {
    bytes.assign(size, answer);
    return true;
  }
  std::vector<Bytes> written;
  std::uint8_t answer = 0xA5;
};

/// Address and bytes written of every exchange, as text: "70:01 76:1e,40".
std::string wire_text() {
  static const char* const kHex = "0123456789abcdef";
  const auto hex = [](std::uint8_t b) { return std::string{kHex[b >> 4], kHex[b & 15]}; };
  std::string text;
  for (const host::I2cExchange& exchange : host::i2c2.exchanges) {
    if (!text.empty()) text += ' ';
    text += hex(exchange.address) + ":";
    for (std::size_t i = 0; i < exchange.written.size(); ++i) text += (i != 0 ? "," : "") + hex(exchange.written[i]);
    if (exchange.event == I2cEvent::kNack) text += "!";
    if (exchange.event == I2cEvent::kNone) text += "?";
  }
  return text;
}

/// Two sensors behind one mux, an actuator behind another channel, and a part of its own mux.
struct Fixture {
  Fixture() {
    bench::reset();
    first_mux.connect(0, 0x76, sensor_a);
    first_mux.connect(1, 0x76, sensor_b);
    first_mux.connect(4, 0x40, actuator);
    second_mux.connect(0, 0x76, far);
    host::i2c2.connect(0x70, first_mux);
    host::i2c2.connect(0x71, second_mux);
    host::i2c2.connect(0x20, plain);
    bench::robot().start = [this] { bus.start(); };
    bench::robot().fast = [this] { bus.supervise(); };
  }

  host::Tca9548aPart first_mux, second_mux;
  Echo sensor_a, sensor_b, actuator, far, plain;
  I2cSlot drive{bus, 0x40, {0x70, 0x10}, 1}, a{bus, 0x76, {0x70, 0x01}, 2}, b{bus, 0x76, {0x70, 0x02}, 2},
      other{bus, 0x76, {0x71, 0x01}, 3}, direct{bus, 0x20, {}, 3};
  I2cSlot* const table[5] = {&drive, &a, &b, &other, &direct};
  I2cBus bus{ports::i2c2, 400000, table};
  const std::uint8_t one[1] = {0x11}, two[2] = {0x22, 0x33};
};

}  // namespace

TEST_CASE_METHOD(Fixture, "a transfer selects its mux channel and switches every other mux off first") {
  bench::at(1 * kMillisecond, [&] { b.start(two, 2); });
  bench::run(5 * kMillisecond);
  CHECK(wire_text() == "71:00 70:02 76:22,33");
  CHECK(b.done());
  CHECK(sensor_b.written == std::vector<Bytes>{{0x22, 0x33}});
  CHECK(sensor_a.written.empty());
  CHECK(far.written.empty());
}

TEST_CASE_METHOD(Fixture, "the most urgent queued slot goes next, and a running unit is not interrupted") {
  bench::at(1 * kMillisecond, [&] {
    direct.start(one, 1);
    b.start(one, 1);
    a.start(one, 1);
  });
  bench::at(1 * kMillisecond + 60 * kMicrosecond, [&] { drive.start(one, 1); });  // during the first unit
  bench::run(5 * kMillisecond);
  CHECK(wire_text() == "71:00 70:01 76:11 70:10 40:11 70:02 76:11 20:11");
}

TEST_CASE_METHOD(Fixture, "a channel that is still selected is not selected again; another mux is switched off") {
  bench::at(1 * kMillisecond, [&] { a.start(one, 1); });
  bench::at(2 * kMillisecond, [&] { a.start(two, 2); });
  bench::at(3 * kMillisecond, [&] { other.start(one, 1); });
  bench::at(4 * kMillisecond, [&] { direct.start(one, 1); });
  bench::run(5 * kMillisecond);
  CHECK(wire_text() == "71:00 70:01 76:11 76:22,33 70:00 71:01 76:11 20:11");
}

TEST_CASE_METHOD(Fixture, "write, read and a following write are one unit") {
  std::uint8_t in[3] = {};
  bench::at(1 * kMillisecond, [&] {
    b.start(one, 1, in, 3, two, 2);
    a.start(one, 1);
  });
  bench::run(5 * kMillisecond);
  CHECK(wire_text() == "71:00 70:01 76:11 70:02 76:11 76:22,33");
  CHECK(Bytes(in, in + 3) == Bytes{0xA5, 0xA5, 0xA5});
  CHECK(b.ended() > a.ended());
}

TEST_CASE_METHOD(Fixture, "a slot takes one transfer at a time") {
  bench::at(1 * kMillisecond, [&] {
    CHECK(a.start(one, 1));
    CHECK_FALSE(a.start(two, 2));
    CHECK(a.busy());
  });
  bench::run(5 * kMillisecond);
  CHECK(sensor_a.written == std::vector<Bytes>{{0x11}});
}

TEST_CASE_METHOD(Fixture, "a part that does not answer fails alone, and is unreachable after three times") {
  host::i2c2.disconnect(0x20);
  for (int i = 1; i <= 3; ++i) {
    bench::at(i * kMillisecond, [&, i] {
      CHECK(direct.unreachable() == false);
      direct.start(one, 1);
      if (i == 3) a.start(one, 1);
    });
  }
  bench::run(5 * kMillisecond);
  CHECK(direct.state() == SlotState::kNack);
  CHECK(direct.unreachable());
  CHECK(a.done());
  CHECK(bus.ready());
  CHECK(bus.counters().transfers == 4);
  CHECK(bus.counters().errors == 3);
  CHECK(bus.counters().recoveries == 0);
}

TEST_CASE_METHOD(Fixture, "a silent mux fails the transfer behind it and is selected again the next time") {
  bench::at(1 * kMillisecond, [&] { a.start(one, 1); });
  bench::at(2 * kMillisecond, [&] {
    first_mux.silent = true;
    b.start(one, 1);
  });
  bench::at(3 * kMillisecond, [&] {
    CHECK(b.state() == SlotState::kNack);
    first_mux.silent = false;
    a.start(two, 2);
  });
  bench::run(5 * kMillisecond);
  CHECK(wire_text() ==
        "71:00 70:01 76:11 70:02!"
        " 71:00 70:01 76:22,33");
}

TEST_CASE_METHOD(Fixture, "an overdue transfer is ended, the bus recovered, and the safe write sent first") {
  const std::uint8_t neutral[3] = {0x06, 0x01, 0x02};
  bench::at(1 * kMillisecond, [&] { drive.set_safe(neutral, sizeof neutral); });
  bench::at(2 * kMillisecond, [&] {
    host::i2c2.hold_sda(7);
    a.start(one, 1);
    drive.start(two, 2);
  });
  std::optional<Time> recovered;
  bench::at(12 * kMillisecond, [&] {
    CHECK(a.state() == SlotState::kFailed);
    CHECK(drive.state() == SlotState::kFailed);  // its bytes are from before the trouble
    CHECK_FALSE(bus.ready());
    CHECK(b.start(one, 1));
    CHECK(b.state() == SlotState::kFailed);
  });
  for (Time t = 13 * kMillisecond; t < 60 * kMillisecond; t += kMillisecond) {
    bench::at(t, [&, t] {
      if (!bus.ready()) return;
      if (!recovered) recovered = t;
      b.start(one, 1);
    });
  }
  bench::run(60 * kMillisecond);
  REQUIRE(recovered);
  CHECK(*recovered <= 30 * kMillisecond);
  CHECK(host::i2c2.recovery_clocks == 9);
  CHECK(bus.counters().overdue == 1);
  CHECK(bus.counters().recoveries == 1);
  CHECK(drive.safe_writes() == 1);
  // The transfer under way was the drive's: aborted on its way to the mux. Then nothing but the safe write.
  const std::string first = "71:? 71:00 70:10 40:06,01,02 70:02 76:11";
  CHECK(wire_text().substr(0, first.size()) == first);
  CHECK(actuator.written == std::vector<Bytes>{{0x06, 0x01, 0x02}});
}

TEST_CASE_METHOD(Fixture,
                 "once the robot has stopped the safe writes go out again and again, and what was queued does not") {
  const std::uint8_t neutral[3] = {0x06, 0x01, 0x02};
  bench::at(1 * kMillisecond, [&] {
    drive.set_safe(neutral, sizeof neutral);
    direct.start(one, 1);
  });
  bench::at(1 * kMillisecond + 1, [&] {
    drive.start(two, 2);
    detail::set_stopped(true);
    bus.supervise();
  });
  bench::run(20 * kMillisecond);
  CHECK(direct.done());  // it was on the wire
  CHECK(drive.state() == SlotState::kFailed);
  REQUIRE(actuator.written.size() >= 3);
  for (const Bytes& bytes : actuator.written) CHECK(bytes == Bytes{0x06, 0x01, 0x02});
}

TEST_CASE_METHOD(Fixture, "a bus error leads to recovery too") {
  bench::at(1 * kMillisecond, [&] {
    host::i2c2.disturb(1);
    a.start(one, 1);
  });
  bench::run(40 * kMillisecond);
  CHECK(bus.ready());
  CHECK(bus.counters().recoveries == 1);
  CHECK(a.state() == SlotState::kFailed);
}

TEST_CASE_METHOD(Fixture, "lines that a part holds when the robot starts are freed before anything is asked for") {
  host::i2c2.hold_sda(7);
  bench::robot().start = [this] {
    bus.start();
    CHECK(bus.ready());
    a.start(one, 1);
  };
  bench::run(5 * kMillisecond);
  CHECK(a.done());
  CHECK(host::i2c2.recovery_clocks == 9);
  CHECK(bus.counters().recoveries == 1);
  CHECK(bus.counters().overdue == 0);
}

TEST_CASE_METHOD(Fixture, "a bus that stays stuck is tried again now and then, and everybody is unreachable") {
  bench::at(1 * kMillisecond, [&] { host::i2c2.hold_sda(-1); });
  bench::robot().slow = [&] {
    if (!a.busy()) a.start(one, 1);
  };
  bench::at(900 * kMillisecond, [&] {
    CHECK(a.unreachable());
    CHECK_FALSE(bus.ready());
    host::i2c2.release_sda();
  });
  bench::run(1500 * kMillisecond);
  CHECK(host::i2c2.recovery_clocks >= 2 * 9);
  CHECK(bus.ready());
  CHECK(a.done());
  CHECK_FALSE(a.unreachable());
}
