// Interrupt flags that are cleared late: which routines may be entered a second time for it, and which not.
#include "catch.hpp"
#include "tests/emulator/bench.hpp"

using namespace finemote::emulator;

namespace {

// Thumb instructions of the routines: r0 is the base of TIM2 (APB1), r1 of USART6 (APB2), r2 of DMA1 (AHB1), r3 is 0.
constexpr std::uint16_t kClear = 0x6103;      // str r3, [r0, #0x10]: TIM2_SR
constexpr std::uint16_t kReadBack = 0x6904;   // ldr r4, [r0, #0x10]
constexpr std::uint16_t kReadOther = 0x688C;  // ldr r4, [r1, #8]: USART6_BRR
constexpr std::uint16_t kReadFast = 0x6894;   // ldr r4, [r2, #8]: DMA1_LIFCR
const Code kDsb = {0xF3BF, 0x8F4F}, kDmb = {0xF3BF, 0x8F5F};
const Code kUpdateAgain = {0x2401, 0x6144};  // movs r4, #1; str r4, [r0, #0x14]: TIM2_EGR
const Code kClearDma = {0x243D, 0x6094};     // movs r4, #0x3D; str r4, [r2, #8]: DMA1_LIFCR

constexpr int kTim2 = 28, kTim3 = 29, kDma1Stream0 = 11;

Code nops(unsigned count) { return Code(count, kNop); }

/// A board on which only `line` is enabled.
struct Routine : Bench {
  Routine(int line, const Code& code)
      : Bench(bench_image(static_cast<std::size_t>(16 + line), code + Code{kReturn},
                          {0x40000000, 0x40011400, 0x40026000, 0})) {
    write(0x40023830, 1U << 21);  // DMA1
    write(0x40023840, 3);         // TIM2, TIM3
    write(0x40023844, 1U << 5);   // USART6
    enable_line(line);
  }
  /// An update of TIM2 raises its line.
  Routine& update() {
    write(0x4000000C, 1);
    write(0x40000014, 1);
    run(20'000);
    return *this;
  }
  /// Reported as late; nothing else may be.
  [[nodiscard]] bool late() const {
    for (const Report& report : board.reports()) CHECK(std::string(name_of(report.misuse)) == "late-flag");
    return !board.reports().empty();
  }
};

bool late_after(const Code& end) {
  Routine bench(kTim2, Code{kClear} + end);
  const bool late = bench.update().late();
  CHECK(bench.entered(kTim2) == 1);
  return late;
}

/// The same with APB1 at a sixteenth of the core clock.
bool late_on_slow_bus(const Code& end) {
  Routine bench(kTim2, Code{kClear} + end);
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
    Routine bench(kDma1Stream0, kClearDma + end);
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
  Routine bench(kTim2, Code{kClear} + kUpdateAgain + Code{kClear});
  CHECK(!bench.update().late());
  CHECK(bench.entered(kTim2) > 1);
}

TEST_CASE("the line of another routine is not this one's") {
  Routine bench(kTim3, {kClear});
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
  Routine bench(kTim2, nops(40));
  bench.write(0x4000000C, 1);
  bench.write(0x40000014, 1);
  bench.board.run_for(2'500);
  REQUIRE(bench.board.cpu().active_exceptions() == std::vector<int>{16 + kTim2});
  bench.board.world().set_line(kTim2, false);
  bench.board.run_for(20'000);
  CHECK(!bench.late());
}
