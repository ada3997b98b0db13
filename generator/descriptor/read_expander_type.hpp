// The descriptor of an expander to what the generator needs of it.
#pragma once

#include "generator/descriptor/expander_type.hpp"
#include "generator/descriptor/json_file.hpp"

namespace finemote::gen {

/// Reads a descriptor that its schema accepts. Reports FM3103 for members that do not go with its kind, and what
/// read_params() finds.
ExpanderType read_expander_type(const Json& value, const Origin& origin, Diagnostics& diagnostics);

}  // namespace finemote::gen
