// The emulator as a program for images of others: what it prints, and how it ends.
#include <sys/wait.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "catch.hpp"

namespace {

struct Ran {
  int status = 0;
  std::string output;
  [[nodiscard]] bool says(const std::string& text) const { return output.find(text) != std::string::npos; }
};

Ran emulator(const std::string& words) {
  Ran ran;
  FILE* pipe = popen((std::string(FINEMOTE_EMULATOR) + " " + words + " 2>&1").c_str(), "r");
  REQUIRE(pipe != nullptr);
  char buffer[4096];
  for (std::size_t n; (n = fread(buffer, 1, sizeof buffer, pipe)) > 0;) ran.output.append(buffer, n);
  ran.status = WEXITSTATUS(pclose(pipe));
  return ran;
}

const std::string kImages = FINEMOTE_IMAGES;
constexpr const char* kTypeC = " --board robomaster_type_c";

/// A scenario in a file. @return the option that names it
std::string scenario(const std::string& name, const std::string& text) {
  const std::string path = kImages + "/" + name + ".json";
  std::ofstream(path) << text;
  return " --scenario " + path;
}

nlohmann::ordered_json document(const std::string& words, int status = 0) {
  const Ran ran = emulator(words + " --format json");
  INFO(ran.output);
  REQUIRE(ran.status == status);
  return nlohmann::ordered_json::parse(ran.output);
}

/// What a part saw.
nlohmann::ordered_json seen_by(const nlohmann::ordered_json& document, const std::string& part) {
  for (const auto& it : document.at("parts")) {
    if (it.at("name") == part) return it.at("seen");
  }
  return nullptr;
}

}  // namespace

TEST_CASE("an image's pins, serial buses and clocks are printed, each with its time") {
  const Ran ran = emulator("--image " + kImages + "/mini.elf --duration 20");
  INFO(ran.output);
  CHECK(ran.status == 0);
  CHECK(ran.says(" PA4 1\n"));                   // a chip select that rests
  CHECK(ran.says(" i2c2 address 0xE0 NACK\n"));  // the mux is not there
  CHECK(ran.says("# the time is over at 20"));
  CHECK(ran.says("# core 168000000 Hz, APB1 42000000 Hz, APB2 84000000 Hz"));
}

TEST_CASE("a scenario hangs parts on the buses, also ones that are nothing but registers") {
  const Ran ran =
      emulator("--image " + kImages + "/mini.elf --duration 20" + scenario("watch", R"({"schema": "finemote.scenario/1",
    "parts": [{"type": "register_bank", "name": "mux", "port": "i2c2", "address": 112}],
    "expect": [{"part": "mux", "value": "r1", "from_ns": 19000000, "min": 0, "max": 0}]})"));
  INFO(ran.output);
  CHECK(ran.status == 0);
  CHECK(ran.says(" i2c2 address 0xE0 ACK\n"));
  CHECK(ran.says("# mux r1 as expected: 0 to 0"));
}

TEST_CASE("the run lasts at least until the last event") {
  const Ran ran =
      emulator("--image " + kImages + "/mini.elf --duration 20" + scenario("late", R"({"schema": "finemote.scenario/1",
    "events": [{"t_ns": 50000000, "pin": "PA0", "do": "low"}]})"));
  INFO(ran.output);
  CHECK(ran.status == 0);
  CHECK(ran.says("# the time is over at 50"));
}

TEST_CASE("a scenario with mistakes is refused at their words, before the image runs") {
  const Ran ran =
      emulator("--image " + kImages + "/mini.elf --duration 20" + scenario("wrong", R"({"schema": "finemote.scenario/1",
 "events": [{"t_ns": 1, "port": "usart9", "do": "silent"}]})"));
  INFO(ran.output);
  CHECK(ran.status == 2);
  CHECK(ran.says("wrong.json:2:33: error[FM6007]: the board has no port 'usart9'"));
  CHECK(ran.says("did you mean"));
  CHECK(!ran.says("# the time is over"));
}

