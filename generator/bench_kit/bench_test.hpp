// One measurement of the bench kit: its name, what is expected of it, and on what ground.
#pragma once

#include <cstdint>
#include <string>

namespace finemote::gen {

/// What stands behind an expectation. Never what the emulator computes with: a measurement has to be able to
/// contradict.
enum class Ground : std::uint8_t {
  data_sheet,  ///< limits the maker states
  manual,      ///< what the reference manual says happens
  board_file,  ///< the board's wiring and clocks
  measured,    ///< on the emulated board, whose times come from instruction counts
  declared,    ///< by whoever described the robot
  assumed,     ///< written down, and believed
};

/// For people: `data sheet`.
const char* ground_words(Ground ground);

struct BenchTest {
  std::string group;  ///< tests of one procedure on the target, `clocks`
  std::string name;   ///< `clock.core_hz`: subject, then what is counted and its unit
  std::int64_t least = 0, most = 0;
  Ground ground = Ground::assumed;
  std::string source;      ///< of the expectation, for people
  std::string needs = {};  ///< what a bare board lacks for it: `jumper J1`; empty: nothing
  bool is_judged = true;   ///< false: measured, and nothing is claimed of it
};

}  // namespace finemote::gen
