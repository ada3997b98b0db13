// The number of a finding, written FMnnnn. Numbers are never reused.
#pragma once

#include <cstdint>

namespace finemote::gen {

struct Code {
  std::uint16_t number = 0;
  friend constexpr bool operator==(Code, Code) = default;
};

/// Every number in use, by range: 0xxx command line and files, 1xxx XML and xacro, 2xxx URDF, 3xxx device model,
/// descriptor and board, 4xxx timing, 5xxx output and check, 6xxx emulator, 9xxx internal.
/// Each has a page docs/diagnostics/FMnnnn.md, which `finemote explain` prints.
namespace code {

// 0xxx: command line and files
inline constexpr Code usage{1};              // a word of the command line is wrong
inline constexpr Code unreadable_file{2};    // missing, a folder, or no permission
inline constexpr Code empty_file{3};
inline constexpr Code not_utf8{4};
inline constexpr Code file_too_large{5};
inline constexpr Code missing_tool{6};       // a compiler or emulator that `run` needs
inline constexpr Code data_not_found{7};     // schemas, templates, runtime

// 1xxx: XML and xacro
inline constexpr Code malformed_xml{1001};
inline constexpr Code xacro_in_urdf{1002};   // a xacro: tag in a file that is read as plain URDF
inline constexpr Code nested_too_deeply{1003};  // elements inside elements beyond the limit

// 32xx: schedule
inline constexpr Code too_many_buckets{3201};      // more periods than interrupt lines or priority levels
inline constexpr Code generated_name_clash{3202};  // two names of generated code are the same
inline constexpr Code geometry_without_joint{3203};  // a device type computes from a joint the device does not name
inline constexpr Code unknown_geometry{3204};        // a descriptor asks for a geometry kind we do not know

// 5xxx: output and check
inline constexpr Code broken_manifest{5001};          // finemote.manifest.json cannot be used
inline constexpr Code output_not_writable{5002};      // a link, no folder, no permission, disk full
inline constexpr Code folder_of_another_robot{5003};  // two robots into one folder

}  // namespace code
}  // namespace finemote::gen
