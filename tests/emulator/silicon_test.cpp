// Chips that use the freedom their manual leaves: the drivers do not mind, and a mistake that each of them shows is
// seen.
#include <functional>
#include <memory>
#include <set>

#include "catch.hpp"
#include "tests/emulator/faults.hpp"
#include "tests/emulator/fixture.hpp"

using namespace finemote::emulator;
using finemote::test::faults_of;

namespace {

constexpr std::uint64_t kMs = 1'000'000, kSeeds = 8;

BoardOptions strict(const std::vector<Strictness>& ways, std::uint64_t seed) {
  BoardOptions options;
  options.silicon = Silicon(ways, seed);
  return options;
}

bool has_reports(const Board& board) {
  for (const Report& report : board.reports()) UNSCOPED_INFO(name_of(report.misuse) << ": " << report.text);
  return !board.reports().empty();
}

/// What goes wrong with an image on a chip.
using Trouble = std::function<bool(const std::string& image, const BoardOptions&)>;

/// A sender that counts without a pause.
bool ring_trouble(const std::string& image, const BoardOptions& options) {
  Board board{finemote::test::type_c(), options};
  board.load(test_image(image));
  board.run_for(60 * kMs);
  std::vector<std::uint8_t> bytes(20'000);
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>(i % 251);
  board.chip().usart("usart1")->send_in(bytes, SerialFormat{921'600, false, 1});
  board.run_for(1 * kMs);
  board.set_word("wrong", 0);  // what came before the first byte
  board.run_for(250 * kMs);
  return board.word("taken") < 15'000 || board.word("wrong") != 0 || board.word("back") != 0;
}

struct HeardBytes {
  SpiPart part() {
    return SpiPart{[this](bool selected) {
                     if (!selected) return;
                     whole = whole && (heard.empty() || heard.size() == 4);
                     heard.clear();
                   },
                   [this](std::uint8_t byte) {
                     whole = whole && (!heard.empty() || byte == 0x92);
                     heard.push_back(byte);
                     return std::uint8_t{0};
                   }};
  }
  std::vector<int> heard;
  bool whole = true;  ///< every exchange had four bytes and began with the request
};

bool spi_trouble(const std::string& image, const BoardOptions& options) {
  Board board{finemote::test::type_c(), options};
  HeardBytes accelerometer;
  board.chip().attach_spi(*board.chip().spi("spi1"), 'A', 4, accelerometer.part());
  board.load(test_image(image));
  board.run_for(60 * kMs);
  return has_reports(board) || !accelerometer.whole;
}

/// The same, with a stream that breaks in the middle of an exchange; the next one is with the other chip.
bool broken_spi_trouble(const std::string& image, const BoardOptions& options) {
  Board board{finemote::test::type_c(), options};
  HeardBytes accelerometer, gyroscope;
  board.chip().attach_spi(*board.chip().spi("spi1"), 'A', 4, accelerometer.part());
  board.chip().attach_spi(*board.chip().spi("spi1"), 'B', 0, gyroscope.part());
  board.load(test_image(image));
  board.run_for(30 * kMs);
  for (unsigned i = 0; i < 200'000 && accelerometer.heard.size() != 1; ++i) board.run_for(20);
  board.chip().break_dma("spi1", DmaWay::receive);
  board.run_for(5 * kMs);
  return !gyroscope.whole;
}

/// A bus that is lost and comes back.
bool can_trouble(const std::string& image, const BoardOptions& options) {
  Board board{finemote::test::type_c(), options};
  CanLine& line = board.chip().can("can1")->line;
  line.attach(CanLine::Node{[] { return std::nullopt; }, [](const CanFrame&, CanOutcome) {}, [](const CanFrame&) {}});
  board.load(test_image(image));
  board.run_for(60 * kMs);
  line.disturbed_frames = 32;
  board.run_for(60 * kMs);
  constexpr unsigned kRecoveries = 7;  // of tests/emulator/images/can
  return board.word("seen", 4 * kRecoveries) != 1 || board.chip().can("can1")->bus_off();
}

/// As a probe does, so that it stays connected while the core sleeps: DBG_SLEEP in DBGMCU_CR, RM0090 38.16.3.
void keep_debug_clock_on(Board& board) { board.world().system().write(0xE0042004, 4, 1, 0, 0); }

/// The small vehicle does what it should.
bool vehicle_trouble(const std::string& image, const BoardOptions& options) {
  MiniBoard mini(options, image);
  keep_debug_clock_on(mini.board);
  const Stop stop = mini.board.run_for(700 * kMs);
  if (stop != Stop::time || mini.board.resets() != 0 || mini.board.stages().empty()) return true;
  return has_reports(mini.board) || mini.observed(0) != 1 || mini.observed(2) != 1 ||
         std::abs(static_cast<int>(mini.observed(3)) - 250'000) > 10;
}

/// The firmware's time is the world's.
bool time_trouble(const std::string& image, const BoardOptions& options) {
  MiniBoard mini(options, image);
  keep_debug_clock_on(mini.board);
  if (mini.board.run_for(300 * kMs) != Stop::time) return true;
  const auto& events = mini.board.stages();
  return events.size() < 100 || static_cast<double>(events.back().t_ns) < 0.28e9;
}

/// Between jobs the core stays where it waits.
bool idle_trouble(const std::string& image, const BoardOptions& options) {
  MiniBoard mini(options, image);
  keep_debug_clock_on(mini.board);
  mini.board.run_for(100 * kMs);
  const auto idle = test_image(image).symbol("_ZN8finemote9cortex_m44idleEv");
  for (unsigned i = 0; i < 1'000; ++i) {
    if (mini.board.run_for(100'100) != Stop::time) return true;
    const std::uint32_t at = mini.board.cpu().pc() - idle->address;
    if (mini.board.cpu().active_exceptions().empty() && at >= idle->size) return true;
  }
  return false;
}

enum class Plain { is_fine, is_enough };

/// The image without the mistake minds no chip that is so; with it, it minds one at least, and none that is plain,
/// unless that `is_enough` to show it.
void check(const char* name, const char* image, const Trouble& trouble, Plain plain = Plain::is_fine) {
  const std::vector<Strictness> ways = {find_strictness(name)->strictness};
  const std::string mutant = std::string("mutant_") + name;
  INFO(name);
  CHECK(trouble(mutant, {}) == (plain == Plain::is_enough));
  bool caught = false;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    INFO("seed " << seed);
    CHECK(!trouble(image, strict(ways, seed)));
    caught = caught || trouble(mutant, strict(ways, seed));
  }
  CHECK(caught);
}

}  // namespace

TEST_CASE("a chip is as its manual reads unless it is asked to be otherwise") {
  Silicon chip;
  for (const Strictness way : finemote::test::all_ways()) {
    CHECK(!chip.is(way));
    CHECK(chip.draw_or_zero(way) == 0);
  }
}

TEST_CASE("what a chip draws is in the range, reaches its ends, and is the same for the same seed") {
  for (const StrictnessInfo& info : strictnesses()) {
    INFO(info.name);
    REQUIRE(find_strictness(info.name) == &info);
    Silicon chip({info.strictness}, 7), same(finemote::test::all_ways(), 7);
    std::set<std::uint32_t> drawn;
    for (int i = 0; i < 100; ++i) {
      const std::uint32_t value = chip.draw(info.strictness);
      CHECK(value == same.draw(info.strictness));
      drawn.insert(value);
    }
    CHECK(*drawn.begin() == info.least);
    CHECK(*drawn.rbegin() == info.most);
  }
  CHECK(find_strictness("kind") == nullptr);
}

TEST_CASE("a byte that is counted is waited for") { check("dma_store", "ring", ring_trouble); }
TEST_CASE("a count of bytes never steps back") { check("dma_flag", "ring", ring_trouble); }
TEST_CASE("an exchange ends with the last edge of the clock") { check("spi_busy", "spi", spi_trouble); }
TEST_CASE("an exchange that is broken off leaves nothing for the next") {
  check("spi_kept", "spi", broken_spi_trouble);
}
TEST_CASE("the STOP of a one-byte read is in time") { check("i2c_pause", "mini", vehicle_trouble); }
TEST_CASE("a STOP is waited for until it is out") { check("i2c_stop", "mini", vehicle_trouble); }
TEST_CASE("a controller that takes its time to initialise is waited for") { check("can_init", "can", can_trouble); }
TEST_CASE("slow oscillators are waited for") { check("clock_ready", "mini", vehicle_trouble); }
TEST_CASE("the watchdog is fed in time however fast its clock is") { check("clock_rates", "mini", vehicle_trouble); }
TEST_CASE("time goes on while nothing runs") { check("cycle_count", "mini", time_trouble); }
TEST_CASE("no instruction is lost between jobs") { check("wake_up", "mini", idle_trouble); }
TEST_CASE("noise before the first frame is passed over") { check("first_bytes", "mini", vehicle_trouble); }
TEST_CASE("nothing is expected of memory at power-on") {
  check("ram_pattern", "mini", vehicle_trouble, Plain::is_enough);  // a plain chip's is not zero either
}

TEST_CASE("a wait for a chip that is worse than so ends by its limit, and is counted") {
  const auto worse = [](Strictness way) {
    BoardOptions options = strict({way}, 0);
    options.silicon.exceed(way);
    return options;
  };
  constexpr unsigned kSpi = 6 * 256, kCan = 7 * 256;
  {
    Board board{finemote::test::type_c(), worse(Strictness::spi_busy)};
    board.load(test_image("spi"));
    board.run_for(60 * kMs);
    CHECK(faults_of(board) == std::set<unsigned>{kSpi + 17});
    CHECK(board.word("done", 0) >= 50);
  }
  {
    Board board{finemote::test::type_c(), worse(Strictness::can_init)};
    board.load(test_image("can"));
    board.run_for(200 * kMs);
    CHECK(faults_of(board) == std::set<unsigned>{kCan + 16});
    CHECK(board.word("seen", 16) >= 100);
    CHECK(board.resets() == 0);
  }
  {
    Board board{finemote::test::type_c(), worse(Strictness::clock_ready)};
    board.load(test_image("sample"));
    board.run_for(400 * kMs);
    CHECK(board.chip().rcc.core_hz() == 16'000'000);
    CHECK(board.stages().empty());
  }
}

TEST_CASE("the drivers mind no chip that is strict in every way") {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    INFO("seed " << seed);
    const BoardOptions options = strict(finemote::test::all_ways(), seed);
    CHECK(!vehicle_trouble("mini", options));
    CHECK(!spi_trouble("spi", options));
    CHECK(!ring_trouble("ring", options));
    CHECK(!can_trouble("can", options));
    MiniBoard mini(options);
    mini.board.run_for(100 * kMs);
    CHECK(faults_of(mini.board) == std::set<unsigned>{});
  }
}