TEST_CASE("a crystal of another frequency is another clock, and too fast a core is reported") {
  const Ran ran = emulator("--image " + kImages + "/mini.elf --duration 10 --crystal 16000000");
  INFO(ran.output);
  CHECK(ran.status == 0);  // a report says what real hardware may not forgive; this one went on
  CHECK(ran.says("# core 224000000 Hz"));
  CHECK(ran.says("# clock: the core runs above 168 MHz"));
}

TEST_CASE("a board's parts are there without a scenario, and tell what they saw") {
  const auto found = document("--image " + kImages + "/onboard.elf" + kTypeC + " --duration 1s");
  CHECK(found.at("schema") == "finemote.emulator/1");
  CHECK(found.at("image") == kImages + "/onboard.elf");
  CHECK(found.at("duration_ns").get<double>() == Approx(1e9).margin(1e3));
  CHECK(found.at("instructions") > 1'000'000);
  CHECK(found.at("stopped").is_null());
  CHECK(found.at("reports").empty());
  std::string names;
  for (const auto& part : found.at("parts")) names += part.at("name").get<std::string>() + " ";
  CHECK(names == "bmi088 ist8310 led_red led_green led_blue buzzer heater key battery ");
  CHECK(seen_by(found, "led_blue").at("share").get<double>() == Approx(0.25).margin(0.001));
  CHECK(seen_by(found, "led_blue").at("frequency").get<double>() == Approx(1000).margin(0.1));
  CHECK(seen_by(found, "led_red").at("share") == 0);
  CHECK(seen_by(found, "heater").at("share").get<double>() == Approx(0.25).margin(0.001));
  CHECK(seen_by(found, "bmi088").at("temperature") > 25);
  CHECK(seen_by(found, "battery").at("volts") == 24);
  CHECK(seen_by(found, "battery").at("conversions") > 50);
  CHECK(seen_by(found, "key").at("presses") == 0);
}

TEST_CASE("a scenario presses the board's key, and replaces its parts by its own") {
  const auto found = document("--image " + kImages + "/onboard.elf" + kTypeC + " --duration 600ms" +
                              scenario("pressed", R"({"schema": "finemote.scenario/1",
    "parts": [{"type": "battery", "name": "pack", "port": "adc3", "input": 8, "volts": 21, "divider": 10.0909}],
    "events": [{"t_ns": 150000000, "part": "key", "do": "press"}, {"t_ns": 300000000, "part": "key", "do": "release"}],
    "expect": [{"part": "led_green", "value": "share", "from_ns": 200000000, "to_ns": 290000000, "min": 0.49, "max": 0.51},
               {"part": "buzzer", "value": "frequency", "from_ns": 200000000, "to_ns": 290000000, "min": 1990, "max": 2010}]})"));
  CHECK(seen_by(found, "key").at("presses") == 1);
  CHECK(seen_by(found, "pack").at("volts") == 21);
  CHECK(seen_by(found, "battery").is_null());
  CHECK(seen_by(found, "led_red").at("share").get<double>() == Approx(0.75).margin(0.001));  // it runs low
}

TEST_CASE("expectations that do not hold, and a fault whose routine does not end, are exit status 1") {
  const std::string mini = "--image " + kImages + "/mini.elf" + kTypeC + " --duration 20";
  const auto wrong = document(mini + scenario("wrong_light", R"({"schema": "finemote.scenario/1",
    "expect": [{"part": "led_red", "value": "share", "from_ns": 19000000, "min": 1, "max": 1}]})"),
                              1);
  CHECK(wrong.at("stopped").is_null());
  const auto dead = document("--image " + kImages + "/lost.elf --duration 20", 1);
  CHECK(dead.at("stopped") == "hardfault");
  REQUIRE(dead.at("reports").size() == 1);
  CHECK(dead.at("reports")[0].at("what").get<std::string>().find("fault: access to 0x60000000") == 0);
  CHECK(dead.at("reports")[0].at("address") == 0x60000000);
  CHECK(dead.at("reports")[0].at("count") == 1);
  CHECK(dead.at("reports")[0].at("pc") > 0x08000000);
  CHECK(emulator("--image " + kImages + "/lost.elf --duration 20")
            .says("# the time is over, in the routine of a fault,"));
}

