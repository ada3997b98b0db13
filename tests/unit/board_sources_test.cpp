// A board file to the sources of the runtime: what is made, and what a file lacks for it.
#include "generator/board_sources/board_sources.hpp"

#include <algorithm>

#include "catch.hpp"
#include "generator/board_sources/chip_needs.hpp"
#include "generator/descriptor/library.hpp"
#include "source_dir.hpp"
#include "tests/read.hpp"

using namespace finemote::gen;

namespace {

struct Shelf {
  Sources sources;
  Diagnostics diagnostics;
  std::optional<Library> library = load_library({finemote::test::source_dir(), "", {}, {}}, sources, diagnostics);
  const Board& board(const char* name) { return *find_board(*library, name, sources, diagnostics); }
};

std::string text_of(const std::vector<OutputFile>& files, const std::string& name) {
  const auto found =
      std::find_if(files.begin(), files.end(), [&](const OutputFile& file) { return file.name == name; });
  return found == files.end() ? "" : found->text;
}

Port& port_of(Board& board, const std::string& name) {
  return *std::find_if(board.ports.begin(), board.ports.end(), [&](const Port& port) { return port.name == name; });
}

}  // namespace

TEST_CASE("a port object has the pins, streams and lines of the board file") {
  Shelf shelf;
  const auto files = board_sources(shelf.board("robomaster_type_c"), {}, finemote::test::source_dir());
  const std::string usart1 = text_of(files, "ports/usart1.cpp");
  CHECK(usart1.find("/*tx*/ {'A', 9}, /*rx*/ {'B', 7}, /*alternate function*/ 7") != std::string::npos);
  CHECK(usart1.find("void finemote_line_68() { finemote::hardware.on_receive_dma(); }") != std::string::npos);
  CHECK(text_of(files, "board/clocks.hpp").find("kCrystalHz = 12'000'000;") != std::string::npos);
  CHECK(text_of(files, "board.ld").find("CORE_RAM (rw)  : ORIGIN = 0x10000000, LENGTH = 64K") != std::string::npos);
}

TEST_CASE("the order of a port's interrupts says nothing") {
  Shelf shelf;
  Board board = shelf.board("robomaster_type_c");
  const auto files = board_sources(board, {}, finemote::test::source_dir());
  for (Port& port : board.ports) std::reverse(port.interrupts.begin(), port.interrupts.end());
  for (const char* name :
       {"ports/usart1.cpp", "ports/can1.cpp", "ports/i2c2.cpp", "ports/spi1.cpp", "ports/spi2.cpp"}) {
    CHECK(text_of(board_sources(board, {}, finemote::test::source_dir()), name) == text_of(files, name));
  }
}

TEST_CASE("edges that share an interrupt line share a file and its routine") {
  Shelf shelf;
  Board board = shelf.board("robomaster_type_c");
  NamedPin second = *board.named_pin("bmi088_int_gyro");  // PC5
  second.pin = "PD9";
  board.pins.push_back(second);
  const std::string text = text_of(board_sources(board, {}, finemote::test::source_dir()), "ports/exti5.cpp");
  CHECK(text.find("if (finemote::exti9.is_pending()) finemote::exti9.on_interrupt();") != std::string::npos);
}

TEST_CASE("a board that stands in for others has the ports of all, and none of two kinds") {
  Shelf shelf;
  const Board& host = shelf.board("host");
  const Board& first = shelf.board("robomaster_type_c");
  Board other = first;
  other.name = "other";
  port_of(other, "i2c3").name = "i2c1";
  const auto names =
      text_of(board_sources(host, {&first, &other}, finemote::test::source_dir()), "board/port_names.hpp");
  CHECK(names.find("extern I2cPort i2c2, i2c3, i2c1;") != std::string::npos);
  port_of(other, "i2c1").name = "usart6";
  CHECK(mistakes_for_sources(host, {&first, &other}).size() == 1);
}

TEST_CASE("without a board's headers there are the ports of all shipped boards") {
  const auto declared = [](const std::string& header) {
    const std::string text = finemote::test::read(finemote::test::source_dir() + header);
    const std::size_t begin = text.find("namespace finemote::ports {"), end = text.find("}  // namespace", begin);
    REQUIRE(end != std::string::npos);
    return text.substr(begin, end - begin);
  };
  CHECK(declared("/runtime/include/finemote/port_names.hpp") ==
        declared("/runtime/boards/host/generated/board/port_names.hpp"));
}

TEST_CASE("what a board file lacks for the drivers of its chip is named") {
  Shelf shelf;
  Board board = shelf.board("robomaster_type_c");
  CHECK(mistakes_for_chip(board).empty());
  port_of(board, "usart1").dma.pop_back();
  port_of(board, "i2c2").interrupts.clear();
  port_of(board, "pwm1").timer.reset();
  std::erase_if(port_of(board, "usart6").interrupts, [](const InterruptLine& line) { return line.name == "USART6"; });
  NamedPin pin = *board.named_pin("key");
  pin.pin = "PE0";
  board.pins.push_back(pin);
  CHECK(mistakes_for_chip(board) == std::vector<std::string>{
                                        "port 'usart1' needs DMA streams 'rx' and 'tx'",
                                        "port 'usart6' needs an interrupt of its own name",
                                        "port 'i2c2' needs an interrupt '..._EV'",
                                        "port 'pwm1' needs a timer channel",
                                        "pins 'PA0' and 'PE0' share an external interrupt line",
                                    });
}
