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
inline constexpr Code usage{1};            // a word of the command line is wrong
inline constexpr Code unreadable_file{2};  // missing, a folder, or no permission
inline constexpr Code empty_file{3};
inline constexpr Code not_utf8{4};
inline constexpr Code file_too_large{5};
inline constexpr Code missing_tool{6};     // a compiler or emulator that `run` needs
inline constexpr Code data_not_found{7};   // schemas, templates, runtime
inline constexpr Code outside_sandbox{8};  // --sandbox: a file the run may not read
inline constexpr Code sandbox_limit{9};    // --sandbox: memory or processor time

// 1xxx: XML and xacro
inline constexpr Code malformed_xml{1001};
inline constexpr Code xacro_in_urdf{1002};       // a xacro: tag in a file that is read as plain URDF
inline constexpr Code nested_too_deeply{1003};   // elements inside elements beyond the limit
inline constexpr Code xacro_expression{1010};    // ${...} that cannot be parsed or evaluated
inline constexpr Code xacro_limit{1011};         // recursion, work or output beyond the bounds
inline constexpr Code xacro_fatal{1012};         // the file itself called xacro.fatal()
inline constexpr Code xacro_text{1013};          // ${ or $( without end, $$ before anything else
inline constexpr Code xacro_substitution{1014};  // $(...) of an unknown kind or with wrong words
inline constexpr Code xacro_argument{1015};      // $(arg x) without a value
inline constexpr Code xacro_package{1016};       // $(find x): there is no such package
inline constexpr Code xacro_environment{1017};   // --sandbox: $(env x)
inline constexpr Code xacro_attribute{1020};     // an attribute of a xacro tag is missing
inline constexpr Code xacro_property{1021};      // a property's name or options are wrong
inline constexpr Code xacro_macro{1022};         // a macro's name or parameters are wrong
inline constexpr Code xacro_unknown_macro{1023};
inline constexpr Code xacro_call{1024};               // arguments or blocks of a macro call are missing or too many
inline constexpr Code xacro_block{1025};              // insert_block of a name that is no block
inline constexpr Code xacro_condition{1026};          // if or unless with a value that is no boolean
inline constexpr Code xacro_include{1027};            // an included file cannot be read
inline constexpr Code xacro_yaml{1028};               // a YAML file cannot be read or parsed
inline constexpr Code xacro_output{1029};             // the expanded file cannot be written
inline constexpr Code xacro_no_xml{1030};             // the result could not be read as XML
inline constexpr Code xacro_unknown_attribute{1050};  // warning: a xacro tag does not know the attribute
inline constexpr Code xacro_redefined_symbol{1051};   // warning: a property hides a built-in
inline constexpr Code xacro_deprecated{1052};         // warning: a function has moved into a namespace
inline constexpr Code xacro_no_match{1053};           // warning: a wild card matches no file
inline constexpr Code xacro_namespace{1054};          // warning: two files declare one xmlns prefix differently
inline constexpr Code xacro_ignored{1055};            // warning: part of the input has no effect
inline constexpr Code xacro_message{1056};  // warning: the file itself called xacro.warning() or xacro.error()
inline constexpr Code xacro_duplicate_package{1057};  // warning: a package is found in two places
inline constexpr Code xacro_macro_prefix{1058};       // warning: a macro's name begins with xacro:
inline constexpr Code xacro_unknown_argument{1059};   // warning: no xacro:arg declares a name:=value
inline constexpr Code xacro_lost_attribute{1060};     // warning: ROS xacro loses this xacro:attribute

// 32xx: schedule
inline constexpr Code too_many_buckets{3201};      // more periods than interrupt lines or priority levels
inline constexpr Code generated_name_clash{3202};  // two names of generated code are the same
// Retired: 3203 (FM2006 says it), 3204 (FM3102 says it).
inline constexpr Code link_too_large{3205};  // a link to a computer carries more than its frames hold

// 5xxx: output and check
inline constexpr Code broken_manifest{5001};          // finemote.manifest.json cannot be used
inline constexpr Code output_not_writable{5002};      // a link, no folder, no permission, disk full
inline constexpr Code folder_of_another_robot{5003};  // two robots into one folder

