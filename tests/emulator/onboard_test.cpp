// What is soldered to the board, driven by an image made from a URDF: key, battery, LED, buzzer and a PWM header.
#include <nlohmann/json.hpp>

#include "catch.hpp"
#include "emulator/board.hpp"
#include "emulator/outfit/outfit.hpp"
#include "tests/emulator/tested_chip.hpp"
#include "tests/emulator/type_c.hpp"

using namespace finemote::emulator;

namespace {

constexpr std::uint64_t kMs = 1'000'000;

struct Bench {
  explicit Bench(const char* events) {
    board.load(load_image(std::string(FINEMOTE_IMAGES) + "/onboard.elf"));
    outfit.add(nlohmann::ordered_json::parse(events));
  }
  Timer::Pulse pulse(const char* port) {
    const auto [timer, channel] = board.chip().pwm(port);
    return timer->pulse(channel);
  }
  /// Share of time an output is on [%].
  double share(const char* port) {
    const Timer::Pulse now = pulse(port);
    return now.period_ns == 0 ? -1 : 100.0 * static_cast<double>(now.width_ns) / static_cast<double>(now.period_ns);
  }
  /// Time between power-on and the first release, from the cycle counter.
  std::int64_t zero() {
    auto& world = board.world();
    const std::int64_t cycles = world.system().read(0xE0001004, 4, world.now(), 0);
    return static_cast<std::int64_t>(board.now_ns()) - cycles * 125 / 21;
  }
  Board board{finemote::test::type_c(), finemote::test::tested_chip()};
  Outfit outfit{board};
};

const char* const kEvents = R"({
  "schema": "finemote.scenario/1",
  "events": [
    {"t_ns": 0, "port": "adc3", "do": "volts", "input": 8, "volts": 2.378},
    {"t_ns": 150000000, "pin": "PA0", "do": "low"},
    {"t_ns": 155000000, "pin": "PA0", "do": "release"},
    {"t_ns": 158000000, "pin": "PA0", "do": "low"},
    {"t_ns": 300000000, "pin": "PA0", "do": "high"},
    {"t_ns": 400000000, "port": "adc3", "do": "volts", "input": 8, "volts": 2.08},
    {"t_ns": 600000000, "port": "adc3", "do": "silent"}
  ]
})";

}  // namespace

