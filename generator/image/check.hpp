// Proves on the linked image what the target code promises: no heap, no exceptions, no RTTI, no code before main.
#pragma once

#include "generator/image/image.hpp"
#include "generator/image/stack.hpp"

namespace finemote::gen {

struct ImagePromises {
  bool constructors_allowed = false;  ///< the robot has a device that is not constant-initialised
};

/// Reports FM6102 per forbidden symbol (heap, unwinder, type information, guards), FM6103 for constructors that run
/// before main, FM6107 when the worst-case stack does not fit the reserved one.
void check_image(const Image& image, const StackBound& stack, ImagePromises promises, Diagnostics& diagnostics);

}  // namespace finemote::gen
