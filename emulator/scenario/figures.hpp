// Figures of a part's entry to what is wrong with them together.
#pragma once

#include "emulator/scenario/grammar.hpp"
#include "generator/diagnostic/diagnostics.hpp"
#include "generator/json/value.hpp"

namespace finemote::scenario {

/// Reports FM6004 (an expander without a channel) and FM6009 (a neutral pulse outside its range, no inertia) at the
/// member that says so. Single values are judged elsewhere.
void check_figures(const gen::json::Value& entry, const Model& model, gen::Diagnostics& diagnostics);

}  // namespace finemote::scenario
