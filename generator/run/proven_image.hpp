// A project to an image that keeps what the target code promises, with as much stack as it needs.
#pragma once

#include <optional>
#include <string>

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/run/image_facts.hpp"
#include "generator/run/project.hpp"

namespace finemote::gen {

struct ProvenImage {
  std::string path;
  ImageFacts facts;
};

/// Writes the files and builds; where the proven stack does not fit what the board reserves, once more with room for
/// it, and FM6107 as a note. Reports what make_image and image_facts report.
/// @param parts  as for make_project
std::optional<ProvenImage> make_proven_image(const Project& project, const Robot& robot, const EmulatedParts* parts,
                                             Sources& sources, Diagnostics& diagnostics);

}  // namespace finemote::gen
