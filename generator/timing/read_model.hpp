// JSON to timing model: the strict reader of the case format and of its documented extensions (docs/timing.md).
#pragma once

#include <optional>

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/timing/model.hpp"

namespace finemote::gen::timing {

/// Reads a model object, or the `model` member of a case file (whose other members may only be `name`, `description`
/// and `expected`). Every mistake is reported where it stands: FM4001 to FM4014. Nothing when `diagnostics` has errors.
std::optional<Model> read_model(const SourceFile& file, Diagnostics& diagnostics);

}  // namespace finemote::gen::timing
