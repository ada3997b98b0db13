#include "generator/run/proven_image.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/image/sizes.hpp"

namespace finemote::gen {
namespace {

bool all_constant(const Robot& robot) {
  return std::all_of(robot.devices.begin(), robot.devices.end(), [](const Device& d) { return d.type->constant_init; });
}

std::optional<ProvenImage> make_once(const Project& project, const Robot& robot, Sources& sources,
                                     Diagnostics& diagnostics) {
  auto path = make_image(project, sources, diagnostics);
  if (!path) return std::nullopt;
  auto facts = image_facts(*path, !project.request.for_host, robot, !all_constant(robot), diagnostics);
  if (!facts) return std::nullopt;
  return ProvenImage{std::move(*path), std::move(*facts)};
}

/// A project of the user's own is not linked here: what it reserves is unknown.
void tell_of_reserve(std::uint32_t needed, std::uint32_t reserved, std::uint32_t linked, Diagnostics& diagnostics) {
  diagnostics
      .remark(code::stack_too_small, {},
              fmt::format("the stack needs {} bytes in the worst case: this image reserves {}, and a project without "
                          "STACK {}",
                          needed, linked, reserved))
      .hint(fmt::format("in finemote_add_firmware(...) write STACK {}", linked));
}

}  // namespace

std::optional<ProvenImage> make_proven_image(const Project& project, const Robot& robot, const EmulatedParts* parts,
                                             Sources& sources, Diagnostics& diagnostics) {
  Diagnostics said;
  auto image = make_once(project, robot, sources, said);
  if (image && image->facts.stack.value_or(0) > image->facts.stack_reserved) {
    FirmwareRequest request = project.request;
    request.stack = rounded_stack(*image->facts.stack);
    said = Diagnostics();
    tell_of_reserve(*image->facts.stack, image->facts.stack_reserved, request.stack, said);
    image = make_once(make_project(request, project.generated, robot, parts), robot, sources, said);
  }
  for (const Diagnostic& finding : said.in_file_order()) diagnostics.add(finding);
  return said.has_errors() ? std::nullopt : std::move(image);
}

}  // namespace finemote::gen
