// What instructions, accesses and exceptions cost, and whose time it is. Expected cycles: Cortex-M4 TRM (DDI 0439)
// tables 3-1 and 7-1, sections 3.3.2 and 3.9.1; AN4031 2.2.
#include <cstring>
#include <iterator>
#include <memory>

#include "catch.hpp"
#include "tests/emulator/bench.hpp"

using namespace finemote::emulator;

namespace {

using Kind = ExecutionEvent::Kind;
constexpr int kLine = 28;
constexpr Time kCycle = period_of(16'000'000);         // after reset
constexpr std::uint32_t kBody = 0x08000210;            // after what loads r0 to r3
const Code kFpuOn = {0x6801, 0xF441, 0x0170, 0x6001};  // r0: CPACR; ldr r1, [r0]; orr r1, #0xF00000; str r1, [r0]

std::uint32_t bytes(const Code& code) { return static_cast<std::uint32_t>(2 * code.size()); }

/// Cycles of `code` as part of a routine that finds `words` in r0 to r3; `before` runs ahead of it.
unsigned cycles(const Code& code, const std::vector<std::uint32_t>& words = {0, 0, 0, 0}, const Code& before = {},
                FlashModel flash = FlashModel::hit) {
  BoardOptions options;
  options.flash = flash;
  Board board({}, options);
  ExecutionLog log;
  board.load(bench_image(1, before + code + Code{kNop, kNop, 0xE7FE}, words));
  board.cpu().set_log(&log);
  board.cpu().mark(kBody + bytes(before), 0);
  board.cpu().mark(kBody + bytes(before + code), 1);
  board.cpu().run_until(from_ns(100'000));
  REQUIRE(log.size() == 2);
  return static_cast<unsigned>((log[1].at - log[0].at) / kCycle);
}

/// A board whose main program uses floating point and then waits; line 28 goes to `first`, line 29, more urgent, to
/// `second`.
struct Nest {
  Nest(const Code& first, const Code& second) {
    Image image = bench_image(1, kFpuOn + kVadd + Code{0xE7FE}, {0xE000ED88, 0, 0, 0});
    put(image, 0x300, first + Code{kReturn}, kLine);
    put(image, 0x380, second + Code{kReturn}, kLine + 1);
    board.load(image);
    board.cpu().set_log(&log);
    auto& system = board.world().system();
    board.cpu().run_until(from_ns(50'000));
    system.write(0xE000E100, 4, 3U << kLine, 0, 0);
    system.nvic().set_priority(16 + kLine, 0x80);
    system.nvic().set_priority(16 + kLine + 1, 0x40);
    log.clear();
  }
  void pend(int line) {
    board.world().system().nvic().pend(16 + line);
    board.cpu().kick();
  }
  void run(std::uint64_t ns) { board.cpu().run_until(board.cpu().now() + from_ns(ns)); }
  /// Cycles of the exception of `line` from its first event to its last.
  [[nodiscard]] unsigned own(int line) const {
    OwnTimes times;
    times.add(log);
    return static_cast<unsigned>(times.exceptions().at(static_cast<unsigned>(16 + line)).longest / kCycle);
  }

  inline static const Code kVadd = {0xEE30, 0x0A81};
  Board board;
  ExecutionLog log;

 private:
  static void put(Image& image, std::uint32_t at, const Code& code, int line) {
    auto& flash = image.segments[0].bytes;
    for (std::size_t i = 0; i < code.size(); ++i) std::memcpy(&flash[at + 2 * i], &code[i], 2);
    const std::uint32_t entry = 0x08000000 + at + 1;
    std::memcpy(&flash[4 * static_cast<std::size_t>(16 + line)], &entry, 4);
  }
};

}  // namespace

TEST_CASE("a routine costs entry, return, and the registers of the floating-point code it interrupts if it uses some") {
  constexpr unsigned kEntry = 12, kReturnPlain = 10, kReturnFloat = 27, kSave = 17, kBranch = 1;
  Nest plain({kNop}, {kNop});
  plain.pend(kLine);
  plain.run(20'000);
  CHECK(plain.own(kLine) == kEntry + 1 + kBranch + kReturnPlain);
  Nest floating(Nest::kVadd, {kNop});
  floating.pend(kLine);
  floating.run(20'000);
  CHECK(floating.own(kLine) == kEntry + kSave + 1 + kBranch + kReturnFloat);
}

TEST_CASE("registers that nobody saved yet are saved by whoever uses floating point first, however deep") {
  Nest nest(Code(60, kNop), Nest::kVadd);
  nest.pend(kLine);
  nest.run(3'000);
  nest.pend(kLine + 1);
  nest.run(30'000);
  CHECK(nest.own(kLine + 1) == 12 + 17 + 1 + 1 + 10);  // its frame holds no such registers
  CHECK(nest.own(kLine) == 12 + 60 + 1 + 27);          // what was saved comes back
}

TEST_CASE("time belongs to whoever runs: an interrupted routine does not count what interrupted it") {
  Nest nest(Code(60, kNop), Code(20, kNop));
  nest.pend(kLine);
  nest.run(3'000);
  nest.pend(kLine + 1);
  nest.run(30'000);
  CHECK(nest.own(kLine) == 12 + 60 + 1 + 10);
  CHECK(nest.own(kLine + 1) == 12 + 20 + 1 + 10);
  const Kind expected[] = {Kind::due,   Kind::enter,  Kind::due,   Kind::enter,
                           Kind::leave, Kind::resume, Kind::leave, Kind::resume};
  REQUIRE(nest.log.size() == std::size(expected));
  for (std::size_t i = 0; i < nest.log.size(); ++i) CHECK(nest.log[i].kind == expected[i]);
}

TEST_CASE("a routine behind another is chained and stacks nothing") {
  Nest nest(Code(20, kNop), Code(20, kNop));
  nest.pend(kLine);
  nest.pend(kLine + 1);
  nest.run(30'000);
  CHECK(nest.own(kLine + 1) == 12 + 20 + 1);
  CHECK(nest.own(kLine) == 6 + 20 + 1 + 10);
}

TEST_CASE("an address that was just computed costs a cycle, and so does a floating-point result that is needed") {
  const std::vector<std::uint32_t> words = {0x20000000, 0x20000004, 0xE000ED88, 0};
  CHECK(cycles({0x3004, 0x6804}, words) == 1 + 2 + 1);  // adds r0, #4; ldr r4, [r0]
  CHECK(cycles({0x3104, 0x6804}, words) == 1 + 2);      // adds r1, #4; ldr r4, [r0]
  CHECK(cycles({0x3304, 0x58C4}, words) == 1 + 2 + 1);  // adds r3, #4; ldr r4, [r0, r3]
  CHECK(cycles({0x2400, 0x6004}, words) == 1 + 2);      // movs r4, #0; str r4, [r0]: not the address
  CHECK(cycles({0x6800, 0x6804}, {0x20000000, 0, 0, 0}, {0x6000}) == 2 + 2);  // a loaded address is no computed one
  const std::vector<std::uint32_t> fpu = {0xE000ED88, 0, 0, 0};
  CHECK(cycles({0xEE30, 0x0A81, 0xEE20, 0x1A00}, fpu, kFpuOn) == 1 + 1 + 1);  // vadd s0, s1, s2; vmul s2, s0, s0
  CHECK(cycles({0xEE30, 0x0A81, 0xEE21, 0x1A81}, fpu, kFpuOn) == 1 + 1);      // vmul s2, s3, s2
  CHECK(cycles({0xEE30, 0x0A81, 0xEE01, 0x0A81}, fpu, kFpuOn) == 1 + 3);      // vmla s0, s3, s2: only the addend
  CHECK(cycles({0xEEB4, 0x0A60, 0xEEF1, 0xFA10}, fpu, kFpuOn) == 1 + 1 + 1);  // vcmp s0, s1; vmrs
}

TEST_CASE("a jump refills the pipeline with three cycles") {
  CHECK(cycles({0xE7FF}) == 1);                    // b to the next instruction: no jump
  CHECK(cycles({0xE000, kNop}) == 1 + 3);          // over one
  CHECK(cycles({0x2800, 0xD000, kNop}) == 2 + 3);  // cmp r0, #0; beq over one
  CHECK(cycles({0x2801, 0xD000, kNop}) == 2 + 1);  // not taken
}

TEST_CASE("a jump to itself is charged turn by turn, and not run so") {
  const auto waiting = [](bool one_by_one) {
    auto board = std::make_unique<Board>();
    board->load(bench_image(1, {kNop, 0xE7FE}));
    board->run_for(1'000);
    if (one_by_one) board->cpu().set_probe([](std::uint32_t) {});
    board->world().at(from_ns(5'001), [] {});  // in the middle of an iteration
    board->run_for(100'000);
    return board;
  };
  const auto together = waiting(false), singly = waiting(true);
  CHECK(together->cpu().now() == singly->cpu().now());
  CHECK(together->cpu().instructions() == singly->cpu().instructions());
  CHECK(together->cpu().executed() < 50);
  CHECK(singly->cpu().executed() > 400);
  CHECK(together->cpu().idle_time() > from_ns(95'000));
}

TEST_CASE("registers that are saved late are on the account of who preempts, not of the stage that comes to it") {
  Nest nest(Nest::kVadd, {kNop});
  nest.board.cpu().mark(0x08000300, 0);
  nest.board.cpu().mark(0x08000300 + bytes(Nest::kVadd), 1);
  nest.pend(kLine);
  nest.run(50'000);
  OwnTimes own;
  own.add(nest.log);
  CHECK(own.brackets().at(0).longest == kCycle);
  CHECK(nest.own(kLine) == 12 + 17 + 1 + 1 + 27);
}

TEST_CASE("an access that is not aligned becomes several") {
  CHECK(cycles({0x6804}, {0x20000000, 0, 0, 0}) == 2);
  CHECK(cycles({0x6804}, {0x20000002, 0, 0, 0}) == 3);
  CHECK(cycles({0x6804}, {0x20000001, 0, 0, 0}) == 4);
  CHECK(cycles({0x8804}, {0x20000001, 0, 0, 0}) == 3);
  CHECK(cycles({0x8004}, {0x20000002, 0, 0, 0}) == 2);
}

TEST_CASE("peripherals wait for the bus matrix and their bridge, loads and stores alike") {
  const Code load = {0x6844}, store = {0x6044};                           // r4, [r0, #4]
  const std::vector<std::uint32_t> ahb = {0x40023800, 0, 0, 0};           // RCC
  const std::vector<std::uint32_t> apb = {0x40000000, 1, 0x40023840, 0};  // TIM2; r2: its clock
  const Code clock_on = {0x6011};                                         // str r1, [r2]
  CHECK(cycles(load, ahb) == 2 + 2);
  CHECK(cycles(store, {0x40023870, 0, 0, 0}) == 2 + 2);
  CHECK(cycles(load, apb, clock_on) == 2 + 4);  // the bus runs at the core's clock
  CHECK(cycles(store, apb, clock_on) == 2 + 4);
  const Code slow_bus = {0x6011, 0xF8D2, 0x4000};  // and a read that changes nothing
  CHECK(cycles(load, apb, slow_bus) == 2 + 4);
}

TEST_CASE("without the accelerator every line and every read of data in flash waits for the flash") {
  const auto missing = [](const Code& code, const std::vector<std::uint32_t>& words = {0, 0, 0, 0}) {
    return cycles(code, words, {}, FlashModel::miss_always);
  };
  CHECK(missing({kNop, kNop, kNop}) == 3);  // in the line that holds the mark
  CHECK(missing(Code(7, kNop)) == 7);
  CHECK(missing(Code(8, kNop)) == 8 + 5);  // a mark's instruction begins when it is there
  CHECK(missing({0x6804, kNop}, {0x08000000, 0, 0, 0}) == 2 + 5 + 1 + 5);  // the read, and the line it pushed out
}
