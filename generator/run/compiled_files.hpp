// What the compiler read for an image, as it says itself.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/run/build_firmware.hpp"

namespace finemote::gen {

/// Files that were compiled into the image that was built last in the work folder: canonical paths, sorted, without
/// those that were generated, that come with finemote, or with the compiler. Files that an assembler reads are not
/// among them. Reports FM6001 where Ninja does not say.
std::optional<std::vector<std::string>> compiled_files(const FirmwareRequest& request, Diagnostics& diagnostics);

/// Whether `known` has all of them, the paths of which may be written in any way; else reports FM6017.
bool are_known(const std::vector<std::string>& compiled, const std::vector<std::string>& known,
               Diagnostics& diagnostics);

}  // namespace finemote::gen
