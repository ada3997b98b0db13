// The emulated chip itself, register by register: what it refuses, and what it does in time.
#include "catch.hpp"
#include "emulator/board.hpp"

using namespace finemote::emulator;

namespace {

/// Two instructions that run for ever: `b .` behind a vector table.
Image idle_image() {
  Segment segment{0x08000000, std::vector<std::uint8_t>(0x190, 0)};
  const auto put = [&](std::size_t at, std::uint32_t value) {
    for (unsigned i = 0; i < 4; ++i) segment.bytes[at + i] = static_cast<std::uint8_t>(value >> (8 * i));
  };
  put(0, 0x20001000);
  for (std::size_t at = 4; at < 0x188; at += 4) put(at, 0x08000189);
  put(0x188, 0xE7FEE7FE);
  Image image;
  image.segments.push_back(segment);
  return image;
}

struct Bench {
  Bench() {
    board.load(idle_image());
    board.run_for(1'000);
  }
  std::uint32_t read(std::uint32_t address) { return board.chip().read(address, 4); }
  void write(std::uint32_t address, std::uint32_t value) { board.chip().write(address, 4, value); }
  /// As a driver's register access would: what it started may run.
  void run(std::uint64_t ns) { board.run_for(ns); }
  bool reported(Misuse misuse) {
    for (const Report& report : board.reports()) {
      if (report.misuse == misuse) return true;
    }
    return false;
  }
  Board board;
};

constexpr std::uint32_t kAhb1 = 0x40023830, kApb2 = 0x40023844, kApb1 = 0x40023840;
constexpr std::uint32_t kUsart6 = 0x40011400, kDma2 = 0x40026400, kI2c2 = 0x40005800;

}  // namespace

TEST_CASE("a peripheral without its clock is reported and does nothing") {
  Bench bench;
  bench.write(kUsart6 + 0x0C, 0x200C);
  CHECK(bench.reported(Misuse::unclocked));
  bench.write(kApb2, 1U << 5);
  CHECK(bench.read(kUsart6 + 0x0C) == 0);
}

TEST_CASE("a register nobody models is reported") {
  Bench bench;
  bench.read(0x40014C00);
  CHECK(bench.reported(Misuse::unmodelled));
}

TEST_CASE("DMA into core-coupled RAM fails with the stream's error flag") {
  Bench bench;
  bench.write(kAhb1, 1U << 22);
  bench.write(kApb2, 1U << 5);
  bench.write(kUsart6 + 0x08, 139);
  bench.write(kUsart6 + 0x14, 1U << 6);
  const std::uint32_t stream1 = kDma2 + 0x10 + 0x18;
  bench.write(stream1 + 0x08, kUsart6 + 4);
  bench.write(stream1 + 0x0C, 0x10000000);
  bench.write(stream1 + 0x04, 4);
  bench.write(stream1, 5U << 25 | 1U << 10 | 1);
  bench.write(kUsart6 + 0x0C, 0x2004);
  bench.board.chip().usart("usart6")->send_in({0x42}, SerialFormat{115108, false, 1});
  bench.run(1'000'000);
  CHECK(bench.reported(Misuse::dma_unreachable));
  CHECK((bench.read(kDma2) >> 6 & 8) != 0);  // TEIF1
  CHECK((bench.read(stream1) & 1) == 0);
}

TEST_CASE("circular DMA receives into RAM, flags half and end, and starts over") {
  Bench bench;
  bench.write(kAhb1, 1U << 22);
  bench.write(kApb2, 1U << 5);
  bench.write(kUsart6 + 0x08, 139);
  bench.write(kUsart6 + 0x14, 1U << 6);
  const std::uint32_t stream1 = kDma2 + 0x10 + 0x18;
  bench.write(stream1 + 0x08, kUsart6 + 4);
  bench.write(stream1 + 0x0C, 0x20002000);
  bench.write(stream1 + 0x04, 4);
  bench.write(stream1, 5U << 25 | 1U << 10 | 1U << 8 | 1);
  bench.write(kUsart6 + 0x0C, 0x2004);
  Usart& usart = *bench.board.chip().usart("usart6");
  usart.send_in({1, 2}, SerialFormat{115108, false, 1});
  bench.run(1'000'000);
  CHECK(bench.read(stream1 + 4) == 2);
  CHECK((bench.read(kDma2) >> 6 & 0x30) == 0x10);
  usart.send_in({3, 4, 5}, SerialFormat{115108, false, 1});
  bench.run(1'000'000);
  CHECK(bench.read(stream1 + 4) == 3);
  CHECK((bench.read(kDma2) >> 6 & 0x30) == 0x30);
  const std::uint8_t* ram = bench.board.cpu().memory(0x20002000, 4);
  CHECK(std::vector<int>(ram, ram + 4) == std::vector<int>{5, 2, 3, 4});
  CHECK((bench.read(kUsart6) & 0x10) != 0);  // the line is idle
}

TEST_CASE("a byte that is not fetched in time is an overrun") {
  Bench bench;
  bench.write(kApb2, 1U << 5);
  bench.write(kUsart6 + 0x08, 139);
  bench.write(kUsart6 + 0x0C, 0x2004);
  bench.board.chip().usart("usart6")->send_in({1, 2}, SerialFormat{115108, false, 1});
  bench.run(1'000'000);
  CHECK((bench.read(kUsart6) & 0x28) == 0x28);
  CHECK(bench.read(kUsart6 + 4) == 1);  // the first stays, the second is lost
}

TEST_CASE("the wrong rate shows as framing errors") {
  Bench bench;
  bench.write(kApb2, 1U << 5);
  bench.write(kUsart6 + 0x08, 139);
  bench.write(kUsart6 + 0x0C, 0x2004);
  bench.board.chip().usart("usart6")->send_in({1}, SerialFormat{57600, false, 1});
  bench.run(1'000'000);
  CHECK((bench.read(kUsart6) & 2) != 0);
  CHECK(bench.reported(Misuse::wire));
}

TEST_CASE("too few wait states for the clock are reported") {
  Bench bench;
  bench.write(0x40023800, 1U << 16);
  bench.run(3'000'000);
  bench.write(0x40023804, 6 | 168U << 6 | 1U << 22 | 7U << 24);
  bench.write(0x40023800, 1U << 16 | 1U << 24);
  bench.run(1'000'000);
  bench.write(0x40023C00, 3);
  bench.write(0x40023808, 5U << 10 | 4U << 13 | 2);
  CHECK(bench.board.chip().rcc.core_hz() == 168'000'000);
  CHECK(bench.reported(Misuse::clock));
}

TEST_CASE("an I2C address nobody has is not acknowledged") {
  Bench bench;
  bench.write(kApb1, 1U << 22);
  bench.write(kI2c2 + 0x04, 16);  // APB1 at 16 MHz
  bench.write(kI2c2 + 0x1C, 80);
  bench.write(kI2c2, 1);
  bench.write(kI2c2, 0x101);
  bench.run(20'000);
  CHECK((bench.read(kI2c2 + 0x14) & 1) != 0);
  bench.write(kI2c2 + 0x10, 0x50 << 1);
  bench.run(80'000);
  CHECK((bench.read(kI2c2 + 0x14) & 0x402) == 0);  // nine bits at 100 kHz are 90 us
  bench.run(20'000);
  CHECK((bench.read(kI2c2 + 0x14) & 0x402) == 0x400);
  CHECK(bench.board.bus("i2c2").errors == 1);
}

TEST_CASE("CR1 written while a START is pending is reported") {
  Bench bench;
  bench.write(kApb1, 1U << 22);
  bench.write(kI2c2 + 0x04, 16);
  bench.write(kI2c2 + 0x1C, 80);
  bench.write(kI2c2, 1);
  bench.write(kI2c2, 0x101);
  bench.write(kI2c2, 0x501);
  CHECK(bench.reported(Misuse::protocol));
}

TEST_CASE("the watchdog needs its key") {
  Bench bench;
  bench.write(0x40003004, 3);
  CHECK(bench.reported(Misuse::protocol));
}

TEST_CASE("a pin shows what drives it, and its pull-up when nothing does") {
  Bench bench;
  bench.write(kAhb1, 1);
  Gpio& gpio = bench.board.chip().gpio('A');
  bench.write(0x4002000C, 1);
  CHECK((bench.read(0x40020010) & 1) == 1);
  gpio.drive(0, 0);
  CHECK((bench.read(0x40020010) & 1) == 0);
  gpio.drive(0, -1);
  bench.write(0x40020000, (bench.read(0x40020000) & ~3U) | 1);
  bench.write(0x40020018, 1);
  CHECK((bench.read(0x40020010) & 1) == 1);
  bench.write(0x40020018, 1U << 16);
  CHECK((bench.read(0x40020010) & 1) == 0);
}
