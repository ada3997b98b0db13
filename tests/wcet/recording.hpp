// A run on the emulated board to the ways its exceptions took through the code. Knows nothing of bounds.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace finemote::test {

struct Passage {
  enum class Kind : std::uint8_t {
    begin,   ///< `value`: the exception; its first instruction is next; at: when stacking began
    first,   ///< the first instruction of a routine; `value`: its address; at: when it begins
    block,   ///< an instruction that was jumped to, or that is in the set of borders; `value`: its address
    mark,    ///< `value`: number of runtime/include/finemote/mark.hpp
    leave,   ///< the routine's last instruction has ended; `value`: the exception
    resume,  ///< unstacking has ended
  };
  std::uint64_t at = 0;  ///< steps of 1/42 ns since power-on
  std::uint32_t value = 0;
  Kind kind = Kind::block;
  bool is_tail = false;  ///< begin: directly after another routine; nothing is resumed in between
  bool is_high = false;  ///< begin, block: the peripheral holds the line up
};

struct Recording {
  std::vector<Passage> passages;
  std::uint64_t cycle = 250;         ///< of the core, in the steps of `at`
  std::uint64_t ready_at = 0;        ///< the end of the bring-up
  nlohmann::ordered_json record;     ///< what the run reports: emulator/program/job.hpp
  std::vector<std::string> changed;  ///< words that were to keep a value and did not
};

/// Where to look, besides at jumps.
struct Watched {
  std::vector<std::uint32_t> borders;            ///< addresses of instructions
  std::map<std::uint32_t, std::uint32_t> words;  ///< in memory, and what they must hold whenever a routine begins
  std::uint32_t words_from = 0;                  ///< the exception that is the first which must find them so
};

/// Runs a job of `finemote run` (emulator/program/job.hpp).
Recording record_job(const nlohmann::ordered_json& job, const Watched& watched);

}  // namespace finemote::test
