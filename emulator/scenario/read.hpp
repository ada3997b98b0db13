// A scenario's text to a tree that can be played to its end, or to everything that is wrong with it.
#pragma once

#include <cstdint>
#include <optional>

#include "emulator/scenario/check.hpp"

namespace finemote::scenario {

/// Parses and checks a text. Reports what check() reports, FM6004 for what the parser finds, and as warnings FM6010
/// (events out of order, expectations after the end of the run) and FM6011 (neither parts, events nor expectations).
/// @return  the tree, or nothing after an error
std::optional<gen::json::Value> read(const gen::SourceFile& file, const World& world, gen::Diagnostics& diagnostics);

/// Time of the last event [ns since the first release]; 0 without events. The document was read without an error.
std::int64_t last_event_ns(const gen::json::Value& document);

}  // namespace finemote::scenario
