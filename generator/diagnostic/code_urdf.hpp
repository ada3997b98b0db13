// Numbers of what is said of words that a reader of the URDF skips; the others are in code.hpp.
#pragma once

#include "generator/diagnostic/code.hpp"

namespace finemote::gen::code {

inline constexpr Code urdf_misspelt{3084};  // nearly an element or attribute that is read
inline constexpr Code urdf_twice{3085};     // an element of which only the first counts stands there again

}  // namespace finemote::gen::code
