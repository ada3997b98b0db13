// Whole robots on the emulated board: what their updates took, and which commands their outputs carry, as the record of
// a run has it.
#include <filesystem>
#include <map>

#include "catch.hpp"
#include "tests/cli/program.hpp"

using namespace finemote::test;

namespace {

using Json = nlohmann::json;
using Numbers = std::vector<std::uint32_t>;

struct Event {
  std::int64_t from_ps, at_ps;
};

/// The record of a run, by what it is about.
struct Record {
  using Channel = std::pair<std::string, unsigned>;

  /// @param robot  its file
  Record(const std::string& robot, const std::string& duration, const std::string& scenario = {}) {
    const TemporaryFolder folder;
    std::vector<std::string> words = {"run", robot, "--duration", duration, "--keep", folder.path("kept")};
    if (!scenario.empty()) {
      write_file(folder.path("scenario.json"), scenario);
      words.insert(words.end(), {"--scenario", folder.path("scenario.json")});
    }
    const auto ran = run_finemote(words);
    INFO(ran.output);
    REQUIRE(ran.exit_status <= 1);  // 1: a bound does not hold
    const Json json = Json::parse(read_file(folder.path("kept/build/firmware.elf.record.json")));
    for (const Json& event : json["parts"]) read(event);
    for (const Json& stage : json["stages"]) {
      if (stage[2] == true) begins[stage[1]].push_back(stage[0].get<std::int64_t>() * 1000);
    }
    for (const Json& use : json["uses"]) uses[{use[2], use[3]}][use[1]].push_back({use[0], use[4]});
  }

  std::map<Channel, std::map<std::uint32_t, Event>> samples;  ///< by number
  struct Output {
    std::int64_t at_ps;
    std::uint32_t stage, n;
  };
  std::map<Channel, std::vector<Output>> outputs;  ///< those that carry a command
  struct Use {
    std::int64_t at_ps;
    std::uint32_t n;
  };
  std::map<Channel, std::map<std::uint32_t, std::vector<Use>>> uses;  ///< by stage
  std::map<std::uint32_t, std::vector<std::int64_t>> begins;          ///< of stages

 private:
  void read(const Json& event) {
    const Channel channel{event["part"], event["channel"]};
    if (event["output"] == false) {
      samples[channel][event["n"]] = {event["from_ps"], event["at_ps"]};
    } else if (!event["stage"].is_null()) {
      outputs[channel].push_back({event["at_ps"], event["stage"], event["n"]});
    }
  }
};

std::string example(const std::string& name) { return source_path("examples/" + name + ".urdf"); }

/// Every update takes samples that could be read, in their order. @return how old they are at most at its end [us]
std::int64_t oldest_us(const Record& record, const Record::Channel& channel, std::uint32_t stage) {
  INFO(channel.first << " " << channel.second << " in stage " << stage);
  const auto& uses = record.uses.at(channel).at(stage);
  std::int64_t oldest = 0;
  std::uint32_t last = 0;
  bool all_are_known = true, all_could_be_read = true, all_in_order = true;
  for (const Record::Use& use : uses) {
    const auto& samples = record.samples.at(channel);
    const auto sample = samples.find(use.n);
    all_are_known = all_are_known && sample != samples.end();
    if (sample == samples.end()) continue;
    all_could_be_read = all_could_be_read && sample->second.at_ps <= use.at_ps;
    all_in_order = all_in_order && use.n >= last;
    last = use.n;
    oldest = std::max(oldest, (use.at_ps - sample->second.from_ps) / 1'000'000);
  }
  CHECK(uses.size() > 10);
  CHECK(all_are_known);
  CHECK(all_could_be_read);
  CHECK(all_in_order);
  return oldest;
}

/// Commands of one handle come in the order they were made, none before it was. @return how many of its runs came
std::size_t check_output(const Record& record, const Record::Channel& channel) {
  INFO(channel.first << " " << channel.second);
  const auto& outputs = record.outputs.at(channel);
  const std::vector<std::int64_t>& begins = record.begins.at(outputs.front().stage);
  std::uint32_t last = 0;
  std::size_t runs = 1;
  bool is_one_handle = true, in_order = true, is_later = true;
  for (const Record::Output& output : outputs) {
    is_one_handle = is_one_handle && output.stage == outputs.front().stage && output.stage % 2 == 1;
    in_order = in_order && output.n >= last;
    runs += output.n > last ? 1 : 0;
    last = output.n;
    is_later = is_later && output.n < begins.size() && begins[output.n] <= output.at_ps;
  }
  CHECK(is_one_handle);
  CHECK(in_order);
  CHECK(is_later);
  return runs;
}

/// Every command but the last comes out, which the end of the run may cut off. @param least  runs of the handle
void check_all_arrive(const Record& record, const Record::Channel& channel, std::size_t least) {
  const std::size_t commands = record.begins.at(record.outputs.at(channel).front().stage).size();
  CHECK(commands >= least);
  CHECK(check_output(record, channel) + 1 >= commands);
}

}  // namespace

