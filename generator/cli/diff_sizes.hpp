// A robot to the sizes of its image, for `finemote diff --sizes`.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "generator/cli/diff_facts.hpp"
#include "generator/output/folder.hpp"
#include "generator/run/image_facts.hpp"

namespace finemote::gen {

/// Compiles the generated files for the robot's own board, in a temporary folder, as `run --build-only` does.
/// Reports what make_proven_image reports.
std::optional<ImageFacts> built_image(const Robot& robot, Output generated, const std::string& data_dir,
                                      Sources& sources, Diagnostics& diagnostics);

/// Bytes of flash, of variables and of proven stack.
void add_image(const ImageFacts& image, Facts& facts);

/// `flash`, `ram` and `stack`, in bytes; null for a stack without bound, and for no image.
nlohmann::ordered_json json_of(const std::optional<ImageFacts>& image);

}  // namespace finemote::gen
