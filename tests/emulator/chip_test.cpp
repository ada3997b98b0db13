// The emulated chip itself, register by register: what it refuses, and what it does in time.
#include <cstdlib>
#include <cstring>

#include "catch.hpp"
#include "tests/emulator/bench.hpp"

using namespace finemote::emulator;

namespace {

constexpr std::uint32_t kAhb1 = 0x40023830, kApb2 = 0x40023844, kApb1 = 0x40023840;
constexpr std::uint32_t kTim2 = 0x40000000, kSpi1 = 0x40013000, kGpioD = 0x40020C00;
constexpr std::uint32_t kUsart6 = 0x40011400, kDma2 = 0x40026400, kI2c2 = 0x40005800;
constexpr std::uint32_t kUsart6Stream = kDma2 + 0x10 + 0x18;  // stream 1

/// USART6 receives by DMA at 115108 bit/s: `count` bytes into `memory`.
/// @param mode  bits of the stream beside its channel, MINC and EN
void receive_by_dma(Bench& bench, std::uint32_t memory, std::uint32_t count, std::uint32_t mode) {
  bench.write(kAhb1, 1U << 22);
  bench.write(kApb2, 1U << 5);
  bench.write(kUsart6 + 0x08, 139);
  bench.write(kUsart6 + 0x14, 1U << 6);
  bench.write(kUsart6Stream + 0x08, kUsart6 + 4);
  bench.write(kUsart6Stream + 0x0C, memory);
  bench.write(kUsart6Stream + 0x04, count);
  bench.write(kUsart6Stream, 5U << 25 | 1U << 10 | mode | 1);
  bench.write(kUsart6 + 0x0C, 0x2004);
}

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
  receive_by_dma(bench, 0x10000000, 4, 0);
  bench.board.chip().usart("usart6")->send_in({0x42}, SerialFormat{115108, false, 1});
  bench.run(1'000'000);
  CHECK(bench.reported(Misuse::dma_unreachable));
  CHECK((bench.read(kDma2) >> 6 & 8) != 0);  // TEIF1
  CHECK((bench.read(kUsart6Stream) & 1) == 0);
}

TEST_CASE("circular DMA receives into RAM, flags half and end, and starts over") {
  Bench bench;
  receive_by_dma(bench, 0x20002000, 4, 1U << 8);
  Usart& usart = *bench.board.chip().usart("usart6");
  usart.send_in({1, 2}, SerialFormat{115108, false, 1});
  bench.run(1'000'000);
  CHECK(bench.read(kUsart6Stream + 4) == 2);
  CHECK((bench.read(kDma2) >> 6 & 0x30) == 0x10);
  usart.send_in({3, 4, 5}, SerialFormat{115108, false, 1});
  bench.run(1'000'000);
  CHECK(bench.read(kUsart6Stream + 4) == 3);
  CHECK((bench.read(kDma2) >> 6 & 0x30) == 0x30);
  const std::uint8_t* ram = bench.board.cpu().memory(0x20002000, 4);
  CHECK(std::vector<int>(ram, ram + 4) == std::vector<int>{5, 2, 3, 4});
  CHECK((bench.read(kUsart6) & 0x10) != 0);  // the line is idle
}