TEST_CASE("key, battery, LED, buzzer and header do what the URDF says, and nothing is used wrongly") {
  Bench bench(kEvents);
  bench.board.run_for(100 * kMs);
  CHECK(bench.share("led_red") == Approx(0).margin(0.1));
  CHECK(bench.share("led_green") == Approx(0).margin(0.1));
  CHECK(bench.share("led_blue") == Approx(25).margin(0.1));
  CHECK(bench.pulse("led_blue").period_ns == Approx(1'000'000).margin(50));
  CHECK(bench.share("pwm5") == Approx(25).margin(0.1));
  CHECK(bench.pulse("pwm5").period_ns == Approx(20'000'000).margin(50));
  CHECK(bench.share("imu_heater") == Approx(25).margin(0.1));
  CHECK(bench.pulse("imu_heater").period_ns == Approx(1'000'000).margin(50));
  CHECK(bench.pulse("buzzer").width_ns == 0);

  bench.board.run_for(70 * kMs);  // 170 ms: down for 12 ms, after a bounce
  CHECK(bench.share("led_green") == Approx(0).margin(0.1));
  bench.board.run_for(30 * kMs);
  CHECK(bench.share("led_green") == Approx(50).margin(0.1));
  CHECK(bench.share("led_blue") == Approx(0).margin(0.1));
  CHECK(bench.pulse("buzzer").period_ns == Approx(500'000).margin(50));
  CHECK(bench.share("buzzer") == Approx(50).margin(0.1));

  bench.board.run_for(150 * kMs);  // 350 ms: released
  CHECK(bench.pulse("buzzer").width_ns == 0);
  CHECK(bench.share("led_blue") == Approx(25).margin(0.1));
  CHECK(bench.share("led_red") == Approx(0).margin(0.1));
  bench.board.run_for(150 * kMs);  // 500 ms: 21 V
  CHECK(bench.share("led_red") == Approx(75).margin(0.1));
  CHECK(bench.board.chip().adc("adc3")->conversions() >= 45);
  for (const Report& report : bench.board.reports()) {
    INFO(name_of(report.misuse) << ": " << report.text);
    CHECK(false);
  }
}

TEST_CASE("edges are counted and timed by their interrupts, and outputs of a use are driven") {
  Bench bench(R"({"schema": "finemote.scenario/1", "events": [
    {"t_ns": 100000000, "pin": "PG3", "do": "low"}, {"t_ns": 101000000, "pin": "PG3", "do": "high"},
    {"t_ns": 102000000, "pin": "PG3", "do": "low"},
    {"t_ns": 100000000, "pin": "PC4", "do": "low"},
    {"t_ns": 110000000, "pin": "PC5", "do": "low"}, {"t_ns": 110001000, "pin": "PC5", "do": "high"},
    {"t_ns": 110002000, "pin": "PC5", "do": "low"}, {"t_ns": 110500000, "pin": "PC5", "do": "high"},
    {"t_ns": 120000000, "pin": "PC5", "do": "low"}]})");
  const auto seen = [&](unsigned index) { return bench.board.word("edges_seen", 4 * index); };
  bench.board.run_for(99 * kMs);
  CHECK(seen(0) == 0);
  CHECK(!bench.board.chip().gpio('I').level(1));
  bench.board.run_for(100 * kMs);
  CHECK(seen(0) == 2);
  CHECK(seen(1) == 1);
  CHECK(seen(2) == 3);
  CHECK(seen(4) == 0);
  CHECK(bench.board.chip().gpio('I').level(1));
  // The board's time begins with its first release, a few milliseconds after power-on; the interrupt takes some 2 us.
  const std::int64_t zero = bench.zero();
  CHECK(std::abs(static_cast<std::int64_t>(seen(3)) + zero - 120'000'000) < 5'000);
}

TEST_CASE("the RS-485 driver is on from the first start bit to the last stop bit, and answers arrive") {
  Bench bench(R"({"schema": "finemote.scenario/1", "parts": [
    {"type": "host_terminal", "name": "far", "port": "usart1", "baud": 115200}]})");
  std::vector<std::pair<std::uint64_t, bool>> driver;
  auto& gpio = bench.board.chip().gpio('I');
  gpio.watcher[0] = [&](bool output, bool high) {
    if (output) driver.push_back({bench.board.now_ns(), high});
  };
  SerialTerminal& far = *bench.outfit.terminal("far");
  std::size_t answered = 0;
  for (int i = 0; i < 2000; ++i) {
    bench.board.run_for(100'000);
    if (far.heard().size() / 4 == answered) continue;
    answered = far.heard().size() / 4;
    CHECK(!gpio.level(0));  // the line is free again
    far.send(std::vector<std::uint8_t>{0xA0, 0xB1, static_cast<std::uint8_t>(answered)});
  }
  for (const unsigned unit : {0U, 16U}) {
    CHECK(bench.board.word("answers_seen", unit) >= 15);
    CHECK(bench.board.word("answers_seen", unit + 4) >> 8 == 0xA0B1);
  }
  REQUIRE(far.heard().size() >= 8);
  CHECK(far.text().substr(0, 4) == std::string("\x3E\x07\x55\x01", 4));
  std::size_t question = 0;
  for (const auto& [at, on] : driver) {
    if (question * 4 + 3 >= far.heard().size()) break;
    const std::uint64_t first = to_ns(far.heard()[question * 4].at) - 86'806,
                        last = to_ns(far.heard()[question * 4 + 3].at);
    if (on) CHECK(at <= first + 1'000);
    if (on) continue;
    if (at + 1'000 < first) continue;  // the idle level of the start
    CHECK(at >= last);
    CHECK(at - last < 10'000);  // the interrupt at the end of the last stop bit
    ++question;
  }
  CHECK(question >= 15);
  CHECK(bench.board.reports().empty());
}

namespace {

/// The far end of the RS-485 line: two units, which answer with their number and the count of their questions.
struct FarEnd {
  explicit FarEnd(Bench& bench) : bench(bench), terminal(*bench.outfit.terminal("far")) {}
  /// Answers for `ns`, at most 0.1 ms after each question.
  void serve(std::uint64_t ns) {
    for (std::uint64_t t = 0; t < ns; t += kMs / 10) {
      bench.board.run_for(kMs / 10);
      driven += bench.board.chip().gpio('I').level(0) ? 1 : 0;
      while (terminal.heard().size() / 4 > questions) {
        const std::uint8_t unit = terminal.heard()[4 * questions++ + 1].byte;
        ++asked[unit % 2];
        if (dead == unit) continue;
        terminal.send(std::vector<std::uint8_t>{unit, 0x5A, static_cast<std::uint8_t>(asked[unit % 2])});
      }
    }
  }
  struct Seen {
    std::uint32_t count, last, missing, valid;
  };
  Seen seen(unsigned unit) {
    const std::uint32_t at = unit % 2 == 1 ? 0 : 16;
    const auto word = [&](std::uint32_t offset) { return bench.board.word("answers_seen", at + offset); };
    return {word(0), word(4), word(8), word(12)};
  }
  Bench& bench;
  SerialTerminal& terminal;
  std::size_t questions = 0;
  unsigned asked[2]{};
  unsigned driven = 0;  ///< looks, one every 0.1 ms, at which the line was driven
  unsigned dead = 0;    ///< this unit does not answer
};

}  // namespace

TEST_CASE(
    "a unit on RS-485 that does not answer is invalid within 20 ms, the other is not, and its answers count again") {
  Bench bench(R"({"schema": "finemote.scenario/1", "parts": [
    {"type": "host_terminal", "name": "far", "port": "usart1", "baud": 115200}]})");
  FarEnd far(bench);
  far.serve(100 * kMs);
  REQUIRE(far.seen(7).valid == 1);
  REQUIRE(far.seen(8).valid == 1);
  const auto before = far.seen(7), other_before = far.seen(8);
  far.dead = 7;
  far.serve(20 * kMs);
  CHECK(far.seen(7).valid == 0);
  far.driven = 0;
  for (int i = 0; i < 480; ++i) {
    far.serve(1 * kMs);
    CHECK(far.seen(7).valid == 0);
    CHECK(far.seen(8).valid == 1);
  }
  CHECK(far.driven < 600);  // of 4800 looks: two questions of 0.35 ms every 10 ms
  const auto silent = far.seen(7), other = far.seen(8);
  CHECK(silent.count <= before.count + 1);
  CHECK(silent.last == before.last + silent.count - before.count);
  CHECK(silent.missing - before.missing >= 48);  // asked again every period
  CHECK(other.count - other_before.count >= 49);
  CHECK(other.missing == other_before.missing);
  CHECK(other.last >> 8 == 0x085A);
  far.dead = 0;
  far.serve(20 * kMs);
  CHECK(far.seen(7).valid == 1);
  CHECK(far.seen(7).last >> 8 == 0x075A);
  CHECK((far.seen(7).last & 0xFF) >= far.asked[1] - 1);  // of this question, or of the one before
  CHECK(bench.board.resets() == 0);
  CHECK(bench.board.reports().empty());
}

TEST_CASE("an answer on RS-485 that comes after its time is not taken for one to the next question") {
  Bench bench(R"({"schema": "finemote.scenario/1", "parts": [
    {"type": "host_terminal", "name": "far", "port": "usart1", "baud": 115200}]})");
  FarEnd far(bench);
  far.serve(100 * kMs);
  far.dead = 7;
  const unsigned asked = far.asked[1];
  while (far.asked[1] == asked) far.serve(kMs / 10);
  const auto before = far.seen(7), other = far.seen(8);
  far.serve(7 * kMs);  // 3.2 ms are its time: twice that on the wire and 2 ms; the other unit was asked at 5 ms
  far.terminal.send(std::vector<std::uint8_t>{7, 0x77, 0x77});
  far.serve(33 * kMs);
  CHECK(far.seen(7).count <= before.count + 1);
  CHECK(far.seen(7).last != 0x077777);
  CHECK(far.seen(8).count >= other.count + 3);
  CHECK(far.seen(8).last >> 8 == 0x085A);
  far.dead = 0;
  far.serve(30 * kMs);
  CHECK(far.seen(7).valid == 1);
  CHECK(far.seen(8).valid == 1);
}

