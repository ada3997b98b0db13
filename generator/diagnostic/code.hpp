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

// 40xx: timing
inline constexpr Code json_malformed{4001};       // no JSON, or nested too deeply
inline constexpr Code json_repeated_key{4002};
inline constexpr Code json_unknown_member{4003};
inline constexpr Code json_missing_member{4004};
inline constexpr Code json_type{4005};            // a string where an integer is expected, 1e6, 1.5, ...
inline constexpr Code json_number_range{4006};
inline constexpr Code timing_name{4007};          // empty, or used twice
inline constexpr Code timing_parent{4008};        // a device or bus that does not exist, or stands in the wrong order
inline constexpr Code timing_period{4009};        // no multiple of the tick, or nobody's period
inline constexpr Code timing_overflow{4010};      // a sum, product or least common multiple beyond 64 bits
inline constexpr Code timing_too_long{4011};      // the analysis would exceed its budget of steps
inline constexpr Code timing_frame_time{4012};    // a frame shorter than 1 ns
inline constexpr Code timing_no_device{4013};
inline constexpr Code timing_cycle{4014};         // reads and parents form a cycle
inline constexpr Code timing_unschedulable{4015}; // a bucket may run over its period
inline constexpr Code timing_requirement{4016};   // a <require> does not hold
inline constexpr Code timing_closed_form{4017};   // a safe closed form stands in for the exact maximum
inline constexpr Code timing_chain{4018};         // a chain operand names nothing, or nothing leads from a to b
inline constexpr Code timing_profile{4019};       // profile target asked of a model without its fields
inline constexpr Code timing_assumed{4020};       // the verdict depends on assumed execution times

}  // namespace code
}  // namespace finemote::gen
