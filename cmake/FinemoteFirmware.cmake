# Turns a robot, or generated sources, into firmware for a board.
#
#   finemote_add_firmware(NAME INPUT robot.urdf [BOARD board] [OUTPUT_DIR dir] [COMMITTED]
#                         [DEVICES dir ...] [ARGS name:=value ...] [TRACE] [WATCH_BOUNDS] ...)
#   finemote_add_firmware(NAME GENERATED dir BOARD board [TRACE] [WATCH_BOUNDS] ...)
#
# NAME is an ordinary executable target, NAME.elf for a board (NAME on the host), with the targets of
# FinemoteTargets.cmake beside it.
#
# INPUT        robot description; the build generates its sources, and again when something changed that they depend on
# BOARD        the board to build for; with INPUT, without it: the robot's. `host` and `qemu_f405` run the sources that are
#              generated for the robot's own board
# OUTPUT_DIR   where the generated sources are: NAME.generated in the build folder, with COMMITTED `generated` beside the
#              CMakeLists.txt
# COMMITTED    the sources in OUTPUT_DIR are under version control: the build compiles them as they are, the target
#              NAME-generate writes them, and the test NAME-check says whether they are what would be generated
# DEVICES      further folders with descriptors of devices, beside `devices` next to the robot
# ARGS         arguments of a xacro file
# GENERATED    a folder that `finemote generate` wrote; every .cpp in it is compiled
# TRACE        records begin and end of every stage (always on for the host)
# WATCH_BOUNDS the firmware holds every device to its proven bounds: finemote/monitor.hpp
# DURATION     a number and s, ms, us or ns: the run ends by itself (boards qemu_f405 and host); without it: forever
# DEFINITIONS, INCLUDES, SOURCES   for the compiler; with INPUT the folders of the robot's own descriptors are known
# WITHOUT      files of the runtime's start-up that SOURCES stand in for: main.cpp, trace.cpp
# OPTIMIZE     -Os without it; a timing file is of -Os
# STACK        bytes that a board with a chip reserves for the stack, 4096 without it; `finemote run` proves how many it takes
# CODE         where a board with a chip runs the code: `sram` where the board can, or `flash`; without it, with INPUT what the
#              robot's <board> says (param `code`), else sram where the board can
# FLASH_BUDGET, RAM_BUDGET   bytes that NAME-size holds the image to
#
# For a board configure with a toolchain file: cmake/toolchain-arm-none-eabi.cmake. Build types make no difference there.
# The linker map is NAME.map.
get_filename_component(finemote_root "${CMAKE_CURRENT_LIST_DIR}/.." ABSOLUTE)
# Holds runtime/, templates/ and cmake/: share/finemote where finemote is installed.
set(FINEMOTE_ROOT ${finemote_root} CACHE INTERNAL "")
unset(finemote_root)

include(${CMAKE_CURRENT_LIST_DIR}/FinemoteCompile.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/FinemoteGenerate.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/FinemoteTargets.cmake)

# "40ms" -> 40000000
function(finemote_nanoseconds text result)
  if(NOT text MATCHES "^([0-9]+) ?(ns|us|ms|s)$")
    message(FATAL_ERROR "finemote_add_firmware: '${text}' is no duration; write for example 40ms")
  endif()
  set(ns 1)
  set(us 1000)
  set(ms 1000000)
  set(s 1000000000)
  math(EXPR value "${CMAKE_MATCH_1} * ${${CMAKE_MATCH_2}}")
  set(${result} ${value} PARENT_SCOPE)
endfunction()

# The definitions that the arguments of finemote_add_firmware, which calls this, stand for.
function(finemote_firmware_definitions result)
  set(definitions ${arg_DEFINITIONS})
  if(arg_DURATION)
    finemote_stands_in("${arg_BOARD}" stands_in)
    if(NOT stands_in)
      message(FATAL_ERROR "finemote_add_firmware(${target}): a run on board '${arg_BOARD}' does not end: DURATION is for "
                          "host and qemu_f405")
    endif()
    finemote_nanoseconds("${arg_DURATION}" duration)
    list(APPEND definitions FINEMOTE_RUN_DURATION_NS=${duration})
  endif()
  if(arg_TRACE)
    list(APPEND definitions FINEMOTE_TRACE)
  endif()
  if(arg_WATCH_BOUNDS)
    list(APPEND definitions FINEMOTE_MONITOR)
  endif()
  set(${result} ${definitions} PARENT_SCOPE)
endfunction()

# Where the code of a firmware runs: `asked`, or what the robot says, which is of no effect on a board that stands in.
function(finemote_code_place result target board asked robots)
  set(can_sram NO)
  if(EXISTS ${FINEMOTE_ROOT}/runtime/boards/${board}/generated/board_sram.ld)
    set(can_sram YES)
  endif()
  set(place flash)
  if(asked)
    set(place ${asked})
    if(NOT asked MATCHES "^(flash|sram)$")
      message(FATAL_ERROR "finemote_add_firmware(${target}): CODE is flash or sram, not '${asked}'")
    elseif(asked STREQUAL "sram" AND NOT can_sram)
      message(FATAL_ERROR "finemote_add_firmware(${target}): board '${board}' does not run code in SRAM")
    endif()
  elseif(can_sram AND NOT robots STREQUAL "flash")
    set(place sram)
  endif()
  set(${result} ${place} PARENT_SCOPE)
