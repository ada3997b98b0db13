// How often loops iterate, counted from outside.
#include "emulator/core/loop_counts.hpp"
#include "catch.hpp"

using namespace finemote::emulator;

namespace {

using Kind = ExecutionEvent::Kind;

ExecutionEvent pass(std::size_t loop) { return {0, LoopCounts::number_of(loop, false), Kind::loop}; }
ExecutionEvent border(std::size_t loop) { return {0, LoopCounts::number_of(loop, true), Kind::loop}; }
ExecutionEvent event(Kind kind, std::uint32_t exception) { return {0, exception, kind}; }

std::uint64_t most(const LoopCounts& counts, std::size_t loop) {
  const auto found = counts.most().find(loop);
  return found == counts.most().end() ? 0 : found->second;
}

}  // namespace

TEST_CASE("a loop begins anew at its borders, and others have counts of their own") {
  LoopCounts counts;
  counts.add({border(0), pass(0), pass(0), pass(1), border(0), pass(0), pass(0), pass(0)});
  counts.add({border(0), pass(0)});
  CHECK(most(counts, 0) == 3);
  CHECK(most(counts, 1) == 1);
  CHECK(most(counts, 2) == 0);
}

TEST_CASE("a loop that is interrupted by a routine with the same loop goes on with its own count") {
  LoopCounts counts;
  counts.add({border(0), pass(0), pass(0), event(Kind::enter, 20), pass(0), pass(0), pass(0), event(Kind::leave, 20),
              event(Kind::resume, 20), pass(0), pass(0), border(0)});
  CHECK(most(counts, 0) == 4);
}

TEST_CASE("a routine that follows another without a return between them begins anew") {
  LoopCounts counts;
  counts.add({event(Kind::enter, 20), pass(0), pass(0), event(Kind::leave, 20), event(Kind::tail, 21), pass(0),
              event(Kind::leave, 21), event(Kind::resume, 21), pass(0)});
  CHECK(most(counts, 0) == 2);
}

TEST_CASE("a reset ends every loop") {
  LoopCounts counts;
  counts.add({pass(0), event(Kind::enter, 20), pass(0), pass(0), event(Kind::reset, 0), pass(0),
              event(Kind::resume, 20), pass(0)});
  CHECK(most(counts, 0) == 2);
}

TEST_CASE("a loop that interrupts make go round once more may do so once for each") {
  LoopCounts counts;
  counts.allow_interrupts(0);
  counts.add({event(Kind::enter, 20), border(0), pass(0), event(Kind::enter, 30), pass(0), event(Kind::leave, 30),
              event(Kind::resume, 30), pass(0), border(0)});
  CHECK(most(counts, 0) == 1);
  counts.add({pass(0), pass(0), pass(0)});  // the interrupt may have come before its entry
  CHECK(most(counts, 0) == 2);
  counts.add({event(Kind::leave, 20), event(Kind::tail, 21), pass(0), pass(0), pass(0)});
  CHECK(most(counts, 0) == 3);
}
