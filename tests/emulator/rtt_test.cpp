// The trace ring as a debug probe finds it: by its identifier in RAM, then by the layout of RTT's control block.
#include <cstring>

#include "catch.hpp"
#include "tests/emulator/fixture.hpp"
#include "tests/emulator/type_c.hpp"

using namespace finemote::emulator;

namespace {

/// What a probe does with a board: reads and writes memory, knows no symbols.
struct Probe {
  explicit Probe(Board& board) : board(board) {}
  std::uint32_t word(std::uint32_t address) {
    std::uint32_t value = 0;
    const std::uint8_t* p = board.cpu().memory(address, 4);
    REQUIRE(p != nullptr);
    std::memcpy(&value, p, 4);
    return value;
  }
  /// Every place in RAM that begins with the identifier.
  std::vector<std::uint32_t> search() {
    constexpr char kIdentifier[16] = "SEGGER RTT";
    std::vector<std::uint32_t> found;
    for (std::uint32_t at = 0x20000000; at + 16 <= 0x20020000; at += 4) {
      if (std::memcmp(board.cpu().memory(at, 16), kIdentifier, 16) == 0) found.push_back(at);
    }
    return found;
  }
  Board& board;
};

}  // namespace

TEST_CASE("a probe finds one control block with one buffer up, and reads the trace while the image runs") {
  BoardOptions options;
  options.probe = false;  // nobody else reads
  Board board{finemote::test::type_c(), finemote::test::tested_chip(options)};
  board.load(test_image("mini"));
  finemote::test::run_to_first_release(board);
  REQUIRE(board.run_for(20'000'000) == Stop::time);
  Probe probe(board);
  const auto found = probe.search();
  REQUIRE(found.size() == 1);
  const std::uint32_t block = found[0], up = block + 24;
  CHECK(probe.word(block + 16) == 1);  // buffers up
  CHECK(probe.word(block + 20) == 0);  // and down
  const std::uint32_t name = probe.word(up), buffer = probe.word(up + 4), size = probe.word(up + 8);
  CHECK(std::string(reinterpret_cast<const char*>(board.cpu().memory(name, 15))) == "finemote trace");
  CHECK(buffer % 4 == 0);
  CHECK(board.cpu().memory(buffer, size) != nullptr);
  CHECK(size % 8 == 0);
  CHECK(probe.word(up + 20) == 0);  // mode: skip what does not fit
  const std::uint32_t write = probe.word(up + 12);
  CHECK(write < size);
  CHECK(write % 8 == 0);
  REQUIRE(write != 0);
  CHECK(probe.word(up + 16) == 0);

  // The probe takes what there is by moving its own offset; the image goes on writing behind it.
  std::memcpy(board.cpu().memory(up + 16, 4), &write, 4);
  std::uint32_t last = probe.word(buffer);
  for (std::uint32_t at = 0; at < write; at += 8) {
    CHECK(static_cast<std::int32_t>(probe.word(buffer + at) - last) >= 0);  // cycle stamps do not go back
    last = probe.word(buffer + at);
  }
  REQUIRE(board.run_for(10'000'000) == Stop::time);
  CHECK(probe.word(up + 12) != write);
}
