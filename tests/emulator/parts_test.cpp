// The models of the parts, against figures from their data sheets.
#include "catch.hpp"
#include "emulator/parts/h30.hpp"
#include "emulator/parts/ms5837.hpp"
#include "emulator/parts/pca9685.hpp"
#include "emulator/parts/tca9548a.hpp"

using namespace finemote::emulator;

namespace {

void send(I2cLine& line, std::uint8_t address, std::initializer_list<int> bytes) {
  REQUIRE(line.select(address, false));
  for (const int byte : bytes) REQUIRE(line.write(static_cast<std::uint8_t>(byte)));
  line.stop();
}

std::uint32_t receive(I2cLine& line, std::uint8_t address, unsigned bytes) {
  REQUIRE(line.select(address, true));
  std::uint32_t value = 0;
  for (unsigned i = 0; i < bytes; ++i) value = value << 8 | line.read();
  line.stop();
  return value;
}

}  // namespace

TEST_CASE("the pressure sensor gives the data sheet's values after the conversion time, and 0 before") {
  Time now = from_ns(100'000'000);
  double pascal = 399'980;  // MS5837-30BA data sheet: D1 = 4958179 at 3999.8 mbar
  Ms5837 sensor(
      Ms5837::Variant::k30BA, [&] { return now; }, [&](Time) { return pascal; });
  I2cLine line;
  line.attach(sensor);
  send(line, 0x76, {0xA2});
  CHECK(receive(line, 0x76, 2) == 34982);
  send(line, 0x76, {0x50});
  now += from_ns(600'000);
  send(line, 0x76, {0x00});
  CHECK(receive(line, 0x76, 3) == 26646U * 256);
  send(line, 0x76, {0x48});
  now += from_ns(9'039'000);
  send(line, 0x76, {0x00});
  CHECK(receive(line, 0x76, 3) == 0);
  CHECK(sensor.early_reads() == 1);
  send(line, 0x76, {0x48});
  now += from_ns(9'040'000);
  send(line, 0x76, {0x00});
  CHECK(receive(line, 0x76, 3) == Approx(4958179).epsilon(2e-3));  // there at 19.82 degrees, here at 20.00
}

TEST_CASE("the mux connects at the STOP, and only what its mask says") {
  I2cLine line;
  Tca9548a mux(0x70);
  Pca9685 left(0x40), right(0x40);
  line.attach(mux);
  mux.channel(1).attach(left);
  mux.channel(4).attach(right);
  CHECK(!line.select(0x40, false));
  send(line, 0x70, {0x10});
  send(line, 0x40, {0x00, 0x20});
  CHECK(receive(line, 0x70, 1) == 0x10);
  CHECK(right.period_ns() == left.period_ns());
  REQUIRE(line.select(0x40, false));
  line.write(0x00);
  line.stop();
  CHECK(receive(line, 0x40, 1) == 0x20);
  send(line, 0x70, {0x02});
  REQUIRE(line.select(0x40, false));
  line.write(0x00);
  line.stop();
  CHECK(receive(line, 0x40, 1) == 0x11);  // the other one, as reset left it
}

TEST_CASE("the PWM part takes its prescaler in sleep only, and its outputs at the STOP") {
  I2cLine line;
  Pca9685 pwm(0x40);
  line.attach(pwm);
  std::vector<std::pair<unsigned, std::uint64_t>> changes;
  pwm.on_pulse = [&](unsigned channel, std::uint64_t ns) { changes.emplace_back(channel, ns); };
  send(line, 0x40, {0xFE, 121});
  CHECK(pwm.period_ns() == 4096ULL * 122 * 40);
  send(line, 0x40, {0x00, 0x20});
  send(line, 0x40, {0xFE, 50});
  CHECK(pwm.period_ns() == 4096ULL * 122 * 40);  // awake: ignored
  REQUIRE(line.select(0x40, false));
  for (const int byte : {0x06, 0, 0, 0x33, 0x01, 0, 0, 0x66, 0x02}) line.write(static_cast<std::uint8_t>(byte));
  CHECK(changes.empty());
  line.stop();
  REQUIRE(changes.size() == 2);
  CHECK(changes[0] == std::pair(0U, std::uint64_t{0x133 * 122 * 40}));
  CHECK(changes[1] == std::pair(1U, std::uint64_t{0x266 * 122 * 40}));
}

TEST_CASE("a frame of the inertial unit has its length and sums") {
  const auto frame = h30_frame(0x0102, Attitude{});
  REQUIRE(frame.size() == 67);
  CHECK(frame[0] == 0x59);
  CHECK(frame[1] == 0x53);
  CHECK(frame[4] == 0x3C);
  unsigned one = 0, two = 0;
  for (std::size_t i = 2; i < 65; ++i) {
    one = (one + frame[i]) & 0xFF;
    two = (two + one) & 0xFF;
  }
  CHECK(frame[65] == one);
  CHECK(frame[66] == two);
}