TEST_CASE("on the infantry every update takes the newest report, and every command arrives") {
  const Record record(example("infantry"), "500ms");
  CHECK(oldest_us(record, {"imu", 0}, 0) < 2'500);  // sampled and read once a millisecond
  CHECK(oldest_us(record, {"imu", 1}, 0) < 2'750);  // sampled every 1.25 ms
  CHECK(oldest_us(record, {"yaw", 0}, 2) < 1'500);  // a report a millisecond
  CHECK(oldest_us(record, {"pitch", 0}, 4) < 1'500);
  CHECK(oldest_us(record, {"front_left", 0}, 8) < 1'500);
  CHECK(oldest_us(record, {"remote", 0}, 18) < 30'000);  // a frame every 14 ms
  check_all_arrive(record, {"yaw", 0}, 500);
  check_all_arrive(record, {"pitch", 0}, 500);
  for (const char* wheel : {"front_left", "front_right", "rear_left", "rear_right"})
    check_all_arrive(record, {wheel, 0}, 100);
}

TEST_CASE("on the arm every joint's command arrives, though they share frames") {
  const Record record(example("six_joint_arm"), "500ms");
  for (const char* joint : {"base", "shoulder", "elbow", "wrist_roll", "wrist_pitch", "flange"})
    check_all_arrive(record, {joint, 0}, 250);
  CHECK(oldest_us(record, {"base", 0}, 2) < 1'500);
}

TEST_CASE("on the underwater vehicle a pressure is as old as its conversion, a pulse as new as its burst") {
  const Record record(example("finsrov"), "1s", R"({"schema": "finemote.scenario/1", "events": [
    {"t_ns": 100000000, "part": "rov.host", "do": "send", "text": "ON"},
    {"t_ns": 200000000, "part": "rov.host", "do": "send", "text": "H:800"}]})");
  CHECK(oldest_us(record, {"imu", 0}, 0) < 12'000);
  CHECK(oldest_us(record, {"baro_1", 0}, 2) < 35'000);
  CHECK(oldest_us(record, {"baro_4", 0}, 8) < 35'000);
  std::size_t moved = 0;
  for (unsigned channel = 0; channel < 8; ++channel) moved += check_output(record, {"pwm", channel}) > 20 ? 1 : 0;
  CHECK(moved >= 4);
}

TEST_CASE("a sensor that falls silent leaves its updates with the sample they have, and so does a damaged report") {
  const Record record(example("infantry"), "300ms", R"({"schema": "finemote.scenario/1", "events": [
    {"t_ns": 100000000, "part": "yaw", "do": "silent"},
    {"t_ns": 100000000, "part": "pitch", "do": "damage", "frames": 1000}]})");
  for (const auto& [part, stage] : {std::pair("yaw", 2U), std::pair("pitch", 4U)}) {
    INFO(part);
    const auto& uses = record.uses.at({part, 0}).at(stage);
    const auto last = uses.back();
    CHECK(last.at_ps > 290'000'000'000);
    CHECK(record.samples.at({part, 0}).at(last.n).from_ps < 101'000'000'000);
  }
}

namespace {

const char* const kStaleDescriptor = R"({
  "schema": "finemote.device/1", "type": "stale", "summary": "reads its part now and then, and says it always did",
  "class": "my::Stale", "header": "stale.hpp",
  "bus": { "types": ["i2c"], "address": { "default": "0x0e" }, "max_clock_hz": 400000 },
  "provides": [{ "interface": "Magnetometer" }],
  "acquisition": { "model": "polled", "periods": 1, "latency_ns": 6000000 },
  "frames": [{ "stage": "update", "write": 2, "read": 6 }],
  "wcet": { "update_ns": 20000, "handle_ns": 1000 },
  "emulation": { "part": "ist8310" }
})";

const char* const kStaleDevice = R"(#pragma once
#include "finemote/contract.hpp"
#include "finemote/i2c.hpp"
#include "finemote/interfaces/magnetometer.hpp"
namespace my {
class Stale {
 public:
  explicit constexpr Stale(finemote::I2cSlot& slot) : slot_(&slot) {}
  void update() {
    state.field[0] = static_cast<float>(reply_[0] | reply_[1] << 8);
    state.origin = finemote::now();
    state.valid = true;
    if (slot_->busy() || count_++ % 8 != 1) return;
    command_[0] = 0x0A;
    command_[1] = 0x0B;
    started_ ? slot_->start(&data_, 1, reply_, 6) : slot_->start(command_, 2);
    started_ = true;
  }
  void handle() {}
  finemote::MagnetometerState state;

 private:
  finemote::I2cSlot* slot_;
  bool started_ = false;
  unsigned count_ = 0;
  std::uint8_t command_[2]{}, data_ = 3, reply_[6]{};
};
}  // namespace my
)";

const char* const kStaleRobot = R"(<?xml version="1.0"?>
<robot name="stale"><link name="base_link"/>
  <finemote version="1">
    <board name="robomaster_type_c"/>
    <bus name="i2c" type="i2c" port="i2c3" clock="400kHz"/>
    <device name="group" type="group" period="10ms"><device name="stale" type="stale" bus="i2c"/></device>
  </finemote>
</robot>
)";

}  // namespace

TEST_CASE("a device that publishes an old sample once more, with a new stamp, is seen") {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path("devices"));
  write_file(folder.path("devices/stale.json"), kStaleDescriptor);
  write_file(folder.path("devices/stale.hpp"), kStaleDevice);
  write_file(folder.path("robot.urdf"), kStaleRobot);
  const Record record(folder.path("robot.urdf"), "800ms");
  // It reads every 80 ms, and says every 10 ms that it did.
  CHECK(oldest_us(record, {"stale", 0}, 0) > 75'000);
  std::map<std::uint32_t, std::size_t> updates;
  for (const Record::Use& use : record.uses.at({"stale", 0}).at(0)) ++updates[use.n];
  REQUIRE(updates.size() > 5);
  for (const auto& [n, count] : updates) CHECK((count == 8 || n == updates.rbegin()->first));

  const auto ran = run_finemote({"run", folder.path("robot.urdf"), "--duration", "800ms"});
  CHECK(ran.exit_status == 1);
  CHECK(ran.output.find("\nFALSE TIME STAMP: 'stale' claims data up to ") != std::string::npos);
  const Json claim = finemote_json({"run", folder.path("robot.urdf"), "--duration", "800ms"})["claims"].at(0);
  CHECK(claim["judged"] == "broken");
  CHECK(claim["lead_max_ns"] > 75'000'000);
}