endfunction()

# How an image for a chip is linked.
function(finemote_link_options target board stack code)
  set(suffix)
  if(code STREQUAL "sram")
    set(suffix _sram)
  endif()
  set(script ${FINEMOTE_ROOT}/runtime/boards/${board}/generated/board${suffix}.ld)
  set(core ${FINEMOTE_ROOT}/runtime/chips/cortex_m4)
  set_target_properties(${target} PROPERTIES SUFFIX .elf LINK_DEPENDS "${script};${core}/sections${suffix}.ld")
  target_link_options(${target} PRIVATE -nostartfiles -T ${script} -L ${core} -Wl,--gc-sections -Wl,-Map=${target}.map
                      -Wl,--no-warn-rwx-segments)
  if(stack)
    target_link_options(${target} PRIVATE -Wl,--defsym=finemote_stack_size=${stack})
  endif()
endfunction()

function(finemote_add_firmware target)
  cmake_parse_arguments(arg "COMMITTED;TRACE;WATCH_BOUNDS"
                        "INPUT;GENERATED;BOARD;OUTPUT_DIR;DURATION;OPTIMIZE;STACK;CODE;FLASH_BUDGET;RAM_BUDGET"
                        "DEVICES;ARGS;DEFINITIONS;INCLUDES;SOURCES;WITHOUT" ${ARGN})
  if(arg_UNPARSED_ARGUMENTS)
    list(JOIN arg_UNPARSED_ARGUMENTS "', '" words)
    message(FATAL_ERROR "finemote_add_firmware(${target}): unknown '${words}'")
  endif()
  if(arg_INPUT)
    finemote_sources_of_input(${target})  # sets arg_BOARD, robot_*, generated_dir, generated, and adds to the two below
  elseif(arg_GENERATED AND arg_BOARD)
    get_filename_component(generated_dir ${arg_GENERATED} ABSOLUTE)
    finemote_glob_path("${generated_dir}" pattern)
    file(GLOB_RECURSE generated "${pattern}/*.cpp")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${generated_dir} ${generated_dir}/trees)
  else()
    message(FATAL_ERROR "finemote_add_firmware(${target}): needs INPUT, or GENERATED and BOARD")
  endif()
  finemote_board(${arg_BOARD} chips board_definitions)
  if(NOT arg_OPTIMIZE)
    set(arg_OPTIMIZE -Os)
  endif()
  finemote_check_compiler(${arg_BOARD} "${chips}")
  finemote_firmware_definitions(definitions)
  finemote_code_place(code ${target} ${arg_BOARD} "${arg_CODE}" "${robot_code}")
  list(APPEND definitions ${board_definitions})
  if(code STREQUAL "sram")
    list(APPEND definitions FINEMOTE_CODE_IN_SRAM)
  endif()
  finemote_runtime_library(runtime ${arg_BOARD} "${chips}" "${board_definitions}" ${arg_OPTIMIZE})
  finemote_board_objects(board ${arg_BOARD} "${chips}" "${definitions}" ${arg_OPTIMIZE} "${arg_WITHOUT}")

  add_executable(${target} ${generated} ${arg_SOURCES} $<TARGET_OBJECTS:${board}>)
  finemote_compile_options(${target} ${arg_BOARD} "${chips}" ${arg_OPTIMIZE})
  target_compile_definitions(${target} PRIVATE ${definitions})
  target_include_directories(${target} PRIVATE ${generated_dir} ${arg_INCLUDES})
  if(chips)
    foreach(folder IN LISTS arg_INCLUDES)  # __FILE__ in them is as long wherever the robot lies
      target_compile_options(${target} PRIVATE -fmacro-prefix-map=${folder}=devices)
    endforeach()
  endif()
  target_link_libraries(${target} PRIVATE ${runtime})
  if(chips)
    finemote_link_options(${target} ${arg_BOARD} "${arg_STACK}" ${code})
  endif()
  finemote_firmware_targets(${target} "${chips}" FLASH_BUDGET ${arg_FLASH_BUDGET} RAM_BUDGET ${arg_RAM_BUDGET})
  finemote_stands_in("${arg_BOARD}" stands_in)
  if(arg_INPUT AND NOT stands_in AND NOT arg_TRACE AND NOT arg_WATCH_BOUNDS)
    finemote_code_place(robots_code ${target} ${arg_BOARD} "" "${robot_code}")
    finemote_check_timed_options(${target} "${robot_words}" "${arg_OPTIMIZE}" "${code}" "${robots_code}")
    finemote_hold_to_timing_file(${target} "${robot_words}")
  endif()
endfunction()
