// The chip that a test of drivers runs on: as its manual reads, or, where FINEMOTE_SILICON holds a seed, strict in
// every way.
#pragma once

#include <cstdlib>
#include <string>
#include <vector>

#include "emulator/board.hpp"

namespace finemote::test {

inline std::vector<emulator::Strictness> all_ways() {
  std::vector<emulator::Strictness> ways;
  for (const emulator::StrictnessInfo& info : emulator::strictnesses()) ways.push_back(info.strictness);
  return ways;
}

/// @param options  whose silicon is replaced
inline emulator::BoardOptions tested_chip(emulator::BoardOptions options = {}) {
  const char* seed = std::getenv("FINEMOTE_SILICON");
  if (seed != nullptr) options.silicon = emulator::Silicon(all_ways(), std::stoull(seed));
  return options;
}

/// Runs on up to the first release, or for a second: oscillators take their time on some chips.
inline void run_to_first_release(emulator::Board& board) {
  constexpr int kSysTick = 15;
  const emulator::Nvic& nvic = board.world().system().nvic();
  for (unsigned step = 0; step < 100'000 && nvic.times_entered(kSysTick) == 0; ++step) board.run_for(10'000);
}

}  // namespace finemote::test
