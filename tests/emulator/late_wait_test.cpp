// Waits of interrupt routines for a chip that is late: whatever it does, a routine takes no longer than the analysis
// charges, and what is given up is counted.
#include <algorithm>

#include "catch.hpp"
#include "tests/cli/program.hpp"
#include "tests/emulator/faults.hpp"
#include "tests/emulator/fixture.hpp"

using namespace finemote::emulator;
using finemote::test::faults_of;

namespace {

using Json = nlohmann::json;

constexpr std::uint64_t kMs = 1'000'000;
constexpr unsigned kStopLate = 5 * 256 + 17, kBusy = 6 * 256 + 17;

/// What the analysis says of the robot that the image is made of.
const Json& analysed() {
  static const Json model = finemote::test::finemote_json(
      {"analyze", finemote::test::source_path("tests/emulator/images/waits/waits.urdf")})["model"];
  return model;
}

/// Of the longest routine of a bus, and the way into it and back as the emulated core makes it: what is charged for
/// that is more, and must not hide a routine that takes too long [ns].
double charge(const std::string& bus) {
  double most = 0;
  for (const Json& it : analysed()["buses"]) {
    if (it["name"] != bus) continue;
    for (const Json& source : it["sources"]) most = std::max(most, source["wcet_ns"].get<double>());
  }
  REQUIRE(most > 0);
  constexpr double kWayInAndOut = 200;
  return most + kWayInAndOut;
}

/// The robot with its parts.
struct WaitsBoard {
  explicit WaitsBoard(Strictness way, std::uint32_t late, const std::string& image = "waits")
      : board{finemote::test::type_c(), fixed(way, late)} {
    board.chip().i2c("i2c2")->line.attach(sensor);
    board.chip().i2c("i2c2")->line.attach(pwm);
    board.chip().i2c("i2c3")->line.attach(other);
    board.load(test_image(image));
  }

  static BoardOptions fixed(Strictness way, std::uint32_t late) {
    BoardOptions options;
    options.silicon.fix(way, late);
    return options;
  }

  /// Of all runs of these lines' routines [ns].
  double longest(std::initializer_list<unsigned> lines) {
    double most = 0;
    for (const auto& [exception, own] : board.own_times().exceptions()) {
      if (exception < 16 || std::find(lines.begin(), lines.end(), exception - 16) == lines.end()) continue;
      most = std::max(most, static_cast<double>(to_ns(own.longest)));
    }
    return most;
  }
  double longest_of_fast() { return longest({33, 34}); }  // I2C2_EV, I2C2_ER: RM0090, table 62
  double longest_of_slow() { return longest({72, 73}); }  // I2C3_EV, I2C3_ER
  double longest_of_spi() { return longest({56}); }       // DMA2_Stream0

  Board board;
  Pca9685 pwm{0x40};
  Ms5837 sensor{Ms5837::Variant::k30BA, [this] { return board.world().now(); }, [](Time) { return 101'325.0; }};
  Ms5837 other{Ms5837::Variant::k30BA, [this] { return board.world().now(); }, [](Time) { return 101'325.0; }};
};

/// Holds measured times against a charge, and remembers how near they came.
class Held {
 public:
  void add(double seen, double bound) {
    INFO(seen << " ns of " << bound << " ns");
    CHECK(seen > 0);
    CHECK(seen <= bound);
    nearest_ = std::max(nearest_, seen / bound);
  }
  [[nodiscard]] double nearest() const { return nearest_; }

 private:
  double nearest_ = 0;
};

}  // namespace

TEST_CASE("a STOP that is late by any amount costs no more than is charged, and is given up and counted beyond") {
  Held fast, slow;
  for (const std::uint32_t late : {0, 100, 300, 500, 700, 800, 900, 1'000, 1'200, 1'600, 2'000, 3'000, 5'000, 10'000,
                                   30'000, 100'000, 1'000'000}) {
    INFO("late by " << late << " ns");
    WaitsBoard it(Strictness::i2c_stop, late);
    it.board.run_for(300 * kMs);
    fast.add(it.longest_of_fast(), charge("fast"));
    slow.add(it.longest_of_slow(), charge("slow"));
    const bool is_counted = faults_of(it.board).count(kStopLate) != 0;
    if (late <= info_of(Strictness::i2c_stop).most) {
      CHECK(faults_of(it.board).empty());
      CHECK(it.sensor.conversions() > 3);
      CHECK(it.other.conversions() > 3);
    }
    if (late >= 2'000) CHECK(is_counted);
    CHECK(it.board.resets() == 0);
  }
  CHECK(fast.nearest() > 0.6);
  CHECK(slow.nearest() > 0.9);
}

TEST_CASE("an end of the clock that is late by any amount costs no more than is charged") {
  Held held;
  for (const std::uint32_t half_bits : {0, 1, 2, 3, 4, 5, 6, 8, 12, 20, 100, 1'000}) {
    INFO("late by " << half_bits << " half bits");
    WaitsBoard it(Strictness::spi_busy, half_bits);
    it.board.run_for(200 * kMs);
    held.add(it.longest_of_spi(), charge("serial"));
    if (half_bits <= info_of(Strictness::spi_busy).most) CHECK(faults_of(it.board).empty());
    if (half_bits >= 8) CHECK(faults_of(it.board).count(kBusy) == 1);
  }
  CHECK(held.nearest() > 0.4);
}

TEST_CASE("a driver that waits for longer than it is charged for shows") {
  WaitsBoard stop(Strictness::i2c_stop, 30'000, "mutant_stop_limit");
  stop.board.run_for(300 * kMs);
  CHECK(stop.longest_of_fast() > charge("fast"));
  CHECK(stop.longest_of_slow() > charge("slow"));
  WaitsBoard busy(Strictness::spi_busy, 100, "mutant_busy_limit");
  busy.board.run_for(200 * kMs);
  CHECK(busy.longest_of_spi() > charge("serial"));
}

TEST_CASE("a wait ends also where the cycle counter stands still") {
  constexpr std::uint32_t kCycleCounterControl = 0xE0001000;
  constexpr int kSysTick = 15;
  WaitsBoard it(Strictness::i2c_stop, 1'000'000'000);
  it.board.run_for(100 * kMs);
  it.board.world().system().write(kCycleCounterControl, 4, 0, 0, 0);
  const auto entered = [&] { return it.board.world().system().nvic().times_entered(kSysTick); };
  const auto before = entered();
  it.board.run_for(100 * kMs);
  CHECK(entered() > before + 3);
}
