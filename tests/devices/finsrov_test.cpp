// The whole vehicle on the host board: real bytes on both buses, faults, and what the thrusters' pins show.
#include "finemote/devices/finsrov.hpp"

#include <memory>

#include "catch.hpp"
#include "finemote/bench/bench.hpp"
#include "finemote/devices/h30_imu.hpp"
#include "finemote/devices/ms5837.hpp"
#include "finemote/devices/pwm_esc.hpp"
#include "finemote/latch.hpp"
#include "finemote/pca9685.hpp"
#include "runtime/boards/host/ports/h30_part.hpp"
#include "runtime/boards/host/ports/i2c_parts.hpp"

namespace {

using namespace finemote;

// Thrusters 0..3 push along x, y and turn, 4..7 along z, roll and pitch; arms of 0.2 m.
constexpr float kAllocation[8][6] = {
    {0.25F, 0.25F, 0, 0, 0, 1}, {0.25F, -0.25F, 0, 0, 0, -1}, {0.25F, 0.25F, 0, 0, 0, -1}, {0.25F, -0.25F, 0, 0, 0, 1},
    {0, 0, 0.25F, 1, -1, 0},    {0, 0, 0.25F, -1, -1, 0},     {0, 0, 0.25F, 1, 1, 0},      {0, 0, 0.25F, -1, 1, 0}};

constexpr double kSurface = 101325, kPerMetre = 1000 * 9.80665;

/// What the generator writes for FinsROV, as members, so that every test begins anew.
struct Firmware {
  std::uint8_t imu_ring[256], host_ring[256];
  Uart imu_uart{ports::usart1, 921600, imu_ring};
  Uart host_uart{ports::usart6, 115200, host_ring, UartFormat::k8E1};
  I2cSlot baro_slots[4] = {{i2c, 0x76, {0x70, 0x01}, 2},
                           {i2c, 0x76, {0x70, 0x02}, 2},
                           {i2c, 0x76, {0x70, 0x04}, 2},
                           {i2c, 0x76, {0x70, 0x08}, 2}};
  I2cSlot pwm_slot{i2c, 0x40, {0x70, 0x10}, 1};
  I2cSlot* const slots[5] = {&pwm_slot, &baro_slots[0], &baro_slots[1], &baro_slots[2], &baro_slots[3]};
  I2cBus i2c{ports::i2c2, 400000, slots};
  Pca9685 pwm{pwm_slot};

  H30Imu imu{nullptr, imu_uart};
  Ms5837 baro[4] = {{{}, baro_slots[0]}, {{}, baro_slots[1]}, {{}, baro_slots[2]}, {{}, baro_slots[3]}};
  PwmEsc thrusters[8] = {{{}, {pwm, 0}}, {{}, {pwm, 1}}, {{}, {pwm, 2}}, {{}, {pwm, 3}},
                         {{}, {pwm, 4}}, {{}, {pwm, 5}}, {{}, {pwm, 6}}, {{}, {pwm, 7}}};
  LatchToSlow<ImuState> imu_latch;
  ImuState imu_to_rov;
  Port<Pressure> depth[4] = {{baro[0].state}, {baro[1].state}, {baro[2].state}, {baro[3].state}};
  Port<Thruster> drives[8] = {{thrusters[0].state, thrusters[0].command}, {thrusters[1].state, thrusters[1].command},
                              {thrusters[2].state, thrusters[2].command}, {thrusters[3].state, thrusters[3].command},
                              {thrusters[4].state, thrusters[4].command}, {thrusters[5].state, thrusters[5].command},
                              {thrusters[6].state, thrusters[6].command}, {thrusters[7].state, thrusters[7].command}};
  FinsRov rov{{}, kAllocation, &host_uart, {imu_to_rov}, depth, drives};

