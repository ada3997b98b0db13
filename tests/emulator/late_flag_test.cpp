// Interrupt flags that are cleared late: which routines may be entered a second time for it, and which not.
#include "catch.hpp"
#include "emulator/board.hpp"

using namespace finemote::emulator;

namespace {

using Code = std::vector<std::uint16_t>;

// Thumb instructions of the routines: r0 is the base of TIM2 (APB1), r1 of USART6 (APB2), r2 of DMA1 (AHB1), r3 is 0.
constexpr std::uint16_t kClear = 0x6103;      // str r3, [r0, #0x10]: TIM2_SR
constexpr std::uint16_t kReadBack = 0x6904;   // ldr r4, [r0, #0x10]
constexpr std::uint16_t kReadOther = 0x688C;  // ldr r4, [r1, #8]: USART6_BRR
constexpr std::uint16_t kReadFast = 0x6894;   // ldr r4, [r2, #8]: DMA1_LIFCR
constexpr std::uint16_t kNop = 0xBF00, kReturn = 0x4770;
const Code kDsb = {0xF3BF, 0x8F4F}, kDmb = {0xF3BF, 0x8F5F};
const Code kUpdateAgain = {0x2401, 0x6144};  // movs r4, #1; str r4, [r0, #0x14]: TIM2_EGR
const Code kClearDma = {0x243D, 0x6094};     // movs r4, #0x3D; str r4, [r2, #8]: DMA1_LIFCR

constexpr int kTim2 = 28, kTim3 = 29, kDma1Stream0 = 11;

Code operator+(Code first, const Code& then) {
  first.insert(first.end(), then.begin(), then.end());
  return first;
}
Code nops(unsigned count) { return Code(count, kNop); }

/// An idle loop, and `routine` behind the vector of `line`.
Image image_of(int line, const Code& routine) {
  Segment segment{0x08000000, std::vector<std::uint8_t>(0x400, 0)};
  const auto word = [&](std::size_t at, std::uint32_t value) {
    for (unsigned i = 0; i < 4; ++i) segment.bytes[at + i] = static_cast<std::uint8_t>(value >> (8 * i));
  };
  word(0, 0x20001000);
  for (std::size_t at = 4; at < 0x188; at += 4) word(at, 0x08000189);
  word(0x188, 0xE7FEE7FE);
  word(4 * static_cast<std::size_t>(16 + line), 0x08000201);
  word(0x1F0, 0x40000000);
  word(0x1F4, 0x40011400);
  word(0x1F8, 0x40026000);
  word(0x1FC, 0);
  // ldr.w r0..r3, [pc, #-n]: the four words before it.
  const Code load = {0xF85F, 0x0014, 0xF85F, 0x1014, 0xF85F, 0x2014, 0xF85F, 0x3014};
  const Code all = load + routine + Code{kReturn};
  for (std::size_t i = 0; i < all.size(); ++i) {
    segment.bytes[0x200 + 2 * i] = static_cast<std::uint8_t>(all[i]);
    segment.bytes[0x201 + 2 * i] = static_cast<std::uint8_t>(all[i] >> 8);
  }
  Image image;
  image.segments.push_back(segment);
  return image;
}

struct Bench {
  Bench(int line, const Code& routine) {
    board.load(image_of(line, routine));
    board.run_for(1'000);
    write(0x40023830, 1U << 21);  // DMA1
    write(0x40023840, 3);         // TIM2, TIM3
    write(0x40023844, 1U << 5);   // USART6
    enable(line);
  }
  void write(std::uint32_t address, std::uint32_t value) { board.chip().write(address, 4, value); }
  void enable(int line) {
    board.world().system().write(0xE000E100 + 4 * static_cast<std::uint32_t>(line / 32), 4, 1U << (line % 32),
                                 board.world().now(), 0);
  }
  /// An update of TIM2 raises its line.
  Bench& update() {
    write(0x4000000C, 1);
    write(0x40000014, 1);
    board.run_for(20'000);
    return *this;
  }
  [[nodiscard]] bool late() {
    bool result = false;
    for (const Report& report : board.reports()) {
      INFO(name_of(report.misuse) << ": " << report.text);
      CHECK(report.misuse == Misuse::late_flag);
      result = result || report.misuse == Misuse::late_flag;
    }
    return result;
  }
  [[nodiscard]] unsigned entered(int line) { return board.world().system().nvic().times_entered(16 + line); }
  Board board;
};

bool late_after(const Code& end) {
  Bench bench(kTim2, Code{kClear} + end);
  const bool late = bench.update().late();
  CHECK(bench.entered(kTim2) == 1);
  return late;
}

/// The same with APB1 at a sixteenth of the core clock.
bool late_on_slow_bus(const Code& end) {
  Bench bench(kTim2, Code{kClear} + end);
  bench.write(0x40023808, 7U << 10);
  return bench.update().late();
}

}  // namespace

TEST_CASE("a flag cleared as the last thing of its routine is reported") {
  CHECK(late_after({}));
  CHECK(late_after({kNop}));
}

TEST_CASE("a read on the same bus or a DSB lets the write arrive first") {
  CHECK(!late_after({kReadBack}));
  CHECK(!late_after(kDsb));
}

TEST_CASE("a DMB, or a read on another bus, does not") {
  CHECK(late_after(kDmb));
  CHECK(late_after({kReadFast}));
  CHECK(late_on_slow_bus({kReadOther}));
}

TEST_CASE("time enough does too, and how much depends on the bus") {
  CHECK(!late_after(nops(8)));
  CHECK(late_on_slow_bus(nops(8)));
  CHECK(late_on_slow_bus(nops(40)));
  CHECK(!late_on_slow_bus(nops(60)));
}

TEST_CASE("a flag on the fast bus needs fewer cycles") {
  const auto late = [](const Code& end) {
    Bench bench(kDma1Stream0, kClearDma + end);
    bench.write(0x40026000 + 0x10, 1U << 4);      // TCIE
    bench.write(0x40026000 + 0x14, 1);            // one item
    bench.write(0x40026000 + 0x10, 1U << 4 | 1);  // on and off again: the end flag
    bench.write(0x40026000 + 0x10, 1U << 4);
    bench.board.run_for(20'000);
    CHECK(bench.entered(kDma1Stream0) == 1);
    return bench.late();
  };
  CHECK(late({}));
  CHECK(!late(nops(4)));
  CHECK(late_after(nops(3)));  // on APB1 at the core's clock
}

TEST_CASE("a line that has risen again enters its routine anyway") {
  Bench bench(kTim2, Code{kClear} + kUpdateAgain + Code{kClear});
  CHECK(!bench.update().late());
  CHECK(bench.entered(kTim2) > 1);
}

TEST_CASE("the line of another routine is not this one's") {
  Bench bench(kTim3, {kClear});
  bench.write(0x4000000C, 1);
  bench.write(0x40000014, 1);  // TIM2's line is up, and not enabled
  bench.write(0x4000040C, 1);
  bench.write(0x40000414, 1);
  bench.write(0x40000410, 0);  // TIM3 is pending, its flag is gone
  bench.board.run_for(20'000);
  CHECK(bench.entered(kTim3) == 1);
  CHECK(!bench.late());
}

TEST_CASE("a line lowered in the routine, but not by it, is no fault of it") {
  Bench bench(kTim2, nops(40));
  bench.write(0x4000000C, 1);
  bench.write(0x40000014, 1);
  bench.board.run_for(2'500);
  REQUIRE(bench.board.cpu().active_exceptions() == std::vector<int>{16 + kTim2});
  bench.board.world().set_line(kTim2, false);
  bench.board.run_for(20'000);
  CHECK(!bench.late());
}
