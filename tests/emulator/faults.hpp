// The faults that the firmware of an emulated board has counted.
#pragma once

#include <set>

#include "emulator/board.hpp"

namespace finemote::test {

/// As module * 256 + number; runtime/src/faults.cpp keeps them.
inline std::set<unsigned> faults_of(emulator::Board& board) {
  std::set<unsigned> faults;
  for (unsigned i = 0; i < 16; ++i) {
    const std::uint32_t word = board.word("_ZN8finemote12_GLOBAL__N_17recordsE", 4 * i);
    if (word != 0) faults.insert(word >> 16);
  }
  return faults;
}

}  // namespace finemote::test