// 40xx: timing
inline constexpr Code json_malformed{4001};  // no JSON, or nested too deeply
inline constexpr Code json_repeated_key{4002};
inline constexpr Code json_unknown_member{4003};
inline constexpr Code json_missing_member{4004};
inline constexpr Code json_type{4005};  // a string where an integer is expected, 1e6, 1.5, ...
inline constexpr Code json_number_range{4006};
inline constexpr Code timing_name{4007};      // empty, or used twice
inline constexpr Code timing_parent{4008};    // a device or bus that does not exist, or stands in the wrong order
inline constexpr Code timing_period{4009};    // no multiple of the tick, or nobody's period
inline constexpr Code timing_overflow{4010};  // a time, sum or product beyond 64 bits
// Retired: 4011 (closed forms stand in where an analysis would take too long: FM4017).
inline constexpr Code timing_frame_time{4012};  // a frame shorter than 1 ns
inline constexpr Code timing_no_device{4013};
inline constexpr Code timing_cycle{4014};           // reads and parents form a cycle
inline constexpr Code timing_unschedulable{4015};   // a bucket may run over its period
inline constexpr Code timing_requirement{4016};     // a <require> does not hold
inline constexpr Code timing_closed_form{4017};     // a safe closed form stands in for the exact maximum
inline constexpr Code timing_chain{4018};           // a chain operand names nothing, or nothing leads from a to b
inline constexpr Code timing_profile{4019};         // profile target asked of a model without its fields
inline constexpr Code timing_assumed{4020};         // the verdict depends on assumed execution times
inline constexpr Code timing_bus_overload{4021};    // warning: a bus is overloaded
inline constexpr Code timing_stale{4022};           // warning: the timing file was computed from something else
inline constexpr Code timing_unused{4023};          // note: the timing file is of other arguments or another compiler
inline constexpr Code timing_above_declared{4024};  // a computed execution time is above the declared one
inline constexpr Code timing_not_static{4025};      // --require-static: an execution time that is not computed
inline constexpr Code timing_file_schema{4026};     // a timing file of another schema
inline constexpr Code timing_release{4027};  // the next release may come before the interrupt of the last one ends
// 20xx: links and joints of the URDF
inline constexpr Code urdf_rejected{2001};  // urdfdom, which ROS tools use, refuses the links and joints
inline constexpr Code unknown_link{2002};
inline constexpr Code unknown_joint{2003};
inline constexpr Code joint_fixed{2004};        // a joint that must move cannot
inline constexpr Code not_a_robot{2005};        // the root element is no <robot name="...">
inline constexpr Code joint_needed{2006};       // geometry is asked of a device that names no joint
inline constexpr Code duplicate_in_urdf{2007};  // two links or two joints of one name
inline constexpr Code urdf_number{2008};        // xyz, rpy, axis or limit is malformed
inline constexpr Code joint_type{2009};
inline constexpr Code link_parents{2010};     // a link is the child of two joints
inline constexpr Code joint_unfit{2011};      // the joint cannot be what it is needed for
inline constexpr Code urdf_range{2012};       // a length, mass or angle that nothing has
inline constexpr Code axis_direction{2013};   // an axis without direction
inline constexpr Code joint_limits{2014};     // lower above upper, or out of reach of what drives the joint
inline constexpr Code body_link{2015};        // a wrench about the world, or about what a thruster turns
inline constexpr Code geometry_number{2016};  // a constant that no float holds

// 30xx: the <finemote> extension: structure
inline constexpr Code no_extension{3001};  // no <finemote> in the robot
inline constexpr Code version_missing{3002};
inline constexpr Code version_unknown{3003};
inline constexpr Code period_missing{3004};
inline constexpr Code board_missing{3005};
inline constexpr Code board_twice{3006};
inline constexpr Code unknown_board{3007};
inline constexpr Code unknown_element{3008};
inline constexpr Code unknown_attribute{3009};
inline constexpr Code attribute_missing{3010};
inline constexpr Code bad_choice{3011};  // a value that is not one of the few possible
inline constexpr Code unknown_port{3012};
inline constexpr Code silkscreen_port{3013};  // the label on the board instead of the port's name
inline constexpr Code port_kind{3014};        // the port cannot serve this kind of bus
inline constexpr Code port_twice{3015};
inline constexpr Code resource_conflict{3016};  // two ports need one pin, DMA stream, timer or interrupt
inline constexpr Code rate_unreachable{3017};   // more than 2 % away from what the port can make
inline constexpr Code attribute_unused{3018};   // does not apply here
inline constexpr Code unknown_bus{3019};
inline constexpr Code bus_kind{3020};  // the device cannot sit on this kind of bus
inline constexpr Code unknown_device_type{3021};
inline constexpr Code element_twice{3022};
inline constexpr Code unknown_param{3023};
inline constexpr Code param_missing{3024};
inline constexpr Code param_type{3025};
inline constexpr Code param_range{3026};
inline constexpr Code param_twice{3027};
inline constexpr Code unexpected_text{3028};
inline constexpr Code unit_missing{3030};
inline constexpr Code unit_wrong{3031};
inline constexpr Code quantity_inexact{3032};  // not whole in the base unit
inline constexpr Code quantity_malformed{3033};
inline constexpr Code quantity_overflow{3034};
inline constexpr Code bare_integer{3035};
inline constexpr Code period_zero{3036};
inline constexpr Code period_tick{3037};  // no multiple of the tick
inline constexpr Code tick_cycles{3038};  // not a whole number of CPU cycles

