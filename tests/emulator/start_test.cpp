// The image's start on the board: clocks from the crystal, what happens without one, the watchdog, determinism.
#include "catch.hpp"
#include "tests/emulator/fixture.hpp"

using namespace finemote::emulator;

namespace {

void check_no_reports(Board& board) {
  for (const Report& report : board.reports()) {
    INFO(name_of(report.misuse) << ": " << report.text);
    CHECK(false);
  }
}

}  // namespace

TEST_CASE("the image brings the chip to 168 MHz from the crystal, with five wait states") {
  Board board;
  board.load(test_image("sample"));
  REQUIRE(board.run_for(5'000'000) == Stop::time);
  CHECK(board.chip().rcc.core_hz() == 168'000'000);
  CHECK(board.chip().rcc.apb1_hz() == 42'000'000);
  CHECK(board.chip().rcc.apb2_hz() == 84'000'000);
  CHECK(board.chip().flash.wait_states() == 5);
  check_no_reports(board);
}

TEST_CASE("without its crystal the board stops safely within 200 ms and runs no stage") {
  Board board;
  board.chip().rcc.dead_crystal = true;
  board.load(test_image("sample"));
  REQUIRE(board.run_for(200'000'000) == Stop::time);
  CHECK(board.chip().rcc.core_hz() == 16'000'000);
  CHECK(board.stages().empty());
}

TEST_CASE("stages run in the order of the schedule, the fast bucket preempting the slow one") {
  Board board;
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

TEST_CASE("the watchdog resets a board whose releases have stopped, and the image starts again") {
  for (const std::uint32_t lsi_hz : {17'000U, 32'000U, 47'000U}) {
    BoardOptions options;
    options.lsi_hz = lsi_hz;
    Board board(options);
    board.load(test_image("sample"));
    board.run_for(50'000'000);
    REQUIRE(board.resets() == 0);                                            // also with the fastest clock
    board.world().system().write(0xE000E010, 4, 0, board.world().now(), 0);  // SysTick off
    board.run_for(500'000'000);
    CHECK(board.resets() >= 1);
    CHECK((board.chip().rcc.read(0x74) & Rcc::kWatchdogReset) != 0);
  }
}
