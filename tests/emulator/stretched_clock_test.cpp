// A part that holds the clock of an I2C bus, which the bounds assume that no part does: what takes time only, and what
// is counted.
#include "catch.hpp"
#include "tests/emulator/faults.hpp"
#include "tests/emulator/fixture.hpp"

using namespace finemote::emulator;
using finemote::test::faults_of;

namespace {

constexpr std::uint64_t kMs = 1'000'000;
constexpr unsigned kOverdue = 5 * 256 + 2;
constexpr std::uint32_t kClockControl = 0x4000581C;  // I2C2_CCR: RM0090 27.6.8

/// A pressure sensor behind which the clock runs slower while the first byte after its address is on the wire: to the
/// master that is as if the sensor held it in every bit. Registers of the master are what the emulated part has for it.
class Holding : public I2cPart {
 public:
  Holding(I2cPart& part, Board& board) : part_(part), board_(board) {}

  bool select(std::uint8_t address, bool read) override {
    const bool is_it = part_.select(address, read);
    if (is_it && clock_control != 0) {
      usual_ = board_.chip().read(kClockControl, 4);
      board_.chip().write(kClockControl, 4, clock_control);
      ++times;
    }
    return is_it;
  }
  bool write(WireByte byte) override {
    let_go();
    return part_.write(byte);
  }
  WireByte read() override {
    let_go();
    return part_.read();
  }
  void stop() override {
    let_go();
    part_.stop();
  }

  std::uint32_t clock_control = 0;  ///< of the byte that is held; 0: none is
  unsigned times = 0;               ///< that the clock was held

 private:
  void let_go() {
    if (usual_ != 0) board_.chip().write(kClockControl, 4, usual_);
    usual_ = 0;
  }
  I2cPart& part_;
  Board& board_;
  std::uint32_t usual_ = 0;
};

/// The robot of `waits`, whose jobs look at the bus every 20 ms.
struct Stretched {
  Stretched() {
    I2cLine& line = board.chip().i2c("i2c2")->line;
    line.attach(holding);
    line.attach(pwm);
    board.chip().i2c("i2c3")->line.attach(other);
    board.load(test_image("waits"));
    board.run_for(200 * kMs);
  }
  /// How much longer the bus is busy in 200 ms than it was in those before [ns].
  std::int64_t longer(std::uint32_t clock_control) {
    const std::int64_t begin = busy();
    board.run_for(200 * kMs);
    const std::int64_t usual = busy() - begin;
    holding.clock_control = clock_control;
    board.run_for(200 * kMs);
    return busy() - begin - 2 * usual;
  }

  Board board{finemote::test::type_c()};
  Pca9685 pwm{0x40};
  Ms5837 sensor{Ms5837::Variant::k30BA, [this] { return board.world().now(); }, [](Time) { return 101'325.0; }};
  Ms5837 other{Ms5837::Variant::k30BA, [this] { return board.world().now(); }, [](Time) { return 101'325.0; }};
  Holding holding{sensor, board};

 private:
  std::int64_t busy() { return static_cast<std::int64_t>(to_ns(board.chip().i2c("i2c2")->statistics().busy)); }
};

// Fast mode, its low part twice as long as its high one; then with nine and sixteen parts: RM0090 27.6.8.
constexpr std::uint32_t kTwice = 0x8000 | 70, kHundredTimes = 0x8000 | 4000, kThousandTimes = 0xC000 | 4000;

}  // namespace

TEST_CASE("clock-stretching: a byte that takes twice as long only takes time") {
  Stretched it;
  CHECK(it.longer(kTwice) > 100'000);
  CHECK(it.holding.times > 5);
  CHECK(faults_of(it.board).empty());
  CHECK(it.sensor.conversions() > 5);
}

TEST_CASE("clock-stretching: so does a transfer that is overdue, but over before the next look at the bus") {
  Stretched it;
  CHECK(it.longer(kHundredTimes) > 10'000'000);  // 2.6 ms each
  CHECK(it.holding.times > 5);
  CHECK(faults_of(it.board).empty());
}

TEST_CASE("clock-stretching: a transfer that the next look finds overdue is counted and ended") {
  Stretched it;
  it.longer(kThousandTimes);  // 21 ms each
  CHECK(it.holding.times > 0);
  CHECK(faults_of(it.board).count(kOverdue) == 1);
  it.holding.clock_control = 0;
  const unsigned conversions = it.sensor.conversions();
  it.board.run_for(500 * kMs);
  CHECK(it.sensor.conversions() > conversions);  // the bus works again
  CHECK(it.board.resets() == 0);
}
