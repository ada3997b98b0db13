// Turns any image for the chip into lines about what its pins, timers and serial buses did: for images that are not
// FineMote's, or to look at one closely.
#pragma once

#include <cstdint>
#include <ostream>
#include <string>

namespace finemote::emulator {

struct WatchOptions {
  std::string image;                          ///< an ELF file
  std::string board;                          ///< a board file; empty: the bare chip
  std::string scenario;                       ///< a document finemote.scenario/1; empty: nothing hangs on the board
  std::uint64_t duration_ns = 1'000'000'000;  ///< from power-on; events of the scenario lengthen it
  std::uint32_t crystal_hz = 0;               ///< 0: the board's; of the bare chip 12 MHz
  bool flash_misses = false;
};

/// Writes one line per event, in order: time since power-on [ns], who, what. Then, each line beginning with `#`, how it
/// ended, clocks, and what the image did that the hardware would not forgive.
/// @return whether it ran to the end of the time without such misuse
/// @throws std::exception  the image cannot be loaded, or the scenario has a mistake
bool watch(const WatchOptions& options, std::ostream& out);

}  // namespace finemote::emulator
