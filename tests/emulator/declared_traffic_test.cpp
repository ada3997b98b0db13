// `run` holds what buses carry against what the devices on them declare: nothing else could show that a descriptor says
// less than its code and its part do.
#include <algorithm>

#include "catch.hpp"
#include "tests/cli/program.hpp"

using namespace finemote::test;

namespace {

using Json = nlohmann::json;

/// A robot with a device `own` on the bus `line`, of a type of the user's.
struct Case {
  const char* name;
  const char* bus;     ///< attributes of the bus
  const char* device;  ///< further attributes of the device
  Json descriptor;     ///< without its frames; or the file of another type, of which it is a copy
  const char* code;    ///< members of the class
  Json truth, lie;     ///< what is put in place of members of the descriptor
};

Json descriptor(const Json& members) {
  Json whole = {{"schema", "finemote.device/1"},
                {"type", "own"},
                {"summary", "sends"},
                {"class", "my::Own"},
                {"header", "own.hpp"},
                {"provides", {{{"interface", "Any"}}}},
                {"wcet", {{"update_ns", 20000}, {"handle_ns", 20000}}}};
  whole.update(members);
  return whole;
}

/// The descriptor of another type under the name `own`, as it stands in the folder `devices` of `robot`.
Json another(const std::string& file, const TemporaryFolder& robot) {
  Json whole = Json::parse(read_file(source_path(file)));
  const auto header = std::filesystem::path(source_path(file)).parent_path() / whole["header"].get<std::string>();
  whole["type"] = "own";
  whole["header"] = std::filesystem::relative(header, robot.path("devices")).generic_string();
  return whole;
}

Json frame(const char* stage, int write, int read) {
  Json entry = {{"stage", stage}};
  if (write > 0) entry["write"] = write;
  if (read > 0) entry["read"] = read;
  return entry;
}

Json frames(const std::vector<Json>& list) { return {{"frames", list}}; }

Json streamed_every(int ns) {
  return {{"acquisition", {{"model", "streamed"}, {"interval_ns", ns}, {"tolerance_ppm", 20000}}}};
}

std::vector<Case> cases() {
  const Json with_bank = {{"bus", {{"types", {"i2c"}}, {"address", {{"default", "0x2a"}}}}},
                          {"emulation", {{"part", "register_bank"}}}};
  return {
      {"a longer block on a serial line", R"(type="uart" port="usart6" baud="115200baud")", "",
       descriptor({{"bus", {{"types", {"uart"}}, {"format", "8N1"}}}}), R"(
  constexpr explicit Own(finemote::Uart& uart) : uart_(&uart) {}
  void update() {}
  void handle() { uart_->write(bytes_, sizeof bytes_); }
 private:
  finemote::Uart* const uart_;
  std::uint8_t bytes_[16]{};)",
       frames({frame("handle", 16, 0)}), frames({frame("handle", 8, 0)})},

      {"a longer exchange on SPI", R"(type="spi" port="spi1" clock="1312500Hz")", R"(channel="0")",
       descriptor({{"bus", {{"types", {"spi"}}, {"channel", {{"min", 0}, {"max", 1}}}}}}), R"(
  constexpr explicit Own(finemote::SpiSlot& slot) : slot_(&slot) {}
  void update() {
    if (!slot_->busy()) slot_->start(nullptr, bytes_, sizeof bytes_);
  }
  void handle() {}
 private:
  finemote::SpiSlot* const slot_;
  std::uint8_t bytes_[40]{};)",
       frames({frame("update", 0, 40)}), frames({frame("update", 0, 30)})},

