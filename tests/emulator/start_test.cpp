// The image's start on the board: clocks from the crystal, what happens without one, the watchdog, determinism.
#include <cstring>

#include "catch.hpp"
#include "tests/emulator/fixture.hpp"
#include "tests/emulator/tested_chip.hpp"
#include "tests/emulator/type_c.hpp"

using namespace finemote::emulator;

namespace {

void check_no_reports(Board& board) {
  for (const Report& report : board.reports()) {
    INFO(name_of(report.misuse) << ": " << report.text);
    CHECK(false);
  }
}

/// How often RAM holds this word.
/// Record of the fault table: module board, the fault, counted once.
constexpr std::uint32_t kWatchdogCounted = 12U << 24 | 6U << 16 | 1, kBrownOutCounted = 12U << 24 | 7U << 16 | 1;
constexpr std::uint32_t kResetFlags = 0x7FU << 25;  // RCC_CSR

unsigned words_in_ram(Board& board, std::uint32_t wanted) {
  unsigned count = 0;
  const std::uint8_t* ram = board.cpu().memory(0x20000000, 0x20000);
  for (std::size_t at = 0; at < 0x20000; at += 4) {
    std::uint32_t word = 0;
    std::memcpy(&word, ram + at, 4);
    count += word == wanted ? 1 : 0;
  }
  return count;
}

void run_until_counted(Board& board, std::uint32_t fault) {
  for (int ms = 0; ms < 100 && words_in_ram(board, fault) == 0; ++ms) board.run_for(1'000'000);
}

}  // namespace

TEST_CASE("the image brings the chip to 168 MHz from the crystal, with five wait states") {
  Board board{finemote::test::type_c(), finemote::test::tested_chip()};
  board.load(test_image("sample"));
  finemote::test::run_to_first_release(board);
  CHECK(board.chip().rcc.core_hz() == 168'000'000);
  CHECK(board.chip().rcc.apb1_hz() == 42'000'000);
  CHECK(board.chip().rcc.apb2_hz() == 84'000'000);
  CHECK(board.chip().flash.wait_states() == 5);
  check_no_reports(board);
}

TEST_CASE("an image that a boot loader starts has its own vectors") {
  Board board{finemote::test::type_c(), finemote::test::tested_chip()};
  board.load(test_image("sample"));
  constexpr std::uint32_t kVectorTable = 0xE000ED08, kSystemMemory = 0x1FFF0000;
  board.world().system().write(kVectorTable, 4, kSystemMemory, 0, 0);
  REQUIRE(board.run_for(50'000'000) == Stop::time);
  CHECK(board.world().system().vector_table() == 0x08000000);
  CHECK(!board.stages().empty());
  check_no_reports(board);
}

TEST_CASE("an image that a boot loader starts takes nothing from it: neither its clock nor its interrupts") {
  Board board{finemote::test::type_c(), finemote::test::tested_chip()};
  board.load(test_image("sample"));
  auto& system = board.world().system();
  auto& chip = board.chip();
  constexpr std::uint32_t kRcc = 0x40023800, kFlashAccess = 0x40023C00;
  chip.write(kFlashAccess, 4, 5);
  chip.write(kRcc + 0x04, 4, 8 | 84 << 6 | 4 << 24);  // of the HSI: 16 MHz / 8 * 84 / 2 = 84 MHz
  chip.write(kRcc, 4, 1 | 1 << 24);
  chip.write(kRcc + 0x08, 4, 4 << 10 | 2);
  system.write(0xE000E100, 4, 1U << 28, 0, 0);  // TIM2 is enabled
  REQUIRE(board.run_for(50'000'000) == Stop::time);
  CHECK(chip.rcc.core_hz() == 168'000'000);
  system.write(0xE000E200, 4, 1U << 28, 0, 0);  // and asks
  const std::size_t stages = board.stages().size();
  REQUIRE(board.run_for(20'000'000) == Stop::time);
  CHECK(board.stages().size() > stages + 10);
  check_no_reports(board);
}

TEST_CASE("a chip of revision A gets no prefetch") {
  for (const bool is_old : {false, true}) {
    Board board{finemote::test::type_c(), finemote::test::tested_chip()};
    if (is_old) board.world().system().device_id = 0x20006411;
    board.load(test_image("sample"));
    finemote::test::run_to_first_release(board);
    CHECK((board.chip().read(0x40023C00, 4) & 1U << 8) == (is_old ? 0 : 1U << 8));
  }
}

TEST_CASE("the watchdog stands still while a debugger holds the core") {
  Board board{finemote::test::type_c(), finemote::test::tested_chip()};
  board.load(test_image("sample"));
  finemote::test::run_to_first_release(board);
  CHECK((board.world().system().frozen_in_debug() & 1U << 12) != 0);
}

TEST_CASE("without its crystal the board stops safely within 200 ms and runs no stage") {
  Board board{finemote::test::type_c(), finemote::test::tested_chip()};
  board.chip().rcc.dead_crystal = true;
  board.load(test_image("sample"));
  REQUIRE(board.run_for(200'000'000) == Stop::time);
  CHECK(board.chip().rcc.core_hz() == 16'000'000);
  CHECK(board.stages().empty());
}

