#include "generator/descriptor/whole_cycles.hpp"

#include <numeric>

namespace finemote::gen {

bool is_whole_cycles(const Board& board, Duration tick) {
  constexpr std::int64_t kSecond = seconds(1).ns();
  return tick.ns() % kSecond * board.cpu_hz % kSecond == 0;  // fits: below 1e9 times below 9e9
}

// Cycles come in steps of the reduced denominator.
Duration whole_tick_above(const Board& board, Duration tick) {
  return round_up(tick, floor_div(seconds(1), std::gcd(seconds(1).ns(), board.cpu_hz)));
}

}  // namespace finemote::gen
