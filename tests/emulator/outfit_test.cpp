// Parts and events from a JSON document, on the `mini` image.
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "catch.hpp"
#include "emulator/outfit/outfit.hpp"
#include "tests/emulator/type_c.hpp"

using namespace finemote::emulator;

namespace {

const char* const kParts = R"({
  "schema": "finemote.scenario/1",
  "parts": [
    {"type": "h30_imu", "name": "imu", "port": "usart1", "baud": 460800, "period_ns": 5000000, "phase_ns": 1000000},
    {"type": "host_terminal", "name": "host", "port": "usart6", "baud": 115200, "even_parity": true},
    {"type": "tca9548a", "name": "mux", "port": "i2c2", "address": 112},
    {"type": "ms5837", "name": "baro", "mux": "mux", "channel": 0, "variant": "30BA"},
    {"type": "pca9685", "name": "pwm", "mux": "mux", "channel": 4, "address": 64}
  ],
  "events": [
    {"t_ns": 300000000, "part": "imu", "do": "silent"},
    {"t_ns": 450000000, "part": "imu", "do": "silent", "on": false},
    {"t_ns": 500000000, "part": "baro", "do": "move", "pressure": 200000},
    {"t_ns": 600000000, "part": "host", "do": "send", "text": "ping"},
    {"t_ns": 700000000, "port": "i2c2", "do": "hold_sda", "clocks": 4}
  ]
})";

Image mini_image() { return load_image(std::string(FINEMOTE_IMAGES) + "/mini.elf"); }

}  // namespace

