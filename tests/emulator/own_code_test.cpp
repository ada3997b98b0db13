// What happens where the code of a user's device breaks an assumption of docs/timing.md, or the robot does: what the
// firmware counts, what a run says, and what nobody notices.
#include <algorithm>
#include <map>
#include <sstream>

#include "tests/emulator/probe_robot.hpp"

using namespace finemote::test;
using Json = nlohmann::json;

namespace {

/// `text` with interrupts kept out between its `MASK` and `FREE`, or not.
std::string masking(std::string text, bool masks) {
  text.replace(text.find("MASK"), 4, masks ? R"(asm volatile("cpsid i" ::: "memory");)" : ";");
  text.replace(text.find("FREE"), 4, masks ? R"(asm volatile("cpsie i" ::: "memory");)" : ";");
  return text;
}

/// Opens the flash for writing, in the fifth update: RM0090 3.5.1, 3.9.
std::string writing_flash(const std::string& then) {
  return "if (count != 5) return; at(0x40023C04) = 0x45670123; at(0x40023C04) = 0xCDEF89AB;" + then;
}
const std::string kErase = writing_flash("at(0x40023C10) = 0x00010000 | 2U << 8 | 11U << 3 | 2;");  // the last sector
const std::string kProgram = writing_flash("at(0x40023C10) = 2U << 8 | 1; at(0x080E0000) = 0;");    // a word of it

/// How often each stage ran, and its longest own time [ns]: when it began hangs on how long the start took.
std::vector<std::pair<std::int64_t, std::int64_t>> own_times(const ProbeRun& run) {
  std::vector<std::pair<std::int64_t, std::int64_t>> all;
  for (const auto& stage : run.document["stages"]) all.emplace_back(stage["count"], stage["own_max_ns"]);
  return all;
}

/// How long the probe's update took by itself [ns].
std::int64_t longest_update(const ProbeRun& run) { return run.of("stages", "p")["own_max_ns"]; }

Json wire_of(const ProbeRun& run, const std::string& device) {
  for (const Json& chain : run.document["chains"]) {
    if (chain["to"] == device) return chain["wire"];
  }
  FAIL("no chain to " << device);
  return {};
}

}  // namespace

TEST_CASE("masked-sections: a job that is released meanwhile is late, and the monitor counts that") {
  const std::string update = "spin(24000); MASK spin(16000); FREE";  // over the next release
  const ProbeRun quiet = ProbeRobot(masking(update, false), 1'500'000, kUrgentDevice).run();
  CHECK(quiet.exit_status == 0);
  CHECK(quiet.counts_nothing());
  CHECK(quiet.of("responses", "urgent")["judged"] == "held");
  const ProbeRun loud = ProbeRobot(masking(update, true), 1'500'000, kUrgentDevice).run();
  CHECK(loud.exit_status == 1);
  CHECK(loud.document["fault_counts"].empty());
  CHECK(loud.document["overruns"] == 0);
  CHECK(loud.of("responses", "urgent")["judged"] == "broken");
  CHECK(loud.of("monitor", "urgent")["response_violations"] > 0);
  CHECK(loud.of("responses", "p")["judged"] == "held");  // whoever did it has no bound that is broken
  CHECK(loud.of("monitor", "p")["response_violations"] == 0);
  CHECK_FALSE(loud.reports("FM6006"));
}

TEST_CASE("masked-sections: an output that waits for its interrupts is late, and nothing counts that") {
  const std::string update = "for (int k = 0; k < 20; ++k) { MASK spin(5000); FREE spin(50); }";
  const std::string output = R"(<bus name="i2c" type="i2c" port="i2c2" clock="400kHz"/>
    <expander name="pwm" model="pca9685" bus="i2c" address="0x41"/>
    <device name="fast" type="sway" period="8ms"><device name="left" type="pwm_servo" bus="pwm" channel="4"/></device>)";
  const ProbeRun quiet = ProbeRobot(masking(update, false), 3'500'000, output).run();
  CHECK(wire_of(quiet, "left")["judged"] == "held");
  const ProbeRun loud = ProbeRobot(masking(update, true), 3'500'000, output).run();
  CHECK(wire_of(loud, "left")["judged"] == "broken");
  CHECK(loud.exit_status == 1);
  CHECK(loud.counts_nothing());
}

TEST_CASE("masked-sections: one that keeps the release out for longer than the watchdog waits restarts the board") {
  const std::string update = "if (count == 5) { MASK spin(400000); FREE }";
  CHECK(ProbeRobot(masking(update, false), 15'000'000, kUrgentDevice).run().counts_nothing());
  const ProbeRun loud = ProbeRobot(masking(update, true), 15'000'000, kUrgentDevice).run();
  CHECK(loud.exit_status == 1);
  CHECK(loud.document["resets"] > 0);
  CHECK(loud.counts_only("board", 6, 1));
}