  void start() {
    imu_uart.start();
    host_uart.start();
    i2c.start();
  }
  void run_5ms() {
    i2c.supervise();
    imu.update();
    imu_latch.publish(imu.state);
    imu.handle();
  }
  void run_10ms() {
    for (Ms5837& b : baro) b.update();
    for (PwmEsc& t : thrusters) t.update();
    imu_to_rov = imu_latch.snapshot();
    rov.update();
    rov.handle();
    for (unsigned n = 8; n-- > 0;) thrusters[n].handle();
    pwm.flush();
  }
  void safe() {
    for (PwmEsc& t : thrusters) t.safe();
    pwm.flush();
  }
};

struct Fixture {
  Fixture() {
    bench::reset();
    host::i2c2.connect(0x70, mux);
    for (unsigned n = 0; n < 4; ++n) {
      mux.connect(n, 0x76, baro[n]);
      baro[n].set(kSurface + 0.3 * kPerMetre, 15);
    }
    mux.connect(4, 0x40, pca);
    bench::robot() = {[this] { robot->start(); }, [this] { robot->safe(); }, [this] { robot->run_5ms(); },
                      [this] { robot->run_10ms(); }};
    // Bytes are fed once the line has been started: by the first release it has.
    bench::at(0, [this] { sensor = std::make_unique<host::H30Part>(host::usart1, now(), 5 * kMillisecond); });
  }
  void send(Time at, const std::string& text) {
    bench::at(at, [text] { host::usart6.feed(now(), text); });
  }
  [[nodiscard]] bool neutral() const {
    for (unsigned n = 0; n < 8; ++n) {
      if (pca.pulse(n) != kNeutral) return false;
    }
    return true;
  }
  static constexpr std::uint32_t kNeutral = 307 * 4880;

  host::Tca9548aPart mux;
  host::Ms5837Part baro[4];
  host::Pca9685Part pca;
  std::unique_ptr<host::H30Part> sensor;
  std::unique_ptr<Firmware> robot = std::make_unique<Firmware>();
};

}  // namespace

TEST_CASE_METHOD(Fixture, "nothing moves until the host says ON; then depth is held") {
  bench::at(900 * kMillisecond, [&] { CHECK(neutral()); });
  send(1 * kSecond, "ON");
  bench::at(1200 * kMillisecond, [&] {
    CHECK(robot->rov.holding());
    CHECK(robot->rov.depth() == Approx(0.3).margin(0.002));
    CHECK(robot->rov.target_depth() == Approx(0.3));
  });
  send(1300 * kMillisecond, "H:500");
  bench::at(1400 * kMillisecond, [&] {
    // 0.2 m too high: 2 efforts down, shared by four thrusters, whose axes point up.
    for (unsigned n = 4; n < 8; ++n) CHECK(pca.pulse(n) == Approx(1300000).margin(5000));
    for (unsigned n = 0; n < 4; ++n) CHECK(pca.pulse(n) == kNeutral);
  });
  send(1500 * kMillisecond, "OFF");
  bench::run(1600 * kMillisecond);
  CHECK(neutral());
}

TEST_CASE_METHOD(Fixture, "attitude errors are turned against") {
  send(500 * kMillisecond, "ON");
  bench::at(600 * kMillisecond, [&] { sensor->state.roll = 0.1F; });
  bench::at(700 * kMillisecond, [&] {
    // 4 /s * 0.1 rad * 0.15 = 0.06 efforts of moment about -x, arms of 1 in the allocation.
    CHECK(pca.pulse(4) == Approx(1500000 - 0.06 * 400000).margin(10000));
    CHECK(pca.pulse(5) == Approx(1500000 + 0.06 * 400000).margin(10000));
    CHECK(pca.pulse(4) < kNeutral);
    CHECK(pca.pulse(5) > kNeutral);
    sensor->state.roll = 0;
    sensor->state.rate[2] = 0.5F;
  });
  bench::run(800 * kMillisecond);
  CHECK(pca.pulse(0) < kNeutral);  // turns left: push right
  CHECK(pca.pulse(1) > kNeutral);
}

TEST_CASE_METHOD(Fixture, "motion orders move, and end when the host falls silent") {
  send(500 * kMillisecond, "ON");
  send(600 * kMillisecond, "W");
  bench::at(800 * kMillisecond, [&] {
    for (unsigned n = 0; n < 4; ++n) CHECK(pca.pulse(n) == Approx(1500000 + 0.57 / 4 * 400000).margin(5000));
  });
  bench::at(1500 * kMillisecond, [&] { CHECK(pca.pulse(0) > kNeutral); });
  bench::run(1800 * kMillisecond);
  for (unsigned n = 0; n < 4; ++n) CHECK(pca.pulse(n) == kNeutral);
  CHECK(robot->rov.holding());
}

