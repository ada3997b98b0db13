// Latches on the emulated core: the other side is made pending after every single instruction of publish and snapshot.
#include <cstring>

#include "catch.hpp"
#include "tests/emulator/fixture.hpp"
#include "tests/emulator/tested_chip.hpp"
#include "tests/emulator/type_c.hpp"

using namespace finemote::emulator;

namespace {

enum Kind : std::uint32_t { kToSlow, kToFast, kNaive };
constexpr int kFast = 16 + 48, kSlow = 16 + 49;

struct Result {
  std::uint32_t mixtures, steps_back, stale, slow_runs, fast_runs;
  unsigned longest = 0;  ///< instructions of the slow side, uninterrupted count
};

/// Runs jobs of the slow side until `step(job, instruction)` has seen every instruction of it. The step says whether
/// the fast side is to be pended before that instruction.
template <class Step>
Result run(Kind kind, Step step) {
  const Image image = test_image("latch");
  Board board{finemote::test::type_c(), finemote::test::tested_chip()};
  board.load(image);
  board.cpu().interrupt_it_blocks(true);  // also between the instructions of an IT block, should the compiler make one
  finemote::test::run_to_first_release(board);
  const std::uint32_t entry = image.symbol("slow_side")->address, value = kind;
  std::memcpy(board.cpu().memory(image.symbol("latch_kind")->address, 4), &value, 4);
  unsigned job = 0, instruction = 0, longest = 0;
  std::uint32_t back = 0;
  bool inside = false, resumed = false;
  board.cpu().set_probe([&](std::uint32_t pc) {
    const auto& active = board.cpu().active_exceptions();
    if (active.empty() || active.back() != kSlow) return;
    if (pc == entry) {
      inside = true;
      instruction = 0;
      ++job;
      back = board.cpu().register_value(14) & ~1U;
    }
    if (inside && pc == back) {
      inside = false;
      if (instruction > longest) longest = instruction;
    }
    if (!inside) return;
    if (!resumed && step(job, instruction)) {
      board.world().system().nvic().pend(kFast);
      board.cpu().kick();
      resumed = true;  // the probe comes here once more, after the return
      return;
    }
    resumed = false;
    ++instruction;
  });
  while (job <= longest + 3) {
    const unsigned before = job;
    REQUIRE(board.run_for(10'000'000) == Stop::time);
    REQUIRE(job > before);
  }
  return Result{board.word("mixtures"),  board.word("steps_back"), board.word("stale"),
                board.word("slow_runs"), board.word("fast_runs"),  longest};
}

/// Job n is interrupted once, before its instruction n.
bool once(unsigned job, unsigned instruction) { return instruction + 1 == job; }

void check_interrupted_once(Kind kind) {
  const Result result = run(kind, once);
  CHECK(result.longest > 40);
  CHECK(result.fast_runs + 1 >= result.longest);  // every instruction, but perhaps one of the longest job
  CHECK(result.mixtures == 0);
  CHECK(result.steps_back == 0);
  CHECK(result.stale == 0);
}

}  // namespace

TEST_CASE("a latch read by the slow side is whole and fresh wherever the writer interrupts") {
  check_interrupted_once(kToSlow);
}

TEST_CASE("a latch written by the slow side is whole and fresh wherever the reader interrupts") {
  check_interrupted_once(kToFast);
}

TEST_CASE("latches stay whole when every instruction of a job is interrupted, or any two") {
  for (const Kind kind : {kToSlow, kToFast}) {
    const Result every = run(kind, [](unsigned, unsigned) { return true; });
    CHECK(every.mixtures + every.steps_back + every.stale == 0);
    const Result two =
        run(kind, [](unsigned job, unsigned i) { return i + 1 == job || i == 2 * job || (i > 3 && i + 3 == job); });
    CHECK(two.mixtures + two.steps_back + two.stale == 0);
  }
}

TEST_CASE("the same test catches a latch without slots") {
  const Result result = run(kNaive, once);
  CHECK(result.mixtures > 5);
}
