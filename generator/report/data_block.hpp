// A timeline to the data that the script of a report draws from.
#pragma once

#include <string>

#include "generator/report/place.hpp"
#include "generator/report/timeline.hpp"

namespace finemote::gen::report {

/// JSON to stand in an element `<script>`. Times are in nanoseconds; lists of slices are flat, with as many numbers for
/// each as the reader in templates/report/timeline.js takes.
std::string data_block(const timing::Model& model, const Timeline& timeline, const std::string& profile);

/// JSON as text that may stand in an element `<script>`: nothing in it ends the element.
std::string script_text(const Json& json);

}  // namespace finemote::gen::report
