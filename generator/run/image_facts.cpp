#include "generator/run/image_facts.hpp"

#include "generator/image/check.hpp"
#include "generator/image/flashed.hpp"
#include "generator/image/sizes.hpp"
#include "generator/image/stack.hpp"
#include "generator/output/folder.hpp"
#include "generator/output/sha256.hpp"

namespace finemote::gen {

std::optional<ImageFacts> image_facts(const std::string& path, bool is_arm, const Robot& robot,
                                      bool constructors_allowed, Diagnostics& diagnostics) {
  ImageFacts facts;
  if (!is_arm) {
    facts.sha256 = sha256(read_bytes(path).value_or(""));
    return facts;
  }
  const auto image = read_image(path, diagnostics);
  if (!image) return std::nullopt;
  facts.sha256 = sha256(flashed_bytes(*image));
  const ImageSizes sizes = measure_image(*image);
  facts.flash = sizes.flash;
  facts.ram = sizes.ram;
  facts.code_ram = sizes.code_ram;
  facts.shares = image_shares(*image, robot);
  facts.stack_reserved = sizes.stack_reserved;
  const StackBound stack = worst_case_stack(*image, diagnostics);
  if (stack.known) facts.stack = stack.bytes;
  check_image(*image, stack, {constructors_allowed}, diagnostics);
  return facts;
}

nlohmann::ordered_json sizes_json(const ImageFacts& image) {
  using Json = nlohmann::ordered_json;
  const bool is_arm = image.flash > 0;
  return {{"flash", is_arm ? Json(image.flash) : Json(nullptr)},
          {"ram", is_arm ? Json(image.ram) : Json(nullptr)},
          {"code_ram", is_arm ? Json(image.code_ram) : Json(nullptr)},
          {"stack", image.stack ? Json(*image.stack) : Json(nullptr)}};
}

}  // namespace finemote::gen