TEST_CASE("a converter that falls silent makes lamps blink or dark in bounded time") {
  Bench bench(kEvents);
  bench.board.run_for(590 * kMs);
  REQUIRE(bench.share("pwm5") > 50);
  bench.board.run_for(600 * kMs + 1'100 * kMs);  // 500 ms without a conversion, then 1 s without fresh data
  CHECK(bench.share("pwm5") == Approx(0).margin(0.1));
  unsigned turns = 0;
  double last = bench.share("led_red");
  for (int i = 0; i < 100; ++i) {
    bench.board.run_for(10 * kMs);
    turns += bench.share("led_red") != last ? 1 : 0;
    last = bench.share("led_red");
  }
  CHECK(turns >= 16);  // every 50 ms, or with the next job where one comes a little too soon: every 60
  CHECK(turns <= 20);
}

TEST_CASE("events at pins and converters are checked") {
  Board board{finemote::test::type_c(), finemote::test::tested_chip()};
  Outfit outfit(board);
  const auto add = [&](const char* event) {
    outfit.add(
        nlohmann::ordered_json::parse(std::string(R"({"schema": "finemote.scenario/1", "events": [)") + event + "]}"));
  };
  CHECK_NOTHROW(add(R"({"t_ns": 1, "pin": "PI11", "do": "high"})"));
  CHECK_THROWS_AS(add(R"({"t_ns": 1, "pin": "PI16", "do": "high"})"), std::invalid_argument);
  CHECK_THROWS_AS(add(R"({"t_ns": 1, "pin": "key", "do": "high"})"), std::invalid_argument);
  CHECK_THROWS_AS(add(R"({"t_ns": 1, "pin": "PA0", "do": "press"})"), std::invalid_argument);
  CHECK_THROWS_AS(add(R"({"t_ns": 1, "pin": "PA0", "port": "adc3", "do": "high"})"), std::invalid_argument);
}
