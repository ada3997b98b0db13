// `strict` and `strict:NAME,..` to the ways in which the emulated chip is meaner than its manual reads.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/run/phase.hpp"

namespace finemote::gen {

struct SiliconChoice {
  std::vector<std::string> names;  ///< in the order of the emulator's list; empty: as the manual reads
  std::uint64_t seed = 0;          ///< how much each time
};

/// The names that were asked for, all of them with `strict` alone, none with an empty text. Reports words that are no
/// names as wrong usage.
std::optional<std::vector<std::string>> parse_silicon(const std::string& text, Diagnostics& diagnostics);

/// How the clocks of board and parts are off where nobody asks for phases; none: they are exact.
std::optional<Phase> clocks_of(const SiliconChoice& choice);

/// `{names, seed}`, as in jobs of the emulator and in finemote.run/1.
nlohmann::ordered_json silicon_json(const SiliconChoice& choice);

}  // namespace finemote::gen
