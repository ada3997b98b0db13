// What of an image goes into the flash: the bytes that `objcopy -O binary` makes of it.
#pragma once

#include <string>

#include "generator/image/image.hpp"

namespace finemote::gen {

/// The loaded segments by their place in flash, zeros between them.
std::string flashed_bytes(const Image& image);

}  // namespace finemote::gen
