// Runs any image for the chip, FineMote's or not, and tells what its pins, timers and buses did and what the parts saw.
#pragma once

#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace finemote::emulator {

struct WatchOptions {
  std::string image;     ///< an ELF file
  std::string board;     ///< a board's name or file, with its parts; empty: the bare chip
  std::string scenario;  ///< a document finemote.scenario/1; empty: nothing else hangs on the board
  std::uint64_t duration_ns = 1'000'000'000;  ///< from power-on; events of the scenario lengthen it
  std::uint32_t crystal_hz = 0;               ///< 0: the board's; of the bare chip 12 MHz
  bool dead_crystal = false;                  ///< it never starts
  bool flash_misses = false;
  std::vector<std::string> silicon;  ///< which freedom the chip uses: names of emulator/silicon/strictness.hpp
  std::uint64_t seed = 1;            ///< and how much
  bool as_document = false;          ///< writes one JSON document finemote.emulator/1 and nothing else
};

/// Writes one line per event, in order: time since power-on [ns], who, what; and after the last byte of a line of text
/// on a serial line that line. Then, each line beginning with `#`, how it ended, clocks, what the image did that the
/// hardware would not forgive, and what the parts saw.
/// @return  whether it ran to the end, and as the scenario expects; reports alone do not count
/// @throws std::exception  image, board or scenario cannot be used
bool watch(const WatchOptions& options, std::ostream& out);

}  // namespace finemote::emulator
