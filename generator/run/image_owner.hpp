// Whose firmware a linked image is.
#pragma once

#include <string>

#include "generator/forest/forest.hpp"
#include "generator/image/image.hpp"
#include "generator/model/robot.hpp"

namespace finemote::gen {

/// Whether the image was made from this robot, by its name and the number of its stages; else figures of one would be
/// called the other's. Reports FM6101 where it was not.
bool is_image_of(const Robot& robot, const Forest& forest, const Image& image, const std::string& path,
                 Diagnostics& diagnostics);

}  // namespace finemote::gen