// 304x: names and the forest
inline constexpr Code nested_and_parent{3040};
inline constexpr Code unknown_parent{3041};
inline constexpr Code parent_cycle{3042};
inline constexpr Code reads_cycle{3043};
inline constexpr Code unknown_device{3044};
inline constexpr Code reads_own_subtree{3045};
inline constexpr Code duplicate_name{3046};
inline constexpr Code name_clash{3047};     // different names, one C++ name
inline constexpr Code name_invalid{3048};   // no C++ name: keyword, `__`, leading `_X`, empty
inline constexpr Code name_reserved{3049};  // generated code uses it

// 305x: roles
inline constexpr Code unknown_role{3051};
inline constexpr Code role_ambiguous{3052};
inline constexpr Code role_no_fit{3053};
inline constexpr Code role_interface{3054};
inline constexpr Code role_too_few{3055};
inline constexpr Code role_too_many{3056};
inline constexpr Code role_without_parent{3057};

// 306x: places on buses
inline constexpr Code address_8bit{3061};  // an 8-bit I2C address where the 7-bit one belongs
inline constexpr Code address_range{3062};
inline constexpr Code address_conflict{3063};
inline constexpr Code channel_range{3064};
inline constexpr Code channel_twice{3065};
inline constexpr Code bus_shared{3066};  // two devices on a bus that carries one
inline constexpr Code id_range{3067};
inline constexpr Code id_conflict{3068};
inline constexpr Code frame_split{3069};  // one CAN frame would be filled by two buckets
inline constexpr Code unknown_use{3070};
inline constexpr Code use_missing{3071};
inline constexpr Code use_endpoint{3072};  // `use` names no bus or pin, or the wrong kind
inline constexpr Code pin_invalid{3073};
inline constexpr Code mux_nested{3074};       // a mux behind a mux
inline constexpr Code bus_needed{3075};       // the device needs a bus
inline constexpr Code pin_function{3076};     // the board's pin cannot be what the device makes of it
inline constexpr Code no_device{3077};        // a robot without a device: nothing to generate
inline constexpr Code line_inverted{3078};    // the port has no inverter, or one too many
inline constexpr Code period_too_long{3079};  // more ticks than the scheduler counts
inline constexpr Code too_many_frames{3080};  // more command frames on a CAN bus than its driver keeps

// 308x: requirements and schedule limits
inline constexpr Code require_operand{3081};  // names nothing
inline constexpr Code bus_full{3083};         // more devices than the driver of a bus serves
inline constexpr Code require_shape{3082};    // not exactly one of latency, utilization, jitter

// 310x: descriptors and board files
inline constexpr Code descriptor_malformed{3101};
inline constexpr Code descriptor_schema{3102};
inline constexpr Code descriptor_contradiction{3103};
inline constexpr Code descriptor_version{3104};  // unknown "schema"
inline constexpr Code header_missing{3105};      // the C++ header a descriptor names is not there
inline constexpr Code type_twice{3106};          // two descriptors of one name, or one that hides a shipped type
inline constexpr Code descriptor_name{3107};     // the file's name and the name inside differ

// 315x: lint: allowed, and rarely meant
inline constexpr Code lint_order{3151};         // a sensor after actuators of its period
inline constexpr Code lint_period_ratio{3152};  // neither multiple nor divisor of the parent's
inline constexpr Code lint_no_wcet{3153};
inline constexpr Code lint_conversion{3154};  // longer than the period
inline constexpr Code lint_bus_load{3155};
inline constexpr Code lint_unused_bus{3156};
inline constexpr Code lint_param_replaced{3157};  // given, and computed from the URDF
inline constexpr Code lint_wrench_axis{3158};     // the actuators do not produce it
inline constexpr Code lint_wrench_effort{3159};   // they nearly do not: it takes many times its force
inline constexpr Code lint_out_of_reach{3160};    // joint limits that what drives the joint does not reach
inline constexpr Code lint_command_age{3161};     // data may get older than the device accepts
// 6xxx: firmware and emulator
inline constexpr Code firmware_build_failed{6001};  // generated code or the user's devices do not compile
inline constexpr Code firmware_stopped{6002};       // a fault, or it did not end in time
inline constexpr Code bad_scenario{6004};           // a scenario file that cannot be used
inline constexpr Code hardware_misuse{6005};        // what the hardware would not forgive
inline constexpr Code broken_record{6003};          // the run's trace cannot be read
inline constexpr Code wcet_exceeded{6006};          // a stage runs longer than the WCET its bounds were made from

// 61xx: the linked image
inline constexpr Code bad_image{6101};         // not a linked Arm image, or not readable
inline constexpr Code forbidden_symbol{6102};  // heap, exceptions, type information or the like was linked
inline constexpr Code code_before_main{6103};  // constructors although every object should be constant-initialised
inline constexpr Code recursion{6104};         // the stack has no bound
inline constexpr Code indirect_call{6105};     // a call through a pointer outside the runtime's tables
inline constexpr Code unbounded_stack{6106};   // a function's own use of the stack is not known
inline constexpr Code stack_too_small{6107};   // the worst case does not fit what is reserved

// 9xxx: internal
inline constexpr Code internal{9001};  // a defect of the tool itself

}  // namespace code
}  // namespace finemote::gen
