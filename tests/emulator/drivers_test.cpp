// The board's drivers against models of the parts: what arrives, and what happens when a part or a wire fails.
#include "catch.hpp"
#include "tests/emulator/fixture.hpp"

using namespace finemote::emulator;

namespace {

constexpr std::uint64_t kMs = 1'000'000;
enum Observed : unsigned { kImuValid, kRoll, kPressureValid, kPascal, kImuFrames, kImuBad, kRecoveries, kI2cErrors };

}  // namespace

TEST_CASE("sensors arrive, outputs leave, and nothing is used wrongly") {
  MiniBoard mini;
  finemote::test::run_to_first_release(mini.board);
  const unsigned unheard = mini.imu.frames();
  mini.board.run_for(500 * kMs);
  CHECK(mini.observed(kImuValid) == 1);
  CHECK(static_cast<int>(mini.observed(kRoll)) == Approx(-12.25e6 * 3.14159265 / 180).epsilon(1e-5));
  CHECK(mini.observed(kPressureValid) == 1);
  CHECK(mini.observed(kPascal) == Approx(250'000).margin(10));
  CHECK(mini.imu.frames() - unheard - mini.observed(kImuFrames) <= 2);
  CHECK(mini.observed(kImuBad) == 0);
  CHECK(mini.sensor.early_reads() == 0);
  CHECK(mini.pwm.pulse_ns(3) == Approx(1'600'000).margin(3'000));
  const auto [timer, channel] = mini.board.chip().pwm("pwm1");
  CHECK(timer->pulse(channel).width_ns == Approx(1'700'000).margin(500));
  CHECK(timer->pulse(channel).period_ns == Approx(20'000'000).margin(500));
  CHECK(mini.board.resets() == 0);
  for (const Report& report : mini.board.reports()) {
    INFO(name_of(report.misuse) << ": " << report.text);
    CHECK(false);
  }
}

TEST_CASE("bytes take their time on the wire") {
  MiniBoard mini;
  mini.board.run_for(100 * kMs);
  const std::size_t noise = mini.host.heard().size();
  mini.host.send("0123456789");
  mini.board.run_for(100 * kMs);
  REQUIRE(mini.host.text().substr(noise) == "0123456789");
  // 8E1 at 115200: eleven bits, 95.5 us a byte; BRR 729 makes 115226. A job may come between two of them.
  unsigned together = 0;
  for (std::size_t i = noise + 1; i < noise + 10; ++i) {
    const auto apart = static_cast<double>(to_ns(mini.host.heard()[i].at - mini.host.heard()[i - 1].at));
    if (apart < 1'000'000) CHECK(apart == Approx(11e9 / 115226).margin(20));
    together += apart < 1'000'000 ? 1 : 0;
  }
  CHECK(together >= 8);
}

TEST_CASE("a silent unit makes its state invalid and the output neutral") {
  MiniBoard mini;
  mini.board.run_for(300 * kMs);
  REQUIRE(mini.pwm.pulse_ns(3) > 1'590'000);
  mini.imu.silent = true;
  mini.board.run_for(100 * kMs);
  CHECK(mini.observed(kImuValid) == 0);
  CHECK(mini.pwm.pulse_ns(3) == Approx(1'500'000).margin(3'000));
  mini.imu.silent = false;
  mini.board.run_for(50 * kMs);
  CHECK(mini.observed(kImuValid) == 1);
}

TEST_CASE("damaged and noisy frames are dropped and counted, the next good one counts") {
  MiniBoard mini;
  mini.board.run_for(100 * kMs);
  mini.imu.damaged_frames = 1;
  mini.board.run_for(20 * kMs);
  CHECK(mini.observed(kImuBad) == 1);
  const auto errors = mini.board.bus("usart1").errors;
  mini.board.chip().usart("usart1")->noisy_bytes = 5;
  mini.board.run_for(30 * kMs);
  CHECK(mini.board.bus("usart1").errors == errors + 5);
  CHECK(mini.observed(kImuValid) == 1);
}

TEST_CASE("a part that does not acknowledge costs its own transfer only") {
  MiniBoard mini;
  mini.board.run_for(300 * kMs);
  const auto before = mini.observed(kI2cErrors);
  mini.board.chip().i2c("i2c2")->line.nack(0x76, 3);
  mini.board.run_for(200 * kMs);
  CHECK(mini.observed(kI2cErrors) == before + 3);
  CHECK(mini.observed(kRecoveries) == 0);
  CHECK(mini.observed(kPressureValid) == 1);
}

TEST_CASE("a held data line is clocked free within nine pulses, and the bus works again") {
  for (const unsigned clocks : {1U, 5U, 9U}) {
    MiniBoard mini;
    mini.board.run_for(300 * kMs);
    I2cLine& line = mini.board.chip().i2c("i2c2")->line;
    line.hold_sda(clocks);
    mini.board.run_for(200 * kMs);
    INFO(clocks << " clocks");
    CHECK(!line.sda_held());
    CHECK(line.clocks_by_hand() <= 10);  // nine pulses and the rise before the STOP
    CHECK(mini.observed(kRecoveries) == 1);
    CHECK(mini.observed(kPressureValid) == 1);
    const unsigned conversions = mini.sensor.conversions();
    mini.board.run_for(100 * kMs);
    CHECK(mini.sensor.conversions() > conversions);
  }
}

TEST_CASE("a line held for ever stops nothing but its own bus") {
  MiniBoard mini;
  mini.board.run_for(300 * kMs);
  I2cLine& line = mini.board.chip().i2c("i2c2")->line;
  line.hold_sda(I2cLine::kForever);
  const unsigned frames = mini.observed(kImuFrames);
  mini.board.run_for(1000 * kMs);
  CHECK(mini.observed(kPressureValid) == 0);
  CHECK(mini.observed(kImuFrames) >= frames + 199);  // every 5 ms job ran
  CHECK(mini.board.resets() == 0);
  line.hold_sda(0);
  mini.board.run_for(300 * kMs);
  CHECK(mini.observed(kPressureValid) == 1);
}

TEST_CASE("a spurious bus error in master mode does not end the exchange (ES0182)") {
  MiniBoard mini;
  mini.board.run_for(300 * kMs);
  const auto before = mini.observed(kI2cErrors);
  mini.board.chip().i2c("i2c2")->disturbed_starts = 3;
  mini.board.run_for(200 * kMs);
  CHECK(mini.board.chip().i2c("i2c2")->disturbed_starts == 0);
  CHECK(mini.observed(kI2cErrors) == before);
  CHECK(mini.observed(kPressureValid) == 1);
}

TEST_CASE("a mux that lost its setting is set again after the failure it causes") {
  MiniBoard mini;
  mini.board.run_for(300 * kMs);
  mini.mux.power_cycle();
  mini.board.run_for(300 * kMs);
  CHECK(mini.observed(kPressureValid) == 1);
  CHECK(mini.pwm.pulse_ns(3) == Approx(1'600'000).margin(3'000));
}

TEST_CASE("a bus lost to another master costs one transfer, and the next one has it again") {
  MiniBoard mini;
  mini.board.run_for(300 * kMs);
  const auto before = mini.observed(kI2cErrors);
  mini.board.chip().i2c("i2c2")->lost_starts = 2;
  mini.board.run_for(200 * kMs);
  CHECK(mini.board.chip().i2c("i2c2")->lost_starts == 0);
  CHECK(mini.observed(kI2cErrors) >= before + 2);
  CHECK(mini.observed(kPressureValid) == 1);
  CHECK(mini.pwm.pulse_ns(3) == Approx(1'600'000).margin(3'000));
}

TEST_CASE("a receiving DMA stream that meets a bus error is started again by the next job") {
  MiniBoard mini;
  mini.board.run_for(300 * kMs);
  REQUIRE(mini.board.chip().break_dma("usart1", DmaWay::receive));
  const unsigned frames = mini.observed(kImuFrames);
  mini.board.run_for(100 * kMs);
  CHECK(mini.observed(kImuFrames) >= frames + 17);  // of 20: two at most are lost with what lay in the ring
  CHECK(mini.observed(kImuValid) == 1);
}

TEST_CASE("a block whose stream dies is given up, and the next one leaves") {
  MiniBoard mini;
  mini.board.run_for(300 * kMs);
  mini.host.send("0123456789");
  const std::size_t before = mini.host.heard().size();
  for (int i = 0; i < 100 && mini.host.heard().size() == before; ++i) mini.board.run_for(kMs / 10);
  REQUIRE(mini.board.chip().break_dma("usart6", DmaWay::transmit));
  const unsigned frames = mini.observed(kImuFrames);
  mini.board.run_for(100 * kMs);
  CHECK(mini.board.resets() == 0);
  CHECK(mini.observed(kImuFrames) >= frames + 19);  // buckets run on
  mini.host.send("abc");
  mini.board.run_for(100 * kMs);
  CHECK(mini.host.text().substr(before).find("abc") != std::string::npos);
}

TEST_CASE("a part that holds the data line over a reset keeps the first write waiting for its clocks alone") {
  const auto first_write = [](unsigned clocks) {
    MiniBoard mini;
    mini.board.run_for(300 * kMs);
    bool is_written = false;
    mini.pwm.on_write = [&is_written](unsigned, std::uint64_t) { is_written = true; };
    mini.board.press_reset();
    mini.board.chip().i2c("i2c2")->line.hold_sda(clocks);
    unsigned tenths = 0;
    for (; tenths < 5000 && !is_written; ++tenths) mini.board.run_for(kMs / 10);
    mini.board.run_for(300 * kMs);
    CHECK(mini.observed(kPressureValid) == 1);
    return tenths;
  };
  const unsigned on_free_lines = first_write(0);
  REQUIRE(on_free_lines < 1000);
  for (const unsigned clocks : {1U, 5U, 9U}) {
    INFO(clocks << " clocks");
    CHECK(first_write(clocks) <= on_free_lines + 3);
  }
}

TEST_CASE("the first pulses after a reset are those of a robot without sensors, never the ones before it") {
  MiniBoard mini;
  mini.board.run_for(300 * kMs);
  REQUIRE(mini.pwm.pulse_ns(3) > 1'590'000);
  const auto [timer, channel] = mini.board.chip().pwm("pwm1");
  std::vector<std::uint64_t> header, expander;
  timer->on_pulse = [&header, mine = channel](unsigned which, Timer::Pulse pulse) {
    if (which == mine) header.push_back(pulse.width_ns);
  };
  mini.pwm.on_write = [&](unsigned which, std::uint64_t pulse) {
    if (which == 3) expander.push_back(pulse);
  };
  mini.imu.silent = true;
  mini.board.press_reset();
  CHECK(timer->pulse(channel).width_ns == 0);
  mini.board.run_for(100 * kMs);
  REQUIRE(header.size() == 2);
  CHECK(header[0] == 0);
  CHECK(header[1] == Approx(1'600'000).margin(500));
  REQUIRE(!expander.empty());
  for (const std::uint64_t pulse : expander) CHECK(pulse == Approx(1'500'000).margin(3'000));
  mini.imu.silent = false;
  mini.board.run_for(300 * kMs);
  CHECK(header.back() == Approx(1'700'000).margin(500));
  CHECK(expander.back() == Approx(1'600'000).margin(3'000));
  CHECK(mini.board.resets() == 1);
}
