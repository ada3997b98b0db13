// The numbers that only the output folder needs; the others are in code.hpp.
#pragma once

#include "generator/diagnostic/code.hpp"

namespace finemote::gen::code {

inline constexpr Code file_of_the_user{5004};     // generate would overwrite or remove what it did not write
inline constexpr Code folder_in_use{5005};        // another process writes to it
inline constexpr Code output_not_readable{5006};  // a folder or file of the output that cannot be read
inline constexpr Code output_missing{5007};       // check: a file is not there
inline constexpr Code output_edited{5008};        // check: a file differs from what was generated
inline constexpr Code output_line_ends{5009};     // check: a file differs by CR alone
inline constexpr Code output_stale{5010};         // check: generate would write something else now
inline constexpr Code output_orphan{5011};        // check: a generated file that no manifest lists
inline constexpr Code file_not_editable{5012};    // lint --fix: standard input, another encoding, or changed meanwhile
inline constexpr Code output_is_input{5013};      // a file that was read would be overwritten
inline constexpr Code output_twice{5014};         // two outputs are one file
inline constexpr Code file_exists{5015};          // init, scaffold: a file they would write is there
inline constexpr Code robot_not_whole{5016};      // init: the robot reads what is not below its folder

}  // namespace finemote::gen::code
