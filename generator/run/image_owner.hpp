// Whose firmware a linked image is.
#pragma once

#include <string>

#include "generator/forest/forest.hpp"
#include "generator/image/image.hpp"
#include "generator/model/robot.hpp"
#include "generator/schedule/schedule.hpp"

namespace finemote::gen {

/// Whether the image was made from this robot, by its name, the number of its stages and its periods; else figures of
/// one would be called the other's. Reports FM6101 where it was not.
bool is_image_of(const Robot& robot, const Forest& forest, const Schedule& schedule, const Image& image,
                 const std::string& path, Diagnostics& diagnostics);

}  // namespace finemote::gen
