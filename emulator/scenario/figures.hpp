// Figures of a part's entry, for what has to be said of several of them together.
#pragma once

#include <optional>
#include <string>

#include "emulator/scenario/grammar.hpp"

namespace finemote::scenario {

/// A number of an entry that may have mistakes, or what is usual for it; none: it has none, or it is no such number.
std::optional<double> figure(const gen::json::Value& entry, const Model& model, const char* key);

/// A string of an entry that may have mistakes; null: it has none, or another type.
const gen::json::Value* word_in(const gen::json::Value& entry, const char* key);

}  // namespace finemote::scenario
