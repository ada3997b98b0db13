// Code in SRAM (board param `code`): the same behaviour as from flash, a copy that is checked, memory that is guarded.
#include <cstring>

#include "catch.hpp"
#include "emulator/program/firmware.hpp"
#include "tests/emulator/fixture.hpp"

using namespace finemote::emulator;

namespace {

constexpr std::uint32_t kSram1 = 0x20000000, kSram2 = 0x2001C000, kFlash = 0x08000000, kCoreRam = 0x10000000;
constexpr unsigned kCoreModule = 1, kMemory = 2, kCodeCopy = 8;

/// The stages in the order they began and ended.
std::vector<std::pair<std::uint32_t, bool>> order_of(Board& board) {
  std::vector<std::pair<std::uint32_t, bool>> order;
  for (const StageEvent& event : board.stages()) order.emplace_back(event.stage, event.begin);
  return order;
}

void check_no_reports(const Board& board) {
  for (const Report& report : board.reports()) {
    INFO(name_of(report.misuse) << ": " << report.text);
    CHECK(false);
  }
}

std::uint32_t word_at(Board& board, std::uint32_t address) {
  std::uint32_t word = 0;
  std::memcpy(&word, board.cpu().memory(address, 4), 4);
  return word;
}

/// Until the last word of the code has been copied.
void run_to_end_of_copy(Board& board, const Image& image) {
  const std::uint32_t bytes = image.symbol("_code_copy_end")->address - kSram1,
                      load = image.symbol("_code_load")->address;
  for (unsigned step = 0; step < 10'000; ++step) {
    if (word_at(board, kSram1 + bytes - 8) == word_at(board, load + bytes - 8)) return;
    board.run_for(1'000);
  }
  FAIL("the code is never copied");
}

void write_code(Board& board, std::uint32_t address, const std::vector<std::uint16_t>& code) {
  const auto bytes = static_cast<std::uint32_t>(2 * code.size());
  std::memcpy(board.cpu().memory(address, bytes), code.data(), bytes);
  board.cpu().ram_changed(kSram1 + address, bytes);
}

}  // namespace

TEST_CASE("a robot does the same from SRAM as from flash, in the same order") {
  MiniBoard from_flash(finemote::test::tested_chip(), "mini"), from_sram(finemote::test::tested_chip(), "mini_sram");
  for (MiniBoard* mini : {&from_flash, &from_sram}) {
    finemote::test::run_to_first_release(mini->board);
    mini->board.run_for(400'000'000);
    check_no_reports(mini->board);
    CHECK(mini->board.resets() == 0);
    CHECK(mini->observed(0) == from_flash.observed(0));
  }
  auto first = order_of(from_flash.board), second = order_of(from_sram.board);
  REQUIRE(first.size() > 100);
  const std::size_t both = std::min(first.size(), second.size());
  CHECK(std::max(first.size(), second.size()) - both < 4);  // what was under way at the end
  first.resize(both);
  second.resize(both);
  CHECK(first == second);
}

TEST_CASE("code in SRAM and nothing else may be executed, and it may not be written") {
  MiniBoard mini(finemote::test::tested_chip(), "mini_sram");
  finemote::test::run_to_first_release(mini.board);
  const Mpu& mpu = mini.board.world().system().mpu();
  CHECK(mini.board.world().system().vector_table() == 0);
  CHECK(mpu.may_execute(0, kSram2 - kSram1));
  for (const std::uint32_t address : {kSram1, kSram2, kFlash, kCoreRam + 0x8000}) CHECK_FALSE(mpu.may_execute(address));
  CHECK(mpu.end_of_protected(0, kSram2 - kSram1) == kSram2 - kSram1);
  for (const std::uint32_t address : {0x200U, kSram1, kSram2 - 4}) CHECK_FALSE(mpu.may_write(address));
  for (const std::uint32_t address : {kSram2, kCoreRam + 0x8000, 0x40000000U}) CHECK(mpu.may_write(address));
}

TEST_CASE("a write to the code faults, and the robot comes back from flash with safe outputs and no release") {
  const Image image = test_image("mini_sram");
  MiniBoard mini(finemote::test::tested_chip(), "mini_sram");
  finemote::test::run_to_first_release(mini.board);
  const auto idle = image.symbol("_ZN8finemote9cortex_m44idleEv");
  REQUIRE(idle);
  write_code(mini.board, idle->address, {0x2080, 0x6000});  // movs r0, #128; str r0, [r0]
  mini.board.run_for(5'000'000);
  CHECK(mini.board.resets() == 1);
  const std::size_t before = mini.board.stages().size();
  mini.board.run_for(300'000'000);
  CHECK(mini.board.resets() == 1);
  CHECK(faults_of(mini.board, image).dump() == nlohmann::ordered_json::array({{kCoreModule, kMemory, 1}}).dump());
  CHECK(mini.board.stages().size() == before);
}

TEST_CASE("a wrong copy is made again, counted, and releases nothing") {
  const Image image = test_image("mini_sram");
  MiniBoard mini(finemote::test::tested_chip(), "mini_sram");
  run_to_end_of_copy(mini.board, image);
  *mini.board.cpu().memory(kSram1 + 0x400, 1) ^= 1;
  mini.board.run_for(300'000'000);
  CHECK(word_at(mini.board, kSram1 + 0x400) == word_at(mini.board, image.symbol("_code_load")->address + 0x400));
  CHECK(faults_of(mini.board, image).dump() == nlohmann::ordered_json::array({{kCoreModule, kCodeCopy, 1}}).dump());
  CHECK(mini.board.stages().empty());
  CHECK(mini.board.resets() == 0);
}

TEST_CASE("a copy that is never right starts nothing") {
  const Image image = test_image("mini_sram");
  MiniBoard mini(finemote::test::tested_chip(), "mini_sram");
  for (unsigned copies = 0; copies < 3; ++copies) {
    run_to_end_of_copy(mini.board, image);
    *mini.board.cpu().memory(kSram1 + 0x400, 1) ^= 1;
    *mini.board.cpu().memory(image.symbol("_code_copy_end")->address - 8, 1) ^= 1;  // to see the next copy end
    mini.board.run_for(2'000'000);
  }
  CHECK(mini.board.world().system().nvic().times_entered(finemote::emulator::kSysTick) == 0);
  CHECK(mini.board.cpu().pc() >= kFlash);
}

TEST_CASE("a boot loader's vectors, mapping and stack are not kept") {
  MiniBoard mini(finemote::test::tested_chip(), "mini_sram");
  mini.board.world().system().write(0xE000ED08, 4, 0x1FFF0000, 0, 0);
  finemote::test::run_to_first_release(mini.board);
  CHECK(mini.board.world().system().vector_table() == 0);
  check_no_reports(mini.board);
}

TEST_CASE("the time a copy takes") {
  const Image image = test_image("mini_sram");
  MiniBoard mini({}, "mini_sram");
  std::optional<std::uint64_t> checked;
  const std::uint32_t start = image.symbol("finemote_reset")->address;
  const std::uint32_t words = (image.symbol("_code_copy_end")->address - kSram1) / 4;
  mini.board.cpu().set_probe([&](std::uint32_t pc) {
    if (pc == start && !checked) checked = mini.board.now_ns();
  });
  mini.board.run_for(30'000'000);
  REQUIRE(checked);
  const double cycles = static_cast<double>(*checked) * 16e6 / 1e9;
  INFO(words << " words in " << cycles << " cycles");
  CHECK(cycles < 40.0 * words);  // before the clock is set up: 16 MHz
}