TEST_CASE("a scenario's parts answer and its events happen when they say") {
  Board board{finemote::test::type_c()};
  board.load(mini_image());
  Outfit outfit(board);
  outfit.add(nlohmann::ordered_json::parse(kParts));
  board.run_for(290'000'000);
  CHECK(board.word("observed", 0) == 1);
  CHECK(outfit.value("pwm", "pulse_3") == Approx(1600).margin(3));
  board.run_for(110'000'000);  // 400 ms
  CHECK(board.word("observed", 0) == 0);
  CHECK(outfit.value("pwm", "pulse_3") == Approx(1500).margin(3));
  board.run_for(290'000'000);  // 690 ms
  CHECK(board.word("observed", 0) == 1);
  CHECK(board.word("observed", 12) == Approx(200'000).margin(10));
  CHECK(outfit.text("host") == "ping");
  board.run_for(200'000'000);              // 890 ms
  CHECK(board.word("observed", 24) == 1);  // one recovery
  // The silence ended in neutral, and the end of it in the old pulse: three changes of channel 3.
  std::vector<double> pulses;
  for (const PartEvent& event : outfit.events()) {
    if (event.kind == PartEvent::Kind::output && event.channel == 3) pulses.push_back(event.value / 10'000);
  }
  CHECK(pulses.size() >= 3);
}

TEST_CASE("events and looks count from the instant the scenario begins at") {
  Board board{finemote::test::type_c()};
  board.load(mini_image());
  Outfit outfit(board);
  auto document = nlohmann::ordered_json::parse(kParts);
  document["expect"] = {
      {{"from_ns", 350'000'000}, {"part", "pwm"}, {"value", "pulse_3"}, {"min", 1590}, {"max", 1610}}};
  outfit.add(document, 100'000'000);
  board.run_for(390'000'000);
  CHECK(outfit.value("pwm", "pulse_3") == Approx(1600).margin(3));  // the silence begins at 400 ms
  board.run_for(70'000'000);
  CHECK(outfit.value("pwm", "pulse_3") == Approx(1500).margin(3));
  CHECK(outfit.expectations().at(0).looks == 1);
  const std::uint64_t broken_ns = outfit.expectations().at(0).broken_ns;
  CHECK(broken_ns >= 450'000'000);
  CHECK(broken_ns <= 450'000'000 + 1'000);  // between two instructions
}

TEST_CASE("a fault violates an assumption, what ends one does not") {
  using Assumptions = std::vector<std::string>;
  const auto violated = [](const std::string& event) {
    Board board{finemote::test::type_c()};
    Outfit outfit(board);
    auto document = nlohmann::ordered_json::parse(kParts);
    document["events"] = nlohmann::ordered_json::parse("[{\"t_ns\": 1, " + event + "}]");
    outfit.add(document);
    Assumptions assumptions;
    for (const Violation& violation : outfit.violated()) assumptions.push_back(violation.assumption);
    return assumptions;
  };
  CHECK(violated(R"("part": "imu", "do": "silent")") == Assumptions{"bus-errors"});
  CHECK(violated(R"("part": "imu", "do": "silent", "on": true)") == Assumptions{"bus-errors"});
  CHECK(violated(R"("part": "imu", "do": "damage", "frames": 1}, {"t_ns": 2, "part": "imu", "do": "silent")") ==
        Assumptions{"bus-errors"});
  CHECK(violated(R"("part": "pwm", "do": "power_cycle")") == Assumptions{"recovery"});
  CHECK(violated(R"("port": "can1", "do": "flood", "identifier": 1, "frames": 1}, {"t_ns": 2, "do": "reset")") ==
        Assumptions{"declared-nodes", "bring-up"});
  CHECK(violated(R"("port": "i2c2", "do": "hold_sda", "clocks": 4)") == Assumptions{"bus-errors"});
  CHECK(violated(R"("part": "imu", "do": "silent", "on": false)").empty());
  CHECK(violated(R"("port": "usart1", "do": "silent", "on": false)").empty());
  CHECK(violated(R"("port": "adc3", "do": "silent", "on": false)").empty());
  CHECK(violated(R"("port": "i2c2", "do": "release_sda")").empty());
}

TEST_CASE("a value that is not finite fails, and is told from one that was not seen") {
  Board board{finemote::test::type_c()};
  board.load(mini_image());
  Outfit outfit(board);
  outfit.add(nlohmann::ordered_json::parse(R"({"schema": "finemote.scenario/1",
    "parts": [{"type": "dji_motor", "name": "wheel", "port": "can1", "feedback_id": 513, "command_id": 512, "word": 0}],
    "events": [{"t_ns": 0, "part": "wheel", "do": "disturb", "torque": 1e308},
               {"t_ns": 2000000, "part": "wheel", "do": "disturb", "torque": -1e308}],
    "expect": [{"from_ns": 500000, "part": "wheel", "value": "commands", "min": 0, "max": 0},
               {"from_ns": 9000000, "to_ns": 9900000, "part": "wheel", "value": "angle", "min": -1e308, "max": 1e308},
               {"from_ns": 90000000, "part": "wheel", "value": "angle", "min": 0, "max": 0}]})"));
  board.run_for(20'000'000);
  const auto& [seen, infinite, late] =
      std::tie(outfit.expectations()[0], outfit.expectations()[1], outfit.expectations()[2]);
  CHECK(seen.holds());
  CHECK(seen.not_finite == 0);
  CHECK_FALSE(infinite.holds());
  CHECK(infinite.not_finite == 1);
  CHECK_FALSE(infinite.has_seen());
  CHECK_FALSE(late.holds());
  CHECK(late.not_finite == 0);
}

TEST_CASE("a scenario with a mistake is refused with the entry") {
  Board board{finemote::test::type_c()};
  Outfit outfit(board);
  const auto add = [&](const char* text) { outfit.add(nlohmann::ordered_json::parse(text)); };
  CHECK_THROWS_AS(add(R"({"parts": []})"), std::invalid_argument);
  CHECK_THROWS_AS(add(R"({"schema": "finemote.scenario/1", "part": []})"), std::invalid_argument);
  CHECK_THROWS_AS(add(R"({"schema": "finemote.scenario/1", "parts": [{"type": "sonar", "name": "s"}]})"),
                  std::invalid_argument);
  CHECK_THROWS_AS(
      add(R"({"schema": "finemote.scenario/1", "parts": [{"type": "h30_imu", "name": "s", "port": "usart9", "baud": 9600}]})"),
      std::invalid_argument);
  CHECK_THROWS_AS(add(R"({"schema": "finemote.scenario/1", "events": [{"t_ns": 1, "do": "silent"}]})"),
                  std::invalid_argument);
  CHECK_THROWS_AS(
      add(R"({"schema": "finemote.scenario/1", "events": [{"t_ns": "1ms", "port": "i2c2", "do": "nack"}]})"),
      std::invalid_argument);
}