TEST_CASE_METHOD(Fixture, "test pulses only while off") {
  send(500 * kMillisecond, "TES:1600,1400,1500,1500,1900,1100,1500,2500");
  bench::at(700 * kMillisecond, [&] {
    CHECK(pca.pulse(0) == Approx(1600000).margin(2500));
    CHECK(pca.pulse(1) == Approx(1400000).margin(2500));
    CHECK(pca.pulse(4) == Approx(1900000).margin(2500));
    CHECK(pca.pulse(7) == Approx(1900000).margin(2500));
  });
  bench::at(1700 * kMillisecond, [&] { CHECK(neutral()); });
  send(1800 * kMillisecond, "ON");
  send(1900 * kMillisecond, "TES:1600,1600,1600,1600,1600,1600,1600,1600");
  bench::run(2 * kSecond);
  CHECK(robot->rov.holding());
  CHECK(pca.pulse(0) == kNeutral);
}

TEST_CASE_METHOD(Fixture, "CA takes the surface, VA and RPY report") {
  send(500 * kMillisecond, "CA");
  send(600 * kMillisecond, "VA");
  send(700 * kMillisecond, "RPY:ON");
  bench::at(650 * kMillisecond, [&] {
    CHECK(robot->rov.depth() == Approx(0).margin(0.002));
    sensor->state.yaw = -0.5F;
  });
  bench::run(1 * kSecond);
  REQUIRE(host::usart6.sent.size() >= 3);
  const auto text = [](const host::Sent& sent) { return std::string(sent.bytes.begin(), sent.bytes.end()); };
  CHECK(text(host::usart6.sent[0]).substr(0, 6) == "VA:104");
  CHECK(text(host::usart6.sent[2]).substr(0, 19) == "RPY:0.00,0.00,-28.6");
  CHECK(host::usart6.sent[2].begin - host::usart6.sent[1].begin == 100 * kMillisecond);
}

TEST_CASE_METHOD(Fixture, "a silent attitude sensor stops the thrusters by the age of its data") {
  send(500 * kMillisecond, "ONH:900");
  Time silent = 0, stopped = 0;
  bench::at(1001 * kMillisecond, [&] {
    CHECK(pca.pulse(4) < 1400000);
    sensor->silent = true;
    silent = now();
  });
  for (int i = 0; i < 400; ++i) {
    bench::at(1002 * kMillisecond + i * kMillisecond, [&] {
      if (stopped == 0 && neutral()) stopped = now();
    });
  }
  bench::at(30 * kSecond, [&] { CHECK(neutral()); });
  bench::at(60 * kSecond, [&] {
    CHECK(neutral());
    CHECK_FALSE(robot->imu.state.valid);
    sensor->silent = false;
  });
  bench::run(61 * kSecond);
  CHECK(stopped > silent + 50 * kMillisecond);
  CHECK(stopped <= silent + 125 * kMillisecond);  // max_age, one period, the burst
  CHECK_FALSE(neutral());
}

TEST_CASE_METHOD(Fixture, "an attitude that comes back is held as it is: its yaw may count from elsewhere") {
  send(500 * kMillisecond, "ONH:900");
  send(600 * kMillisecond, "ACL:ON");
  bench::at(1 * kSecond, [&] { sensor->silent = true; });
  bench::at(2 * kSecond, [&] {
    sensor->state.yaw += 2;
    sensor->silent = false;
  });
  std::uint32_t before = 0;
  bench::at(990 * kMillisecond, [&] { before = pca.pulse(0); });
  bench::at(2500 * kMillisecond, [&] {
    CHECK(robot->imu.state.valid);
    CHECK(static_cast<double>(pca.pulse(0)) == Approx(before).margin(20000));
  });
  bench::run(3 * kSecond);
}

TEST_CASE_METHOD(Fixture,
                 "a depth that comes back is turned against as it is, not by errors that were summed meanwhile") {
  send(500 * kMillisecond, "ONH:450");  // 0.15 m too high
  std::uint32_t before = 0;
  bench::at(990 * kMillisecond, [&] { before = pca.pulse(4); });
  bench::at(1 * kSecond, [&] { baro[2].silent = true; });
  bench::at(3900 * kMillisecond, [&] { CHECK(neutral()); });
  bench::at(4 * kSecond, [&] { baro[2].silent = false; });
  bench::at(4400 * kMillisecond, [&] {
    CHECK(before != kNeutral);
    CHECK(static_cast<double>(pca.pulse(4)) == Approx(before).margin(20000));
  });
  bench::run(4500 * kMillisecond);
}

