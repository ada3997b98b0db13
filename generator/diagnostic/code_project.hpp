// Numbers of what is said of a project's own files; the others are in code.hpp.
#pragma once

#include "generator/diagnostic/code.hpp"

namespace finemote::gen::code {

inline constexpr Code project_settings{11};     // what finemote.json sets, and cannot
inline constexpr Code nothing_to_import{2017};  // no <ros2_control> element

}  // namespace finemote::gen::code
