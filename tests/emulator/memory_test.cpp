// What the emulated core sees of memory: SRAM1 at address 0 (RM0090 9.2.1), code in it that changes, and the memory
// protection unit (PM0214 4.2).
#include <cstring>

#include "catch.hpp"
#include "tests/emulator/bench.hpp"

using namespace finemote::emulator;

namespace {

constexpr std::uint32_t kApb2 = 0x40023844, kMap = 0x40013800, kRam = 0x20000000, kCode = 0x100;
constexpr std::uint32_t kMpuControl = 0xE000ED94, kMpuNumber = 0xE000ED98, kMpuBase = 0xE000ED9C,
                        kMpuAttributes = 0xE000EDA0, kFaultStatus = 0xE000ED28, kFaultAddress = 0xE000ED34;
constexpr int kMemoryFault = 4;
/// What the reset routine of `bench_image` ends with here: a jump to what r0 holds.
const Code kJump = {0x4700};

/// A board whose reset routine jumps to `code` in SRAM1, which stands at 0. r0 to r3 hold where it is and `words`.
struct SramBoard {
  explicit SramBoard(const Code& code, const std::vector<std::uint32_t>& words = {0, 0, 0},
                     FlashModel flash = FlashModel::hit, std::uint32_t jump = kCode)
      : board({}, options(flash)) {
    std::vector<std::uint32_t> all{jump + 1};
    all.insert(all.end(), words.begin(), words.end());
    board.load(bench_image(1, kJump, all));
    std::memcpy(board.cpu().memory(kRam + kCode, 2 * static_cast<std::uint32_t>(code.size())), code.data(),
                2 * code.size());
    board.chip().write(kApb2, 4, 1U << 14);
    board.chip().write(kMap, 4, 3);
    core(0xE000ED08, 0x08000000);  // VTOR
    board.cpu().set_log(&log);
  }
  static BoardOptions options(FlashModel flash) {
    BoardOptions options;
    options.flash = flash;
    return options;
  }
  void core(std::uint32_t address, std::uint32_t value) { board.world().system().write(address, 4, value, 0, 0); }
  std::uint32_t core(std::uint32_t address) { return board.world().system().read(address, 4, 0, 0); }
  void region(std::uint32_t number, std::uint32_t base, std::uint32_t attributes) {
    core(kMpuNumber, number);
    core(kMpuBase, base);
    core(kMpuAttributes, attributes | 1);
  }
  void run() { board.cpu().run_until(from_ns(100'000)); }
  [[nodiscard]] bool faulted() { return board.world().system().nvic().times_entered(kMemoryFault) != 0; }

  ExecutionLog log;
  Board board;
};

/// 128 KiB, read only, without its last eighth.
constexpr std::uint32_t kReadOnlyCode = 5U << 24 | 0x80U << 8 | 16U << 1, kExecuteNever = 1U << 28;

}  // namespace

TEST_CASE("SRAM1 stands at 0 once it is mapped there, and the flash again after a reset") {
  SramBoard it({kNop});
  Cpu& cpu = it.board.cpu();
  CHECK(cpu.memory(kCode, 4) == cpu.memory(kRam + kCode, 4));
  CHECK(cpu.memory(0x1BFFC, 4) != nullptr);
  CHECK(cpu.memory(0x1C000, 4) == nullptr);  // SRAM2 does not
  it.board.press_reset();
  CHECK(cpu.memory(kCode, 4) == cpu.memory(0x08000000 + kCode, 4));
}

TEST_CASE("code in SRAM costs no wait states, whatever the flash does") {
  const Code code = {0x3301, 0x4A00, 0x3301, 0x3301, 0x3301, 0x3301, 0x3301, 0x3301, 0x3301, 0x3301, 0xE7FE};
  Time took[2];
  for (const FlashModel flash : {FlashModel::hit, FlashModel::miss_always}) {
    SramBoard it(code, {0, 0, 0}, flash);
    it.board.cpu().mark(kCode, 0);
    it.board.cpu().mark(kCode + 20, 1);
    it.run();
    REQUIRE(it.log.size() == 2);
    took[flash == FlashModel::hit ? 0 : 1] = it.log[1].at - it.log[0].at;
  }
  CHECK(took[0] == 11 * period_of(16'000'000));  // nine additions and a literal
  CHECK(took[1] == took[0]);
}

TEST_CASE("code that is written over runs as it was written") {
  // begin: adds r3, #1; strh r2, [r1]; cmp r3, #8; blt begin; b .
  const Code code = {0x3301, 0x800A, 0x2B08, 0xDBFB, 0xE7FE};
  for (const std::uint32_t at : {kCode, kRam + kCode}) {  // by either address
    SramBoard it(code, {at, 0x3305, 0});                  // adds r3, #5
    it.run();
    CHECK(it.board.cpu().register_value(3) == 1 + 5 + 5);
  }
}

TEST_CASE("DMA writes code over, too, and does not know SRAM at 0") {
  Bench bench;
  bench.write(0x40023830, 1U << 22);
  constexpr std::uint32_t kDma2 = 0x40026400;
  const auto move = [&bench](std::uint32_t to) {
    bench.write(kDma2 + 0x10 + 0x00, 0);
    bench.write(kDma2 + 0x08, 0x3D);
    bench.write(kDma2 + 0x10 + 0x08, 0x08000000);
    bench.write(kDma2 + 0x10 + 0x0C, to);
    bench.write(kDma2 + 0x10 + 0x04, 1);
    bench.write(kDma2 + 0x10, 2U << 13 | 2U << 11 | 2U << 6 | 1);
    bench.run(10'000);
  };
  move(kRam + kCode);
  CHECK_FALSE(bench.reported(Misuse::dma_unreachable));
  move(kCode);
  CHECK(bench.reported(Misuse::dma_unreachable));
}

TEST_CASE("a write to a region that is read only is a memory fault, and nothing is written") {
  for (const std::uint32_t at : {0x200U, kRam + 0x200U}) {
    SramBoard it({0x600A, 0xE7FE}, {at, 0x12345678, 0});  // str r2, [r1]
    it.region(2, kRam, kReadOnlyCode | kExecuteNever);
    it.region(3, 0, kReadOnlyCode);
    it.core(0xE000ED24, 1U << 16);
    it.core(kMpuControl, 5);
    it.board.chip().write(kMap, 4, 3);  // the core looks at its memory again
    it.run();
    CHECK(it.faulted());
    CHECK((it.core(kFaultStatus) & 0xFF) == 0x82);
    CHECK(it.core(kFaultAddress) == at);
    std::uint32_t word = 0;
    std::memcpy(&word, it.board.cpu().memory(kRam + 0x200, 4), 4);
    CHECK(word != 0x12345678);
  }
}

TEST_CASE("what stands in a part of a region that is turned off, or in none, may be written") {
  SramBoard it({0x600A, 0xE7FE}, {0x2001C000, 0x12345678, 0});
  it.region(2, kRam, kReadOnlyCode | kExecuteNever);
  it.core(kMpuControl, 5);
  it.board.chip().write(kMap, 4, 3);
  it.run();
  CHECK_FALSE(it.faulted());
  std::uint32_t word = 0;
  std::memcpy(&word, it.board.cpu().memory(0x2001C000, 4), 4);
  CHECK(word == 0x12345678);
}

TEST_CASE("where nothing may be executed a jump is a memory fault") {
  SramBoard it({kNop, 0xE7FE}, {0, 0, 0}, FlashModel::hit, kRam + kCode);
  it.region(1, kRam, 3U << 24 | 28U << 1 | kExecuteNever);
  it.core(0xE000ED24, 1U << 16);
  it.core(kMpuControl, 5);
  it.board.chip().write(kMap, 4, 3);
  it.run();
  CHECK(it.faulted());
  CHECK((it.core(kFaultStatus) & 0xFF) == 0x01);
}

TEST_CASE("where the image has asked for it, an access that is not aligned is a usage fault") {
  constexpr int kUsageFault = 6;
  constexpr std::uint32_t kUnaligned = 1U << 24, kPeripheral = 0x40020000;
  for (const std::uint32_t trap : {0U, 8U}) {
    for (const std::uint32_t at : {kRam + 0x201, kRam + 0x202, kPeripheral + 2, kRam + 0x204}) {
      for (const std::uint16_t access : {0x681C, 0x601C}) {  // ldr r4, [r3]; str r4, [r3]
        CAPTURE(trap, at, access);
        SramBoard it({0x600A, access, 0xE7FE}, {0xE000ED14, 0x200 | trap, at});  // str r2, [r1]
        it.core(0xE000ED24, 1U << 18);
        it.run();
        const bool is_fault = trap != 0 && at % 4 != 0;
        CHECK((it.board.world().system().nvic().times_entered(kUsageFault) != 0) == is_fault);
        CHECK(it.core(kFaultStatus) == (is_fault ? kUnaligned : 0));
      }
    }
  }
}
