// Random phases and clock errors of a robot's parts and its board, within what their data sheets allow.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "generator/descriptor/board.hpp"

namespace finemote::gen {

/// Which run of how many: the same numbers give the same run.
struct Phase {
  std::uint64_t seed = 0;
  std::uint64_t number = 0;
};

/// Gives every part that has a clock of its own a rate and a first moment, as the phase draws them. In half of the
/// phases all parts go together: what they send meets on the wire.
/// @param parts     entries of a scenario's `parts`
/// @param declared  how far the clock of a part may be off where its device's type says so, by its name [ppm]: no part
///                  is drawn further off than that
/// @param clock_ppm how far the board's clock may be off, both ways
/// @return  how far the board's clock is off in this run [ppm], positive: it runs fast
double shift_clocks(const Phase& phase, double clock_ppm, const std::map<std::string, double>& declared,
                    nlohmann::ordered_json& parts);

}  // namespace finemote::gen