      {"a longer answer on I2C", R"(type="i2c" port="i2c2" clock="400kHz")", "", descriptor(with_bank), R"(
  constexpr explicit Own(finemote::I2cSlot& slot) : slot_(&slot) {}
  void update() {
    if (!slot_->busy()) slot_->start(&register_, 1, answer_, sizeof answer_);
  }
  void handle() {}
 private:
  finemote::I2cSlot* const slot_;
  std::uint8_t register_ = 0x20, answer_[6]{};)",
       frames({frame("update", 1, 6)}), frames({frame("update", 1, 4)})},

      {"a longer answer on I2C that is asked for so seldom that the bus carries less", R"(type="i2c" port="i2c2")", "",
       descriptor(with_bank), R"(
  constexpr explicit Own(finemote::I2cSlot& slot) : slot_(&slot) {}
  void update() {
    if (++updates_ % 4 == 0 && !slot_->busy()) slot_->start(&register_, 1, answer_, sizeof answer_);
  }
  void handle() {}
 private:
  finemote::I2cSlot* const slot_;
  unsigned updates_ = 0;
  std::uint8_t register_ = 0x20, answer_[6]{};)",
       frames({frame("update", 1, 6)}), frames({frame("update", 1, 4)})},

      {"a part that sends more often on a serial line", R"(type="uart" port="usart1" baud="460800baud")", "",
       "schemas/devices/h30_imu.json", "", streamed_every(5'000'000), streamed_every(10'000'000)},

      {"a part that sends more often on CAN", R"(type="can" port="can1")", R"(id="1")",
       "tests/emulator/bounds/devices/diagnosing_motor.json", "", streamed_every(1'000'000), streamed_every(4'000'000)},
  };
}

void write_robot(const TemporaryFolder& folder, const Case& one, const Json& said) {
  std::filesystem::create_directories(folder.path("devices"));
  Json whole = one.descriptor.is_string() ? another(one.descriptor, folder) : one.descriptor;
  whole.update(said);
  write_file(folder.path("devices/own.json"), whole.dump());
  write_file(folder.path("devices/own.hpp"), std::string(R"(#pragma once
#include <cstdint>
#include "finemote/contract.hpp"
#include "finemote/i2c.hpp"
#include "finemote/spi.hpp"
#include "finemote/uart.hpp"
namespace my {
struct Own {
  finemote::Stamp state;)") + one.code + "\n};\n}  // namespace my\n");
  write_file(folder.path("r.urdf"),
             std::string(R"(<robot name="r"><link name="base"/><finemote version="1"><board name="robomaster_type_c"/>
  <bus name="line" )") +
                 one.bus +
                 R"(/><device name="all" type="group" period="5ms"><device name="own" type="own" bus="line" )" +
                 one.device + "/></device></finemote></robot>");
}

Json run(const Case& one, const Json& said, const std::vector<std::string>& options = {}) {
  const TemporaryFolder folder;
  write_robot(folder, one, said);
  std::vector<std::string> words = {"run", folder.path("r.urdf"), "--duration", "200ms", "--format", "json"};
  words.insert(words.end(), options.begin(), options.end());
  const auto ran = run_finemote(words);
  INFO(ran.output);
  const auto begin = ran.output.find('{');
  REQUIRE(begin != std::string::npos);
  Json document = Json::parse(ran.output.substr(begin));
  document["exit"] = ran.exit_status;
  return document;
}

bool reports_traffic(const Json& document) {
  const auto& findings = document["diagnostics"];
  return std::any_of(findings.begin(), findings.end(), [](const Json& f) { return f["code"] == "FM6015"; });
}

}  // namespace

TEST_CASE("what the code and the part send, as the descriptor says and more than it says") {
  for (const Case& one : cases()) {
    INFO(one.name);
    const Json honest = run(one, one.truth);
    INFO(honest["buses"].dump());
    CHECK(honest["buses"][0]["traffic"]["judged"] == "held");
    CHECK_FALSE(reports_traffic(honest));
    const Json lying = run(one, one.lie);
    INFO(lying["buses"].dump());
    CHECK(lying["buses"][0]["traffic"]["judged"] == "broken");
    CHECK(reports_traffic(lying));
    CHECK(lying["exit"] == 1);
  }
}

TEST_CASE("one of several phases is enough") {
  const Case one = cases().front();
  const Json lying = run(one, one.lie, {"--phases", "2", "--seed", "3"});
  CHECK(lying["buses"][0]["traffic"]["judged"] == "broken");
  CHECK(lying["exit"] == 1);
}
