// IST8310: set-up, values, a part that is not there or was reset.
#include "finemote/devices/ist8310.hpp"

#include "catch.hpp"
#include "finemote/bench/bench.hpp"

namespace {

using namespace finemote;
using Bytes = std::vector<std::uint8_t>;

struct Part : host::I2cPart {
  Part() { registers[0] = 0x10; }
  bool write(const Bytes& bytes) override {
    if (silent) return false;
    pointer = bytes.at(0);
    for (std::size_t i = 1; i < bytes.size(); ++i) registers[pointer + i - 1] = bytes[i];
    if (bytes.size() > 1) written.push_back(bytes);
    return true;
  }
  bool read(std::size_t size, Bytes& bytes) override {
    if (pointer == 3) ++reads;
    for (std::size_t i = 0; i < size; ++i) bytes.push_back(measured(i) ? registers[pointer + i] : 0);
    return !silent;
  }
  /// Before its first measurement the part gives zeros, which may end after two bytes of a read.
  bool measured(std::size_t byte) const {
    return pointer != 3 || reads > measures_in_read || (reads == measures_in_read && byte >= 2);
  }
  std::array<std::uint8_t, 256> registers{};
  std::uint8_t pointer = 0;
  std::vector<Bytes> written;
  bool silent = false;
  unsigned reads = 0;             ///< of the field so far
  unsigned measures_in_read = 0;  ///< in which the first measurement comes
};

struct Fixture {
  Fixture() {
    bench::reset();
    host::i2c3.connect(0x0E, part);
    const std::uint8_t field[6] = {0x64, 0x00, 0x9C, 0xFF, 0x00, 0x01};  // 100, -100, 256
    std::copy(field, field + 6, part.registers.begin() + 3);
    bench::robot().start = [this] { bus.start(); };
    bench::robot().fast = [this] {
      bus.supervise();
      compass.update();
    };
  }
  Part part;
  I2cSlot slot{bus, 0x0E, {}, 1};
  I2cSlot* const table[1] = {&slot};
  I2cBus bus{ports::i2c3, 400000, table};
  Ist8310 compass{nullptr, slot};
};

}  // namespace

TEST_CASE_METHOD(Fixture, "IST8310: identity, settings, then the field") {
  bench::run(100 * kMillisecond);
  CHECK(part.written == std::vector<Bytes>{{0x0B, 0x08}, {0x41, 0x09}, {0x42, 0xC0}, {0x0A, 0x0B}});
  CHECK(compass.state.valid);
  CHECK(compass.state.field[0] == Approx(30e-6));
  CHECK(compass.state.field[1] == Approx(30e-6));  // the part counts to the right
  CHECK(compass.state.field[2] == Approx(76.8e-6));
  CHECK(now() - compass.state.origin == (10 + 6) * kMillisecond);  // asked for, and how old it was then
}

TEST_CASE_METHOD(Fixture, "IST8310: silence is invalid; a reset part is set up again; another part is not taken") {
  bench::at(101 * kMillisecond, [&] { part.silent = true; });
  bench::at(121 * kMillisecond, [&] {
    CHECK_FALSE(compass.state.valid);
    part.silent = false;
    part.written.clear();
    for (int i = 3; i < 9; ++i) part.registers[i] = 0;
  });
  bench::at(200 * kMillisecond, [&] {
    CHECK_FALSE(compass.state.valid);
    CHECK(part.written.size() >= 4);
    part.registers[3] = 1;
  });
  bench::at(300 * kMillisecond, [&] {
    CHECK(compass.state.valid);
    part.registers[0] = 0x33;
    part.silent = true;
  });
  bench::at(400 * kMillisecond, [&] { part.silent = false; });
  bench::run(600 * kMillisecond);
  CHECK_FALSE(compass.state.valid);
}

TEST_CASE_METHOD(Fixture, "IST8310: a read in which the part stores its first measurement is left out") {
  part.measures_in_read = 1;
  bool torn = false;
  for (int ms = 1; ms < 200; ++ms) {
    bench::at(ms * kMillisecond, [&] { torn = torn || (compass.state.valid && compass.state.field[0] == 0.0F); });
  }
  // It is reset: two reads of zeros, then one of both.
  bench::at(101 * kMillisecond, [&] { part.measures_in_read = part.reads + 3; });
  bench::at(119 * kMillisecond, [&] { CHECK_FALSE(compass.state.valid); });
  bench::run(200 * kMillisecond);
  CHECK_FALSE(torn);
  CHECK(compass.state.valid);
}

TEST_CASE_METHOD(Fixture, "IST8310: x and y reach to 1600 uT, z to 2500 uT") {
  const int axis = GENERATE(0, 1, 2);
  const auto hold = [&](int counts) {
    part.registers[3 + 2 * axis] = static_cast<std::uint8_t>(counts & 0xFF);
    part.registers[4 + 2 * axis] = static_cast<std::uint8_t>(counts >> 8);
  };
  hold(axis == 2 ? 8333 : 5333);
  bench::at(101 * kMillisecond, [&] {
    CHECK(compass.state.valid);
    hold(axis == 2 ? 8500 : 5500);
  });
  bench::run(120 * kMillisecond);
  CHECK_FALSE(compass.state.valid);
}