TEST_CASE_METHOD(Fixture, "one pressure sensor that falls silent, NACKs or disturbs stops them too") {
  send(500 * kMillisecond, "ONH:900");
  const int fault = GENERATE(0, 1, 2);
  Time stopped = 0;
  bench::at(1 * kSecond, [&] {
    CHECK_FALSE(neutral());
    if (fault == 0) baro[2].silent = true;
    if (fault == 1) baro[2].noise = 0xC00000;
    if (fault == 2) mux.silent = true;
  });
  for (int i = 0; i < 400; ++i) {
    bench::at(1001 * kMillisecond + i * kMillisecond, [&] {
      if (stopped == 0 && neutral()) stopped = now();
    });
  }
  bench::at(1500 * kMillisecond, [&] {
    bool stale = false;
    for (const Ms5837& b : robot->baro) stale = stale || !b.state.valid;
    CHECK(stale);
    for (host::Ms5837Part& b : baro) b.silent = b.noise = 0;
    mux.silent = false;
  });
  bench::run(3 * kSecond);
  if (fault != 2) {  // behind a dead mux nothing reaches the thrusters' part: they are reported instead
    CHECK(stopped != 0);
    CHECK(stopped <= 1 * kSecond + 160 * kMillisecond);
  }
  CHECK_FALSE(neutral());  // all is well again
}

TEST_CASE_METHOD(Fixture, "thrusters behind a bus that fails are reported unreachable") {
  bench::at(1 * kSecond, [&] {
    CHECK(robot->thrusters[0].state.valid);
    pca.silent = true;
  });
  bench::run(1200 * kMillisecond);
  CHECK(robot->thrusters[0].state.unreachable);
  CHECK_FALSE(robot->thrusters[0].state.valid);
  CHECK(robot->baro[0].state.valid);  // the others go on
}

TEST_CASE_METHOD(Fixture, "a stuck bus is recovered in bounded time with neutral as the first transfer") {
  send(500 * kMillisecond, "ONH:900");
  const int when = GENERATE(0, 1, 2, 3, 4, 5, 6, 7, 8, 9);  // whatever is on the wire
  const Time stuck = 1 * kSecond + when * 370 * kMicrosecond;
  std::size_t exchanges = 0;
  bench::at(stuck, [&] {
    CHECK_FALSE(neutral());
    host::i2c2.hold_sda(9);
  });
  bench::at(stuck + 20 * kMicrosecond, [&] { exchanges = host::i2c2.exchanges.size(); });
  bench::run(2 * kSecond);
  // The aborted one, the mux, then the safe write.
  auto next = host::i2c2.exchanges.begin() + static_cast<std::ptrdiff_t>(exchanges);
  REQUIRE(next->event == I2cEvent::kNone);
  ++next;
  CHECK(next->address == 0x70);
  CHECK(next->written == std::vector<std::uint8_t>{0x10});
  ++next;
  CHECK(next->address == 0x40);
  REQUIRE(next->written.size() == 33);
  CHECK(next->written[0] == 0x06);
  for (unsigned n = 0; n < 8; ++n) {
    CHECK(next->written[1 + 4 * n + 2] == 0x33);
    CHECK(next->written[1 + 4 * n + 3] == 0x01);
  }
  CHECK(next->end - stuck <= 45 * kMillisecond);
  CHECK(robot->i2c.counters().recoveries == 1);
  CHECK_FALSE(neutral());  // and on it goes
}

TEST_CASE_METHOD(Fixture, "after a reset of the board neutral is the first thing the thrusters' part hears") {
  // The part goes on with full thrust while the processor restarts.
  pca.write({0x00, 0x20});
  pca.write({0x06, 0, 0, 0x85, 0x01});
  bench::run(100 * kMillisecond);
  REQUIRE(host::i2c2.exchanges.size() > 2);
  CHECK(host::i2c2.exchanges[0].address == 0x70);
  CHECK(host::i2c2.exchanges[1].address == 0x40);
  CHECK(host::i2c2.exchanges[1].written.size() == 33);
  CHECK(host::i2c2.exchanges[1].end < 2 * kMillisecond);
}