TEST_CASE("flash-write: an erased sector makes the watchdog restart code in flash") {
  const ProbeRun in_flash = ProbeRobot(kErase, 400'000, kUrgentDevice, "flash").run();
  CHECK(in_flash.exit_status == 1);
  CHECK(in_flash.document["resets"] == 1);
  CHECK(in_flash.document["fault_counts"].empty());  // the start that counts it waits for the flash until the end
  const ProbeRun in_sram = ProbeRobot(kErase, 400'000, kUrgentDevice).run();
  CHECK(in_sram.exit_status == 0);
  CHECK(in_sram.counts_nothing());
}

TEST_CASE("flash-write: a programmed word takes time, and nobody notices") {
  const ProbeRun in_flash = ProbeRobot(kProgram, 400'000, kUrgentDevice, "flash").run();
  CHECK(in_flash.exit_status == 0);
  CHECK(in_flash.counts_nothing());
  CHECK(longest_update(in_flash) > 16'000);  // DS8626 5.3.12
  const ProbeRun in_sram = ProbeRobot(kProgram, 400'000, kUrgentDevice).run();
  CHECK(in_sram.counts_nothing());
  CHECK(longest_update(in_sram) < 1'000);
}

TEST_CASE(
    "flash: what is missed takes longer than was declared, which a run sees and the monitor where a job is late") {
  const std::string update =
      "for (int i = 0; i < 300; ++i) { if ((count + i) % 2 == 0) { spin(9); } else { spin(4); spin(5); } }";
  const std::string roomy = R"(<device name="urgent" type="sim_load" period="1ms">
  <param name="update">20us</param> <param name="handle">5us</param> <wcet update="100us" handle="30us"/></device>)";
  const ProbeRobot in_flash(update, 400'000, roomy, "flash"), in_sram(update, 400'000, roomy);
  const auto hit = in_flash.run(), miss = in_flash.run({"--flash", "miss"});
  CHECK(hit.exit_status == 0);
  CHECK(miss.counts_nothing());
  CHECK(miss.of("responses", "urgent")["update_max_ns"] > hit.of("responses", "urgent")["update_max_ns"]);
  CHECK(own_times(in_sram.run()) == own_times(in_sram.run({"--flash", "miss"})));
  // Declared as it was measured where every fetch hits.
  const std::int64_t measured = longest_update(hit);
  const ProbeRobot tight(update, static_cast<int>(measured) + 1, kUrgentDevice, "flash");
  CHECK(tight.run().exit_status == 0);
  const ProbeRun late = tight.run({"--flash", "miss"});
  CHECK(late.exit_status == 1);
  CHECK(late.reports("FM6006", "'p'"));
  CHECK(late.document["fault_counts"].empty());
  CHECK(late.document["overruns"] == 0);
  CHECK(late.of("responses", "p")["judged"] == "broken");
  CHECK(late.of("monitor", "p")["response_violations"] > 0);
}

TEST_CASE("bus-masters: a peripheral that a device switches on is not noticed") {
  const std::string clock = "at(0x40023830) = at(0x40023830) | 1U << 25;";  // Ethernet: RM0090 7.3.10
  const ProbeRun on = ProbeRobot(clock, 40'000, kUrgentDevice).run();
  CHECK(on.exit_status == 0);
  CHECK(on.counts_nothing());
  CHECK_FALSE(on.reports("FM6005"));
  // The emulated board has no Ethernet and says so; the firmware does not.
  const ProbeRun used = ProbeRobot(clock + "at(0x40028000) = 1;", 40'000, kUrgentDevice).run();
  CHECK(used.exit_status == 0);
  CHECK(used.counts_nothing());
  CHECK(used.reports("FM6005", "0x40028000"));
}

TEST_CASE("bring-up: the first commands come out later than their bound, and nothing counts or judges them") {
  const TemporaryFolder folder;
  const Json run = finemote_json({"run", source_path("tests/emulator/bounds/bring_up.urdf"), "--monitor", "--duration",
                                  "200ms", "--audit", folder.path("audit.jsonl")});
  std::istringstream lines(read_file(folder.path("audit.jsonl")));
  std::map<std::string, std::size_t> handle_of;
  std::map<std::size_t, std::vector<std::int64_t>> ends;
  std::map<std::string, std::int64_t> before, after;  // longest way of a command, by device [ps]
  const std::int64_t ready = run["bringup_ns"].get<std::int64_t>() * 1000;
  for (std::string line; std::getline(lines, line);) {
    const Json event = Json::parse(line);
    const std::string what = event["what"];
    for (std::size_t k = 0; what == "robot" && k < event["stages"].size(); ++k) {
      if (event["stages"][k]["stage"] == "handle") handle_of[event["stages"][k]["device"]] = k;
    }
    if (what == "end") ends[event["stage"]].push_back(event["t"]);
    if ((what != "output" && what != "superseded") || event["job"].is_null()) continue;
    const std::int64_t began = ends[handle_of[event["device"]]].at(event["job"]);
    std::int64_t& longest = (began < ready ? before : after)[event["device"]];
    longest = std::max(longest, event["t"].get<std::int64_t>() - began);
  }
  CHECK(run["fault_counts"].empty());
  CHECK(run["overruns"] == 0);
  REQUIRE(!run["monitor"].empty());
  REQUIRE(!run["chains"].empty());
  for (const Json& device : run["monitor"]) CHECK(device["response_violations"] == 0);
  for (const Json& chain : run["chains"]) {
    const std::int64_t bound = chain["wire"]["bound_ns"].get<std::int64_t>() * 1000;
    INFO(chain.dump());
    CHECK(before[chain["to"]] > bound);
    CHECK(after[chain["to"]] <= bound);
    CHECK(chain["wire"]["judged"] == "held");
  }
}

TEST_CASE("kinds of faults that find no room in the firmware's table are counted together") {
  const std::string update =
      "if (count == 5) for (unsigned char kind = 1; kind <= 18; ++kind) "
      "finemote::count_fault(finemote::Module::device, kind);";
  const ProbeRun run = ProbeRobot(update, 400'000, kUrgentDevice).run();
  CHECK(run.exit_status == 1);
  const auto counts = run.document["fault_counts"];
  REQUIRE(counts.size() == 17);
  CHECK(counts.back() == nlohmann::json{{"module", "other"}, {"code", 0}, {"count", 2}});
}