TEST_CASE("stages run in the order of the schedule, the fast bucket preempting the slow one") {
  Board board{finemote::test::type_c(), finemote::test::tested_chip()};
  board.load(test_image("sample"));
  REQUIRE(board.run_for(50'000'000) == Stop::time);
  const auto& events = board.stages();
  REQUIRE(events.size() > 20);
  CHECK(board.lost_stage_events() == 0);
  // 0, 1: the 5 ms device; 2 to 7: three 10 ms devices; the handle of the root is preempted at 5 ms.
  const unsigned expected[] = {0, 0, 1, 1, 2, 2, 4, 4, 6, 6, 7, 0, 0, 1, 1, 7, 5, 5, 3, 3};
  for (unsigned i = 0; i < std::size(expected); ++i) {
    INFO("event " << i);
    CHECK(events[i].stage == expected[i]);
  }
  CHECK(events[0].t_ns >= 0);
  CHECK(events[0].t_ns < 5'000);
}

TEST_CASE("two runs are equal in every event") {
  const auto run = [] {
    MiniBoard mini;
    mini.board.run_for(100'000'000);
    return std::pair(mini.board.stages(), mini.board.cpu().instructions());
  };
  const auto first = run(), second = run();
  CHECK(first.second == second.second);
  REQUIRE(first.first.size() == second.first.size());
  for (std::size_t i = 0; i < first.first.size(); ++i) {
    REQUIRE(first.first[i].t_ns == second.first[i].t_ns);
    REQUIRE(first.first[i].stage == second.first[i].stage);
  }
}

TEST_CASE("a release timer that does not count is a fault, not a start that hangs; the watchdog restarts the board") {
  constexpr std::uint32_t kCounted = 2U << 24 | 8U << 16 | 1;  // schedule, no_timer, once
  Board board{finemote::test::type_c(), finemote::test::tested_chip()};
  board.world().system().systick().dead = true;
  board.load(test_image("sample"));
  for (int ms = 0; ms < 100 && words_in_ram(board, kCounted) == 0; ++ms) board.run_for(1'000'000);
  REQUIRE(board.resets() == 0);
  CHECK(words_in_ram(board, kCounted) == 1);
  board.run_for(200'000'000);
  CHECK(board.stages().empty());
  CHECK(board.resets() >= 1);
  run_until_counted(board, kWatchdogCounted);  // it may just have started again
  CHECK(words_in_ram(board, kWatchdogCounted) == 1);
  const unsigned before = board.resets();
  board.world().system().systick().dead = false;
  board.run_for(200'000'000);
  CHECK(board.resets() <= before + 1);  // the start under way may still be lost
  CHECK(board.stages().empty());        // the robot had stopped: the watchdog does not make it go on
  CHECK(words_in_ram(board, kCounted) == 1);
  board.press_reset();
  board.run_for(200'000'000);
  CHECK_FALSE(board.stages().empty());
}

TEST_CASE("the watchdog resets a board whose releases have stopped, and the image starts again") {
  for (const std::uint32_t lsi_hz : {17'000U, 32'000U, 47'000U}) {
    BoardOptions options;
    options.lsi_hz = lsi_hz;
    Board board{finemote::test::type_c(), finemote::test::tested_chip(options)};
    board.load(test_image("sample"));
    board.run_for(50'000'000);
    REQUIRE(board.resets() == 0);                                            // also with the fastest clock
    board.world().system().write(0xE000E010, 4, 0, board.world().now(), 0);  // SysTick off
    board.run_for(500'000'000);
    CHECK(board.resets() >= 1);
    run_until_counted(board, kWatchdogCounted);
    CHECK(words_in_ram(board, kWatchdogCounted) == 1);
  }
}

TEST_CASE("a start counts its own cause, and only one that nobody asked for") {
  Board board{finemote::test::type_c(), finemote::test::tested_chip()};
  board.load(test_image("sample"));
  const auto counted_behind = [&board](std::uint32_t cause) {
    if (cause != 0) board.chip().rcc.note_reset(cause);
    board.press_reset();
    board.run_for(50'000'000);
    CHECK((board.chip().rcc.read(0x74) & kResetFlags) == 0);
    return std::pair{words_in_ram(board, kWatchdogCounted), words_in_ram(board, kBrownOutCounted)};
  };
  board.run_for(50'000'000);  // power-on, which sets the flag of the brown-out as well
  CHECK(words_in_ram(board, kWatchdogCounted) + words_in_ram(board, kBrownOutCounted) == 0);
  CHECK(counted_behind(Rcc::kWatchdogReset) == std::pair{1U, 0U});
  CHECK(counted_behind(0) == std::pair{0U, 0U});
  CHECK(counted_behind(Rcc::kWindowReset) == std::pair{1U, 0U});
  CHECK(counted_behind(Rcc::kBrownOutReset) == std::pair{0U, 1U});
  CHECK(counted_behind(Rcc::kSoftwareReset) == std::pair{0U, 0U});
}
