// Where a file holds a timing model: by itself, or as a case, which stands beside what is expected of it.
#pragma once

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/json/value.hpp"

namespace finemote::gen::timing {

/// The model object of a file with this root: the root, or its `model` member. Null after FM4003 or FM4005 was
/// reported: it is no object, or a case has a member it should not have.
const json::Value* model_object(const json::Value& root, Diagnostics& diagnostics);

}  // namespace finemote::gen::timing