TEST_CASE("a report names the register, and does not change the exit status") {
  const auto found = document("--image " + kImages + "/mini.elf --duration 10 --crystal 16000000");
  bool is_there = false;
  for (const auto& report : found.at("reports")) {
    if (report.at("what") != "clock: the core runs above 168 MHz") continue;
    is_there = true;
    CHECK(report.at("count") >= 1);
  }
  CHECK(is_there);
}

TEST_CASE("a board is known by its name or its file, and extends another") {
  CHECK(emulator("--image " + kImages + "/mini.elf --duration 5 --board stm32f4_discovery").says("# led_orange: "));
  const std::string file = kImages + "/mine.json";
  std::ofstream(file) << R"({"schema": "finemote.board/1", "name": "mine", "extends": "robomaster_type_c",
    "clocks": {"crystal_hz": 8000000}, "on_board": [{"name": "lamp", "type": "load", "port": "led_red"}]})";
  const Ran mine = emulator("--image " + kImages + "/mini.elf --duration 5 --board " + file);
  CHECK(mine.says("# core 112000000 Hz"));
  CHECK(mine.says("# lamp: "));
  const Ran unknown = emulator("--image " + kImages + "/mini.elf --board type_d");
  CHECK(unknown.status == 2);
  CHECK(unknown.says("there is no board 'type_d'; there are 'host', 'qemu_f405', 'robomaster_type_c'"));
}

TEST_CASE("the parts of every shipped board can be placed on it") {
  for (const char* board : {"robomaster_type_c", "stm32f4_discovery"}) {
    const Ran ran = emulator("--image " + kImages + "/two_tasks.elf --duration 1 --board " + board);
    INFO(ran.output);
    CHECK(ran.status == 0);
    CHECK(ran.says("# led_blue: share 0"));
  }
}

TEST_CASE("words that are no options, and files that are no images, are errors") {
  CHECK(emulator("").status == 2);
  CHECK(emulator("--image").status == 2);
  CHECK(emulator("--image a.elf --duration 0").status == 2);
  CHECK(emulator("--image a.elf --duration 2hours").status == 2);
  CHECK(emulator("--image a.elf --flash maybe").status == 2);
  CHECK(emulator("--image a.elf --format xml").status == 2);
  std::ofstream(kImages + "/deep.json") << R"({"schema": "finemote.scenario/1", "parts": )"
                                        << std::string(1'000'000, '[') << std::string(1'000'000, ']') << "}";
  CHECK(emulator("--image " + kImages + "/two_tasks.elf --scenario " + kImages + "/deep.json").status == 2);
  const Ran ran = emulator("--image nowhere.elf");
  CHECK(ran.status == 2);
  CHECK(ran.says("cannot read 'nowhere.elf'"));
}

TEST_CASE("an image may also be Intel HEX, or the bytes of the flash") {
  const std::string elf = kImages + "/two_tasks.elf", hex = kImages + "/two_tasks.hex",
                    bin = kImages + "/two_tasks.bin";
  REQUIRE(std::system(("arm-none-eabi-objcopy -O ihex " + elf + " " + hex).c_str()) == 0);
  REQUIRE(std::system(("arm-none-eabi-objcopy -O binary " + elf + " " + bin).c_str()) == 0);
  const auto instructions = document("--image " + elf + kTypeC + " --duration 50").at("instructions");
  CHECK(document("--image " + hex + kTypeC + " --duration 50").at("instructions") == instructions);
  CHECK(document("--image " + bin + kTypeC + " --duration 50").at("instructions") == instructions);
  std::ofstream(kImages + "/damaged.hex") << ":10000000000001200100000801000008010000089F\n:00000001FE\n";
  const Ran damaged = emulator("--image " + kImages + "/damaged.hex");
  CHECK(damaged.status == 2);
  CHECK(damaged.says("line 1 is no record of Intel HEX"));
}
