// Which freedom of its manual the emulated chip of a run uses.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "generator/run/phase.hpp"

namespace finemote::gen {

struct SiliconChoice {
  std::vector<std::string> names;  ///< in the order of the emulator's list; empty: as the manual reads
  std::uint64_t seed = 0;          ///< how much each time
};

/// How the clocks of board and parts are off where nobody asks for phases; none: they are exact.
std::optional<Phase> clocks_of(const SiliconChoice& choice);

/// `{names, seed}`, as in jobs of the emulator and in finemote.run/1.
nlohmann::ordered_json silicon_json(const SiliconChoice& choice);

}  // namespace finemote::gen
