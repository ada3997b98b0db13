// Ends a command: prints the findings and settles the exit status.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "generator/cli/context.hpp"

namespace finemote::gen {

/// The findings as text, coloured when the options and the terminal say so.
std::string render_findings(const Context& context);
std::string render_findings(const Context& context, const Diagnostics& findings);

/// Prints the findings as the options say and returns the exit status: kExitInvalid when there are errors (or warnings
/// under -W error), else `status`. With --format json `document` is printed to stdout, with the findings in its
/// `diagnostics`, unless the status is 2 or 3; a null document prints nothing.
int finish(Context& context, int status, nlohmann::ordered_json document = nullptr);

}  // namespace finemote::gen