TEST_CASE("a line between two bytes is not idle, however near the rates of both sides are") {
  constexpr std::uint32_t kIdle = 1U << 4, kByteNs = 86'875;
  for (const std::uint32_t baud : {115'040U, 115'070U, 115'100U, 115'108U}) {
    for (std::uint64_t ns = 0; ns < 200; ns += 7) {
      Bench bench;
      receive_by_dma(bench, 0x20002000, 4, 1U << 8);
      bench.run(100'000 + ns);
      static_cast<void>(bench.read(kUsart6));
      static_cast<void>(bench.read(kUsart6 + 4));  // what was idle before
      bench.board.chip().usart("usart6")->send_in({1, 2, 3}, SerialFormat{baud, false, 1});
      bench.run(3 * kByteNs + kByteNs / 2);
      INFO(baud << " " << ns);
      CHECK((bench.read(kUsart6) & kIdle) == 0);
      bench.run(kByteNs);
      CHECK((bench.read(kUsart6) & kIdle) != 0);
    }
  }
}

TEST_CASE("a stream with two buffers fills one after the other, and says which") {
  constexpr std::uint32_t kSecond = 1U << 19;  // CT
  Bench bench;
  bench.write(kAhb1, 1U << 22);
  bench.write(kUsart6Stream + 0x10, 0x20002100);
  receive_by_dma(bench, 0x20002000, 2, 1U << 18);
  Usart& usart = *bench.board.chip().usart("usart6");
  const auto has = [&](std::uint32_t address, int first, int second) {
    const std::uint8_t* ram = bench.board.cpu().memory(address, 2);
    return ram[0] == first && ram[1] == second;
  };
  usart.send_in({1, 2}, SerialFormat{115108, false, 1});
  bench.run(1'000'000);
  CHECK(has(0x20002000, 1, 2));
  CHECK((bench.read(kUsart6Stream) & kSecond) != 0);
  CHECK((bench.read(kDma2) >> 6 & 0x20) == 0x20);  // TCIF1
  bench.write(kUsart6Stream + 0x0C, 0x20002200);   // the one that is not in use may be moved
  usart.send_in({3, 4, 5, 6}, SerialFormat{115108, false, 1});
  bench.run(1'000'000);
  CHECK(has(0x20002000, 1, 2));
  CHECK(has(0x20002100, 3, 4));
  CHECK(has(0x20002200, 5, 6));
  CHECK(bench.board.reports().empty());
}

TEST_CASE("sub-priorities order what is pending, and interrupt nothing") {
  Bench bench;
  Nvic& nvic = bench.board.world().system().nvic();
  constexpr int kFirst = 16, kSecond = 17, kThird = 18;
  nvic.set_priority(kFirst, 0x50);
  nvic.set_priority(kSecond, 0x40);
  nvic.set_priority(kThird, 0x30);
  CHECK(nvic.priority(kSecond) < nvic.priority(kFirst));
  bench.write_core(0xE000ED0C, 0x05FA0000 | 5U << 8);  // two bits of four
  CHECK(nvic.priority(kSecond) == nvic.priority(kFirst));
  CHECK(nvic.priority(kThird) < nvic.priority(kFirst));
  for (const int exception : {kFirst, kSecond}) {
    nvic.enable(exception, true);
    nvic.pend(exception);
  }
  CHECK(nvic.most_urgent() == kSecond);
  CHECK(nvic.group_of(0x70) == 0x40);  // as BASEPRI
  CHECK(bench.board.reports().empty());
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

TEST_CASE("a prescaler waits for an update, and the first period of a timer is short without one") {
  Bench bench;
  bench.write(kApb1, 1);
  bench.write(kTim2 + 0x28, 99);    // PSC
  bench.write(kTim2 + 0x2C, 1599);  // ARR: 1600 counts of 16 MHz are 100 us
  bench.write(kTim2 + 0x00, 1);
  bench.run(95'000);
  CHECK((bench.read(kTim2 + 0x10) & 1) == 0);
  bench.run(10'000);
  CHECK((bench.read(kTim2 + 0x10) & 1) == 1);
  bench.write(kTim2 + 0x10, 0);
  bench.run(9'985'000);  // 10 ms with the prescaler
  CHECK((bench.read(kTim2 + 0x10) & 1) == 0);
  bench.run(20'000);
  CHECK((bench.read(kTim2 + 0x10) & 1) == 1);
}

TEST_CASE("a period without preload works at once, one with preload after the update") {
  Bench bench;
  bench.write(kApb1, 1);
  bench.write(kTim2 + 0x2C, 0xFFFFFFFF);  // 32 bits
  bench.write(kTim2 + 0x00, 1);
  bench.write(kTim2 + 0x2C, 159);  // 10 us
  bench.run(12'000);
  CHECK((bench.read(kTim2 + 0x10) & 1) == 1);
  bench.write(kTim2 + 0x00, 1 | 1U << 7);
  bench.write(kTim2 + 0x2C, 1599);
  bench.write(kTim2 + 0x10, 0);
  bench.run(10'000);
  CHECK((bench.read(kTim2 + 0x10) & 1) == 1);
  bench.write(kTim2 + 0x10, 0);
  bench.run(50'000);
  CHECK((bench.read(kTim2 + 0x10) & 1) == 0);
}

TEST_CASE("an update flagged before its interrupt is asked for raises it then") {
  Bench bench;
  bench.write(kApb1, 1);
  bench.write(kTim2 + 0x14, 1);  // UG
  Nvic& nvic = bench.board.world().system().nvic();
  CHECK(!nvic.is_pending(16 + 28));
  bench.write(kTim2 + 0x0C, 1);
  CHECK(nvic.is_pending(16 + 28));
}

TEST_CASE("a counter that is stopped holds its value and goes on from there") {
  Bench bench;
  bench.write(kApb1, 1);
  bench.write(kTim2 + 0x00, 1);
  bench.run(10'000);
  bench.write(kTim2 + 0x00, 0);
  const std::uint32_t held = bench.read(kTim2 + 0x24);
  CHECK(held >= 159);
  CHECK(held <= 170);
  bench.run(10'000);
  CHECK(bench.read(kTim2 + 0x24) == held);
  bench.write(kTim2 + 0x24, 1000);
  bench.write(kTim2 + 0x00, 1);
  bench.run(1'000);
  CHECK(bench.read(kTim2 + 0x24) >= 1015);
}

TEST_CASE("a counter above its new reload value runs to its end and begins again without an event") {
  Bench bench;
  constexpr std::uint32_t kTim3 = 0x40000400;
  bench.write(kApb1, 2);
  bench.write(kTim3 + 0x24, 60'000);
  bench.write(kTim3 + 0x00, 1);
  bench.write(kTim3 + 0x2C, 1'599);  // below the count; from 0 on it is 100 us
  bench.run(340'000);                // 5440 of the 5535 counts to the end
  CHECK(bench.read(kTim3 + 0x24) > 65'000);
  CHECK((bench.read(kTim3 + 0x10) & 1) == 0);
  bench.run(50'000);
  CHECK(bench.read(kTim3 + 0x24) < 1'000);
  CHECK((bench.read(kTim3 + 0x10) & 1) == 0);
  bench.run(100'000);
  CHECK((bench.read(kTim3 + 0x10) & 1) == 1);
}

TEST_CASE("after power-on the reset flags read as the manual says") {
  Bench bench;
  CHECK((bench.read(0x40023874) & 0xFF000000U) == 0x0E000000U);  // RCC_CSR: RM0090 7.3.21
}

TEST_CASE("what a timer has and the model has not is reported") {
  Bench bench;
  bench.write(kApb1, 1);
  bench.write(kTim2 + 0x18, 1);  // an input
  CHECK(bench.reported(Misuse::unmodelled));
}

TEST_CASE("a timer measures the LSI inside the chip, and says when a capture was lost") {
  Bench bench;
  constexpr std::uint32_t kTim5 = 0x40000C00, kCsr = 0x40023874;
  bench.write(kCsr, 1);
  bench.run(100'000);
  bench.write(kApb1, 1U << 3);
  bench.write(kTim5 + 0x50, 1U << 6);              // TI4_RMP: LSI
  bench.write(kTim5 + 0x1C, (1U | 3U << 2) << 8);  // its own input, every eighth edge
  bench.write(kTim5 + 0x20, 1U << 12);
  bench.write(kTim5 + 0x00, 1);
  bench.run(251'000);
  REQUIRE((bench.read(kTim5 + 0x10) & 0x10) != 0);
  const std::uint32_t first = bench.read(kTim5 + 0x40);
  CHECK((bench.read(kTim5 + 0x10) & 0x10) == 0);
  bench.run(250'000);
  CHECK(bench.read(kTim5 + 0x40) - first == 4'000);  // 8 of 32 kHz at 16 MHz
  CHECK((bench.read(kTim5 + 0x10) & 0x1000) == 0);
  bench.run(500'000);
  CHECK((bench.read(kTim5 + 0x10) & 0x1000) != 0);
  CHECK(bench.board.reports().empty());
}

TEST_CASE("a timer measures the crystal divided for the calendar, once it runs") {
  Bench bench;
  constexpr std::uint32_t kTim11 = 0x40014800, kApb2 = 0x40023844;
  bench.write(kApb2, 1U << 18);
  bench.write(kTim11 + 0x50, 2);
  bench.write(kTim11 + 0x18, 1);
  bench.write(kTim11 + 0x20, 1);
  bench.write(0x40023808, 12U << 16);
  bench.write(kTim11 + 0x00, 1);
  bench.run(10'000);
  CHECK((bench.read(kTim11 + 0x10) & 2) == 0);
  bench.write(0x40023800, 0x83 | 1U << 16);
  bench.run(3'000'000);
  bench.write(kTim11 + 0x00, 1);
  bench.run(2'000);
  REQUIRE((bench.read(kTim11 + 0x10) & 2) != 0);
  const std::uint32_t first = bench.read(kTim11 + 0x34);
  bench.run(1'000);
  const std::uint32_t passed = bench.read(kTim11 + 0x34) - first;
  CHECK((passed == 16 || passed == 32));  // microseconds at 16 MHz
}

TEST_CASE("the core changes over when the clock it was told to take is ready") {
  Bench bench;
  bench.write(0x40023800, 0x83 | 1U << 16);
  bench.write(0x40023808, 1);
  CHECK(bench.board.chip().rcc.core_hz() == 16'000'000);
  bench.run(3'000'000);
  CHECK(bench.board.chip().rcc.core_hz() == 12'000'000);
  CHECK((bench.read(0x40023808) & 0xC) == 4);
}

TEST_CASE("memory moves to memory, an ended stream takes its count again, a stopped one says so") {
  Bench bench;
  bench.write(kAhb1, 1U << 22);
  const std::uint32_t stream = kDma2 + 0x10, control = 2U << 6 | 1U << 9 | 1U << 10;
  std::uint8_t* ram = bench.board.cpu().memory(0x20002000, 64);
  for (unsigned i = 0; i < 16; ++i) ram[i] = static_cast<std::uint8_t>(i + 1);
  bench.write(stream + 0x08, 0x20002000);
  bench.write(stream + 0x0C, 0x20002020);
  bench.write(stream + 0x04, 16);
  bench.write(stream, control | 1);
  bench.run(100'000);
  CHECK(bench.read(stream + 4) == 0);
  CHECK((bench.read(kDma2) & 0x20) != 0);  // TCIF0
  CHECK(ram[0x20] == 1);
  CHECK(ram[0x2F] == 16);
  bench.write(kDma2 + 8, 0x3D);
  ram[0] = 99;
  bench.write(stream, control | 1);
  bench.run(100'000);
  CHECK(ram[0x20] == 99);
  bench.write(kDma2 + 8, 0x3D);
  bench.write(stream, 4U << 25 | 1);  // a peripheral that asks for nothing
  bench.write(stream, 4U << 25);
  CHECK((bench.read(kDma2) & 0x20) != 0);
}

TEST_CASE("a transmitter begins with an idle frame, bytes follow without a gap, the ninth bit is the parity") {
  Bench bench;
  bench.write(kApb2, 1U << 5);
  bench.write(kUsart6 + 0x08, 139);
  std::vector<std::uint64_t> sent;
  bench.board.chip().usart("usart6")->on_sent = [&](std::uint8_t) { sent.push_back(bench.board.now_ns()); };
  bench.write(kUsart6 + 0x0C, 0x200C);
  const std::uint64_t begin = bench.board.now_ns(), byte = 10 * 139 * 1000 / 16;
  bench.write(kUsart6 + 0x04, 0x55);
  for (int i = 0; i < 3; ++i) {
    while ((bench.read(kUsart6) & 0x80) == 0) bench.run(1'000);
    bench.write(kUsart6 + 0x04, 0x55);
  }
  bench.run(1'000'000);
  REQUIRE(sent.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) CHECK(std::llabs(static_cast<long long>(sent[i] - begin - (i + 2) * byte)) < 500);
  bench.write(kUsart6 + 0x0C, 0x200C | 1U << 12 | 1U << 10);
  bench.board.chip().usart("usart6")->send_in({0x07}, SerialFormat{115108, true, 1});
  bench.run(1'000'000);
  CHECK(bench.read(kUsart6 + 4) == 0x107);
}

TEST_CASE("an overrun of SPI stays until data and status are read; frames may have sixteen bits") {
  Bench bench;
  bench.write(kApb2, 1U << 12);
  std::vector<unsigned> frames;
  bench.board.chip().spi("spi1")->on_frame = [&](std::uint16_t out, std::uint16_t, unsigned bits) {
    frames.push_back(bits << 16 | out);
  };
  bench.write(kSpi1, 0x344);
  bench.write(kSpi1 + 0x0C, 0xA1);
  bench.run(10'000);
  bench.write(kSpi1 + 0x0C, 0xA2);
  bench.run(10'000);
  CHECK((bench.read(kSpi1 + 8) & 0x41) == 0x41);
  bench.read(kSpi1 + 0x0C);
  CHECK((bench.read(kSpi1 + 8) & 0x41) == 0x40);
  CHECK((bench.read(kSpi1 + 8) & 0x41) == 0);
  bench.write(kSpi1, 0);
  bench.write(kSpi1, 0xB44);
  bench.write(kSpi1 + 0x0C, 0xBEEF);
  bench.run(10'000);
  CHECK(frames == std::vector<unsigned>{8U << 16 | 0xA1, 8U << 16 | 0xA2, 16U << 16 | 0xBEEF});
  CHECK(!bench.reported(Misuse::protocol));
  bench.write(kSpi1, 0x244);  // software select, low
  CHECK(bench.reported(Misuse::protocol));
}

TEST_CASE("pins take bytes and halfwords") {
  Bench bench;
  bench.write(kAhb1, 1U << 3);
  bench.write(kGpioD, 0x55555555);
  bench.board.chip().write(kGpioD + 0x18, 2, 0x8001);
  CHECK(bench.read(kGpioD + 0x14) == 0x8001);
  bench.board.chip().write(kGpioD + 0x1A, 2, 0x0001);
  CHECK(bench.read(kGpioD + 0x14) == 0x8000);
  bench.board.chip().write(kGpioD + 0x14, 1, 0x42);
  CHECK(bench.read(kGpioD + 0x14) == 0x8042);
  CHECK(bench.board.reports().empty());
}

TEST_CASE("a word of a bit-band alias is one bit of RAM or of a peripheral") {
  // b: sets r1 at [r0], reads [r0] to r2 and stores that at [r3].
  constexpr std::uint32_t kRcc = 0x40023800;
  const auto alias = [](std::uint32_t address, unsigned bit) {
    return (address & 0xF0000000) + 0x02000000 + (address & 0xFFFFF) * 32 + bit * 4;
  };
  for (const auto& [address, bit] : {std::pair{0x20002004U, 9U}, std::pair{kRcc, 16U}, std::pair{kRcc + 0x30, 3U}}) {
    const Code routine = {0x6001, 0x6802, 0x601A, 0xE7FE};  // str r1, [r0]; ldr r2, [r0]; str r2, [r3]; b .
    Bench bench(bench_image(1, routine, {alias(address, bit), 0xFFFFFFFF, 0, 0x20002000}));
    bench.run(10'000);
    std::uint32_t seen = 0, word = 0;
    std::memcpy(&seen, bench.board.cpu().memory(0x20002000, 4), 4);
    if (address < 0x40000000)
      std::memcpy(&word, bench.board.cpu().memory(address, 4), 4);
    else
      word = bench.read(address);
    INFO(address << " bit " << bit);
    CHECK(seen == 1);
    CHECK((word >> bit & 1) == 1);
    CHECK(bench.board.reports().empty());
  }
}

TEST_CASE("a store to locked flash, also where it stands at 0, is an error of the flash and no fault") {
  for (const std::uint32_t address : {0x00000000U, 0x08020000U}) {
    const Code routine = {0x6001, 0x601A, 0xE7FE};  // str r1, [r0]; str r2, [r3]; b .
    Bench bench(bench_image(1, routine, {address, 0x12345678, 7, 0x20002000}));
    bench.run(10'000);
    CHECK((bench.read(0x40023C0C) & 0x80) != 0);  // PGSERR
    CHECK(*bench.board.cpu().memory(0x20002000, 1) == 7);
    CHECK(bench.reported(Misuse::protocol));
    CHECK_FALSE(bench.reported(Misuse::fault));
  }
}

TEST_CASE("the chip knows its size and how its converter measured itself") {
  const Code routine = {0x6801, 0x6019, 0xE7FE};  // ldr r1, [r0]; str r1, [r3]; b .
  for (const auto& [address, value] : {std::pair{0x1FFF7A20U, 1024U << 16}, std::pair{0x1FFF7A28U, 1501U << 16}}) {
    Bench bench(bench_image(1, routine, {address, 0, 0, 0x20002000}));
    bench.run(10'000);
    std::uint32_t word = 0;
    std::memcpy(&word, bench.board.cpu().memory(0x20002000, 4), 4);
    CHECK((word & 0xFFFF0000) == value);
    CHECK(bench.board.reports().empty());
  }
}

TEST_CASE("flash is programmed and erased as the manual says, and the core waits for it") {
  constexpr std::uint32_t kFlash = 0x40023C00, kWord = 0x08020000;  // sector 5
  Bench bench;
  const auto word = [&] {
    std::uint32_t value = 0;
    std::memcpy(&value, bench.board.cpu().memory(kWord, 4), 4);
    return value;
  };
  bench.board.chip().store_to_flash(kWord, 4, 1);
  CHECK((bench.read(kFlash + 0x0C) & 0x80) != 0);  // PGSERR: locked
  CHECK(word() == 0xFFFFFFFF);
  bench.write(kFlash + 0x0C, 0x80);
  bench.write(kFlash + 0x04, 0x45670123);
  bench.write(kFlash + 0x04, 0xCDEF89AB);
  CHECK((bench.read(kFlash + 0x10) >> 31) == 0);
  bench.write(kFlash + 0x10, 2U << 8 | 1);
  bench.board.chip().store_to_flash(kWord, 2, 1);
  CHECK((bench.read(kFlash + 0x0C) & 0x40) != 0);  // PGPERR: a halfword where PSIZE says a word
  bench.write(kFlash + 0x0C, 0x40);
  const std::uint64_t before = bench.board.now_ns();
  bench.board.chip().store_to_flash(kWord, 4, 0x1234F00F);
  CHECK(bench.board.now_ns() - before == 16'000);
  bench.run(100);
  bench.board.chip().store_to_flash(kWord, 4, 0xFFFF00FF);  // bits only go to 0
  CHECK(word() == 0x1234000F);
  bench.run(100);
  bench.write(kFlash + 0x10, 2U << 8 | 5U << 3 | 2 | 1U << 16);
  CHECK(bench.board.now_ns() - before > 1'000'000'000);
  CHECK(word() == 0xFFFFFFFF);
  bench.run(100);
  CHECK((bench.read(kFlash + 0x0C) & 0x1'00FF) == 0);
}
