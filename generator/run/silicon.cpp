#include "generator/run/silicon.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "emulator/silicon/strictness.hpp"

namespace finemote::gen {

std::optional<Phase> clocks_of(const SiliconChoice& choice) {
  const std::string wanted = emulator::info_of(emulator::Strictness::clock_rates).name;
  if (std::find(choice.names.begin(), choice.names.end(), wanted) == choice.names.end()) return std::nullopt;
  return Phase{choice.seed, 0};
}

nlohmann::ordered_json silicon_json(const SiliconChoice& choice) {
  return {{"names", choice.names}, {"seed", choice.seed}};
}

}  // namespace finemote::gen
