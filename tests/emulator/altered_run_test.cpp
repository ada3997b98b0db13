// The job that `run` gives to the emulated board, given once more with one thing altered, or looked into: assumptions
// of docs/timing.md that no device and no scenario can break.
#include <algorithm>

#include "emulator/program/job.hpp"
#include "tests/emulator/probe_robot.hpp"

using namespace finemote::test;
using finemote::emulator::Board;
using finemote::emulator::from_ns;
using finemote::emulator::run_job;
using Json = nlohmann::ordered_json;

namespace {

/// A robot that was built and ran, and is kept.
struct Kept {
  explicit Kept(const std::string& robot) {
    const auto ran = run_finemote({"run", robot, "--monitor", "--duration", "100ms", "--keep", folder.path()});
    INFO(ran.output);
    const std::string file = folder.path("build/firmware.elf.job.json");
    REQUIRE(std::filesystem::exists(file));
    job = Json::parse(read_file(file));
  }
  TemporaryFolder folder;
  Json job;
};

/// Nothing was counted, neither as a fault nor as an overrun, nor did the monitor see a bound exceeded.
bool counts_nothing(const Json& record) {
  REQUIRE(record["stop"].is_null());
  REQUIRE(!record["overruns"].empty());
  REQUIRE(!record["monitor"].empty());
  bool nothing = record["fault_counts"].empty() && record["resets"] == 0;
  for (const Json& overruns : record["overruns"]) nothing = nothing && overruns == 0;
  for (const Json& device : record["monitor"]) nothing = nothing && device[2] == 0 && device[3] == 0;
  return nothing;
}

/// From one start of a stage to the next [ns].
std::int64_t longest_interval(const Json& record, unsigned stage) {
  std::int64_t last = -1, longest = 0;
  for (const Json& event : record["stages"]) {
    if (event[1] != stage || event[2] == false) continue;
    const std::int64_t at = event[0];
    if (last >= 0) longest = std::max(longest, at - last);
    last = at;
  }
  return longest;
}

/// Of a routine, without what comes in between [ps].
std::int64_t longest_exception(const Json& record, int exception) {
  for (const Json& own : record["own_exceptions"]) {
    if (own[0] == exception) return own[1];
  }
  FAIL("exception " << exception << " did not come");
  return 0;
}

/// What was seen of the chip's registers, every 50 us from power-on on.
struct Seen {
  unsigned streams_on = 0;  ///< how often one was on
  bool bursts = false, masters = false, open_flash = false;
};

constexpr std::uint32_t kAhb1 = 0x40023830, kAhb2 = 0x40023834, kAhb3 = 0x40023838;  // RM0090 7.3.10 to 7.3.12
/// Ethernet, USB OTG HS and DMA2D; the camera, cryptography and USB OTG FS; external memory.
constexpr std::uint32_t kMasters1 = 0x7E800000, kMasters2 = 0xB1, kMasters3 = 1;
constexpr std::uint32_t kFlashCr = 0x40023C10, kLocked = 1U << 31;  // 3.9.6

/// SxCR: PBURST and MBURST; SxFCR: DMDIS, direct mode off. RM0090 10.5.5, 10.5.10.
void look_at_streams(Board& board, Seen& seen) {
  const std::uint32_t clocks = board.chip().read(kAhb1, 4);
  for (unsigned controller = 0; controller < 2; ++controller) {
    if ((clocks >> (21 + controller) & 1) == 0) continue;
    for (std::uint32_t stream = 0; stream < 8; ++stream) {
      const std::uint32_t at = 0x40026010 + 0x400 * controller + 0x18 * stream;
      const std::uint32_t control = board.chip().read(at, 4);
      seen.streams_on += control & 1;
      seen.bursts = seen.bursts || (control & 0x01E00000) != 0 || (board.chip().read(at + 0x14, 4) & 4) != 0;
    }
  }
}

void look(Board& board, Seen& seen) {
  look_at_streams(board, seen);
  auto& chip = board.chip();
  seen.masters = seen.masters || (chip.read(kAhb1, 4) & kMasters1) != 0 || (chip.read(kAhb2, 4) & kMasters2) != 0 ||
                 (chip.read(kAhb3, 4) & kMasters3) != 0;
  seen.open_flash = seen.open_flash || chip.read(kFlashCr, 4) != kLocked;
  board.world().after(from_ns(50'000), [&] { look(board, seen); });
}

Seen registers_of(const std::string& robot) {
  const Kept kept(robot);
  Seen seen;
  const Json record = run_job(kept.job, [&](Board& board) { look(board, seen); });
  CHECK(record["stop"].is_null());
  return seen;
}

}  // namespace

TEST_CASE("board-clock: with a crystal that is 2 % slow all is late by the true time, and nothing is counted") {
  const Kept kept(source_path("examples/two_devices.urdf"));
  Json slow = kept.job;
  slow["board"]["clocks"]["crystal_hz"] = 11'760'000;
  const Json right = run_job(kept.job), wrong = run_job(slow);
  CHECK(longest_interval(right, 0) <= 5'000'250);  // 5 ms, and 50 ppm
  CHECK(longest_interval(wrong, 0) > 5'100'000);
  CHECK(counts_nothing(right));
  CHECK(counts_nothing(wrong));
  CHECK(wrong["monitor"] == right["monitor"]);  // in its own time nothing has changed
}

TEST_CASE("compiler: an image of other options takes longer, and does not know") {
  const Kept kept(source_path("examples/two_devices.urdf"));
  const Json shipped = run_job(kept.job);
  const std::string project = kept.folder.path("CMakeLists.txt");
  std::string text = read_file(project);
  const auto end = text.rfind(')');
  REQUIRE(end != std::string::npos);
  write_file(project, text.insert(end, " OPTIMIZE -Og"));
  const auto built =
      finemote::gen::run_process({"cmake", "--build", kept.folder.path("build")}, std::chrono::seconds(200));
  INFO(built.output);
  REQUIRE(built.exit_status == 0);
  const Json other = run_job(kept.job);
  constexpr int kRelease = 15;
  CHECK(longest_exception(other, kRelease) > longest_exception(shipped, kRelease) * 11 / 10);
  CHECK(counts_nothing(shipped));
  CHECK(counts_nothing(other));
}

TEST_CASE("dma-beats, bus-masters, flash-write: the runtime moves single items, and leaves masters and flash alone") {
  // The robots of all device types, as in scenarios_test.
  for (const char* robot : {"rover", "rig", "crane"}) {
    INFO(robot);
    const Seen seen = registers_of(source_path("tests/emulator/robots/" + std::string(robot) + ".urdf"));
    CHECK(seen.streams_on > 100);
    CHECK_FALSE(seen.bursts);
    CHECK_FALSE(seen.masters);
    CHECK_FALSE(seen.open_flash);
  }
}

TEST_CASE("bus-masters, flash-write: a device that does otherwise would have shown there") {
  CHECK(registers_of(ProbeRobot("at(0x40023830) = at(0x40023830) | 1U << 25;", 40'000, kUrgentDevice).path()).masters);
  CHECK(registers_of(
            ProbeRobot("at(0x40023C04) = 0x45670123; at(0x40023C04) = 0xCDEF89AB;", 40'000, kUrgentDevice).path())
            .open_flash);
}

TEST_CASE("dma-beats: a device's own stream moves bursts, and nobody notices") {
  // Memory to memory by stream 0 of the second controller, four words at a time on both sides; what did not arrive
  // would be a fault.
  const std::string update = R"(at(0x40023830) = at(0x40023830) | 1U << 22;
    if (count > 1 && target[7] != source[7]) finemote::count_fault(finemote::Module::device, 7);
    for (std::uint32_t& word : source) word = count;
    at(0x40026408) = 0x3D;
    at(0x40026418) = reinterpret_cast<std::uint32_t>(source);
    at(0x4002641C) = reinterpret_cast<std::uint32_t>(target);
    at(0x40026414) = 8;
    at(0x40026424) = 7;
    at(0x40026410) = 1U << 23 | 1U << 21 | 2U << 13 | 2U << 11 | 3U << 9 | 2U << 6 | 1;)";
  const ProbeRobot robot(update, 40'000, kUrgentDevice);
  const ProbeRun ran = robot.run();
  CHECK(ran.exit_status == 0);
  CHECK(ran.counts_nothing());
  CHECK_FALSE(ran.reports("FM6005"));
  CHECK(registers_of(robot.path()).bursts);
}
