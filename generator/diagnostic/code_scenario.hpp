// Numbers of what is said of scenarios and of the robot on the emulated board; the others are in code.hpp.
#pragma once

#include "generator/diagnostic/code.hpp"

namespace finemote::gen::code {

inline constexpr Code emulated_part{10};         // a part of the robot that cannot hang on the emulated board
inline constexpr Code scenario_name{6007};       // names nothing: a member, part, port, action or value
inline constexpr Code scenario_range{6009};      // a value outside what its member can be
inline constexpr Code scenario_time{6010};       // times that are rarely meant
inline constexpr Code scenario_unjudged{6011};   // nothing of it would be judged
inline constexpr Code undriven_plant{6012};      // wheels that drive nothing on the emulated board
inline constexpr Code bench_record{6013};        // a file without a whole record of a bench kit
inline constexpr Code told_loop{6014};           // a loop iterates more often than the sources say
inline constexpr Code undeclared_traffic{6015};  // a bus carries more than its devices declare
inline constexpr Code other_bounds{6016};        // a run was judged by other bounds than the robot has
inline constexpr Code hidden_include{6017};      // the compiler reads a file that a timing file would not depend on

}  // namespace finemote::gen::code
