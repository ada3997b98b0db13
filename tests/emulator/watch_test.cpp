// The emulator as a program for images of others: what it prints, and how it ends.
#include <sys/wait.h>

#include <cstdio>
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
  const std::string scenario = kImages + "/watch.json";
  FILE* file = fopen(scenario.c_str(), "w");
  REQUIRE(file != nullptr);
  fputs(R"({"schema": "finemote.scenario/1",
            "parts": [{"type": "register_bank", "name": "mux", "port": "i2c2", "address": 112}],
            "expect": [{"part": "mux", "value": "r1", "from_ns": 19000000, "min": 0, "max": 0}]})",
        file);
  fclose(file);
  const Ran ran = emulator("--image " + kImages + "/mini.elf --duration 20 --scenario " + scenario);
  INFO(ran.output);
  CHECK(ran.status == 0);
  CHECK(ran.says(" i2c2 address 0xE0 ACK\n"));
  CHECK(ran.says("# mux r1 as expected: 0 to 0"));
}

TEST_CASE("the run lasts at least until the last event") {
  const std::string scenario = kImages + "/late.json";
  FILE* file = fopen(scenario.c_str(), "w");
  REQUIRE(file != nullptr);
  fputs(R"({"schema": "finemote.scenario/1", "events": [{"t_ns": 50000000, "pin": "PA0", "do": "low"}]})", file);
  fclose(file);
  const Ran ran = emulator("--image " + kImages + "/mini.elf --duration 20 --scenario " + scenario);
  INFO(ran.output);
  CHECK(ran.status == 0);
  CHECK(ran.says("# the time is over at 50"));
}

TEST_CASE("a scenario with mistakes is refused at their words, before the image runs") {
  const std::string scenario = kImages + "/wrong.json";
  FILE* file = fopen(scenario.c_str(), "w");
  REQUIRE(file != nullptr);
  fputs(
      "{\"schema\": \"finemote.scenario/1\",\n \"events\": [{\"t_ns\": 1, \"port\": \"usart9\", \"do\": \"silent\"}]}",
      file);
  fclose(file);
  const Ran ran = emulator("--image " + kImages + "/mini.elf --duration 20 --scenario " + scenario);
  INFO(ran.output);
  CHECK(ran.status == 2);
  CHECK(ran.says("wrong.json:2:33: error[FM6007]: the board has no port 'usart9'"));
  CHECK(ran.says("did you mean"));
  CHECK(!ran.says("# the time is over"));
}

TEST_CASE("a crystal of another frequency is another clock, and too fast a core is reported") {
  const Ran ran = emulator("--image " + kImages + "/mini.elf --duration 10 --crystal 16000000");
  INFO(ran.output);
  CHECK(ran.status == 1);
  CHECK(ran.says("# core 224000000 Hz"));
  CHECK(ran.says("# clock: the core runs above 168 MHz"));
}

TEST_CASE("words that are no options, and files that are no images, are errors") {
  CHECK(emulator("").status == 2);
  CHECK(emulator("--image").status == 2);
  CHECK(emulator("--image a.elf --duration 0").status == 2);
  CHECK(emulator("--image a.elf --flash maybe").status == 2);
  const Ran ran = emulator("--image nowhere.elf");
  CHECK(ran.status == 2);
  CHECK(ran.says("cannot read 'nowhere.elf'"));
}
