// Text to JSON tree: a strict RFC 8259 parser with line and column on every value and key.
#pragma once

#include <optional>

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/json/value.hpp"

namespace finemote::gen::json {

inline constexpr int kMaxDepth = 64;  ///< arrays and objects inside each other

/// Parses one file; a UTF-8 byte order mark is skipped. Reports FM4001 (syntax, or nested deeper than kMaxDepth) and
/// returns nothing; reports FM4002 for every repeated key and carries on with the first one.
std::optional<Value> parse(const SourceFile& file, Diagnostics& diagnostics);

}  // namespace finemote::gen::json
