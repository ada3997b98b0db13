// SPI: chips behind their selects, by DMA and by one interrupt per byte.
#include <vector>

#include "catch.hpp"
#include "emulator/board.hpp"
#include "tests/emulator/tested_chip.hpp"
#include "tests/emulator/type_c.hpp"

using namespace finemote::emulator;

namespace {

/// Counts up from its own first byte; remembers what it was told.
struct Chip4 {
  explicit Chip4(std::uint8_t begin) : first(begin) {}
  SpiPart part() {
    return SpiPart{[this](bool selected) {
                     if (selected) {
                       next = first;
                       heard.clear();
                       ++selections;
                     }
                   },
                   [this](std::uint8_t byte) {
                     heard.push_back(byte);
                     return next++;
                   }};
  }
  std::uint8_t first, next = 0;
  unsigned selections = 0;
  std::vector<int> heard;
};

}  // namespace

TEST_CASE("three chips answer behind their own selects, and nothing is used wrongly") {
  Board board{finemote::test::type_c(), finemote::test::tested_chip()};
  Chip4 accelerometer(0x10), gyroscope(0x40), other(0x80);
  Spi& spi1 = *board.chip().spi("spi1");
  Spi& spi2 = *board.chip().spi("spi2");
  board.chip().attach_spi(spi1, 'A', 4, accelerometer.part());
  board.chip().attach_spi(spi1, 'B', 0, gyroscope.part());
  board.chip().attach_spi(spi2, 'B', 12, other.part());
  const auto* const image = GENERATE("spi", "spi_sram");  // buffers where DMA reaches them, and where it does not
  board.load(load_image(std::string(FINEMOTE_IMAGES) + "/" + image + ".elf"));
  finemote::test::run_to_first_release(board);
  board.run_for(60'500'000);
  for (unsigned i = 0; i < 3; ++i) {
    INFO("chip " << i);
    CHECK(board.word("done", 4 * i) >= 50);
  }
  CHECK(board.word("bytes", 0) == 0x13121110);
  CHECK(board.word("bytes", 4) == 0x43424140);
  CHECK(board.word("bytes", 8) == 0x83828180);
  CHECK(accelerometer.heard == std::vector<int>{0x92, 0, 0, 0});
  CHECK(other.heard == std::vector<int>{0xFF, 0xFF, 0xFF, 0xFF});
  CHECK(accelerometer.selections - board.word("done", 0) <= 2);
  CHECK(spi1.clock_hz() == 1'312'500);  // 84 MHz / 64, the highest not above 2.5 MHz
  CHECK(spi2.clock_hz() == 164'062);
  CHECK(spi1.mode() == 3);
  CHECK(spi2.mode() == 0);
  for (const Report& report : board.reports()) {
    INFO(name_of(report.misuse) << ": " << report.text);
    CHECK(false);
  }
}
