// What is soldered to the board, driven by an image made from a URDF: key, battery, LED, buzzer and a PWM header.
#include <nlohmann/json.hpp>

#include "catch.hpp"
#include "emulator/board.hpp"
#include "emulator/outfit.hpp"

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
  Board board;
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
  CHECK(bench.board.word("answers_seen") >= 15);
  CHECK(bench.board.word("answers_seen", 4) >> 8 == 0xA0B1);
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
  CHECK(turns >= 18);
  CHECK(turns <= 20);
}

TEST_CASE("events at pins and converters are checked") {
  Board board;
  Outfit outfit(board);
  const auto add = [&](const char* event) {
    outfit.add(
        nlohmann::ordered_json::parse(std::string(R"({"schema": "finemote.scenario/1", "events": [)") + event + "]}"));
  };
  CHECK_NOTHROW(add(R"({"t_ns": 1, "pin": "PI15", "do": "high"})"));
  CHECK_THROWS_AS(add(R"({"t_ns": 1, "pin": "PI16", "do": "high"})"), std::invalid_argument);
  CHECK_THROWS_AS(add(R"({"t_ns": 1, "pin": "key", "do": "high"})"), std::invalid_argument);
  CHECK_THROWS_AS(add(R"({"t_ns": 1, "pin": "PA0", "do": "press"})"), std::invalid_argument);
  CHECK_THROWS_AS(add(R"({"t_ns": 1, "pin": "PA0", "port": "adc3", "do": "high"})"), std::invalid_argument);
}
