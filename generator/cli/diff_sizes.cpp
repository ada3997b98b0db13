#include "generator/cli/diff_sizes.hpp"

#include <fmt/format.h>

#include "generator/run/project.hpp"
#include "generator/run/proven_image.hpp"
#include "generator/run/work_folder.hpp"

namespace finemote::gen {

using Json = nlohmann::ordered_json;

std::optional<ImageFacts> built_image(const Robot& robot, Output generated, const std::string& data_dir,
                                      Sources& sources, Diagnostics& diagnostics) {
  const WorkFolder work({}, diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  const FirmwareRequest request = firmware_of(robot, work.path(), data_dir);
  const Project project = make_project(request, std::move(generated), robot, nullptr);
  const auto image = make_proven_image(project, robot, nullptr, sources, diagnostics);
  return image ? std::optional(image->facts) : std::nullopt;
}

void add_image(const ImageFacts& image, Facts& facts) {
  facts["size of the image"] = {{"flash", fmt::format("{} B", image.flash)},
                                {"RAM", fmt::format("{} B", image.ram)},
                                {"proven stack", image.stack ? fmt::format("{} B", *image.stack) : "without bound"}};
}

Json json_of(const std::optional<ImageFacts>& image) { return image ? sizes_json(*image) : Json(nullptr); }

}  // namespace finemote::gen
