# Turns generated sources and the runtime into firmware for a board.
#
# Works from the source tree and from an installed share/finemote: both hold runtime/ beside cmake/.
#
#   finemote_add_firmware(TARGET GENERATED dir BOARD board
#                         [TRACE] [MONITOR] [DURATION 40ms] [DEFINITIONS NAME=value ...] [INCLUDES dir ...] [SOURCES file ...]
#                         [OPTIMIZE -Os|-O2] [STACK bytes])
#
# GENERATED   folder that `finemote generate` wrote; every .cpp in it is compiled
# TRACE       records begin and end of every stage (always on for the host)
# MONITOR     holds every device to its proven bounds: finemote/monitor.hpp
# DURATION    a number and s, ms, us or ns: the run ends by itself (boards qemu_f405 and host); without it: forever
# STACK       bytes that a board with a chip reserves for the stack, 4096 without it; `finemote run` proves how many it takes
# INCLUDES    folders of the user's own device headers; SOURCES: their sources, if any
#
# For a Cortex-M4 board configure with cmake/toolchain-arm-none-eabi.cmake; the linker map is TARGET.map.
get_filename_component(FINEMOTE_ROOT "${CMAKE_CURRENT_LIST_DIR}/.." ABSOLUTE)

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

# Stops where the compiler is not one for the chips of the board: it would fail in every assembler line.
function(finemote_check_compiler board chips)
  execute_process(COMMAND ${CMAKE_CXX_COMPILER} -dumpmachine OUTPUT_VARIABLE machine OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(NOT chips AND machine MATCHES "^arm-none-eabi")
    message(FATAL_ERROR "finemote_add_firmware: board 'host' runs on this computer, and the compiler is one for '${machine}'; "
                        "configure without cmake/toolchain-arm-none-eabi.cmake")
  elseif(chips AND NOT machine MATCHES "^arm-none-eabi")
    message(FATAL_ERROR "finemote_add_firmware: board '${board}' needs a compiler for 'arm-none-eabi', and this one is for "
                        "'${machine}'; in an empty build folder configure with\n"
                        "  -DCMAKE_TOOLCHAIN_FILE=${FINEMOTE_ROOT}/cmake/toolchain-arm-none-eabi.cmake")
  endif()
endfunction()

# What does not depend on the robot: compiled once per board and optimisation level of a project. Devices and ports the
# robot does not use stay out of the image: the linker takes from this library what it needs.
function(finemote_runtime_library name board chips optimize)
  if(TARGET ${name})
    return()
  endif()
  set(runtime ${FINEMOTE_ROOT}/runtime)
  list(TRANSFORM chips REPLACE "(.+)" "${runtime}/chips/\\1/ports/*.cpp" OUTPUT_VARIABLE drivers)
  file(GLOB sources CONFIGURE_DEPENDS ${runtime}/src/*.cpp ${runtime}/devices/*.cpp ${drivers}
       ${runtime}/boards/${board}/ports/*.cpp ${runtime}/boards/${board}/generated/ports/*.cpp)
  add_library(${name} STATIC ${sources})
  finemote_target_options(${name} ${board} "${chips}" ${optimize})
endfunction()

function(finemote_target_options target board chips optimize)
  set_target_properties(${target} PROPERTIES CXX_STANDARD 17 CXX_STANDARD_REQUIRED ON CXX_EXTENSIONS OFF)
  target_include_directories(${target} PRIVATE ${FINEMOTE_ROOT}/runtime/include
                             ${FINEMOTE_ROOT}/runtime/boards/${board}/generated ${FINEMOTE_ROOT})
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Werror -g)
  target_compile_definitions(${target} PRIVATE ${FINEMOTE_BOARD_DEFINITIONS})
  if(NOT chips)
    target_compile_definitions(${target} PRIVATE FINEMOTE_TRACE)
  else()
    target_compile_options(${target} PRIVATE ${optimize} -fno-exceptions -fno-rtti -fno-threadsafe-statics
                           -fno-use-cxa-atexit -fno-unwind-tables -fno-asynchronous-unwind-tables -ffunction-sections
                           -fdata-sections
                           # the same bytes wherever the sources lie
                           -ffile-prefix-map=${FINEMOTE_ROOT}=finemote -ffile-prefix-map=${CMAKE_BINARY_DIR}=build
                           -ffile-prefix-map=${CMAKE_SOURCE_DIR}=robot)
  endif()
endfunction()

function(finemote_add_firmware target)
  cmake_parse_arguments(arg "TRACE;MONITOR" "GENERATED;BOARD;DURATION;OPTIMIZE;STACK" "DEFINITIONS;INCLUDES;SOURCES" ${ARGN})
  set(runtime ${FINEMOTE_ROOT}/runtime)
  set(board ${runtime}/boards/${arg_BOARD})
  if(NOT EXISTS ${board}/generated/board.cmake)
    message(FATAL_ERROR "finemote_add_firmware: no board '${arg_BOARD}' in ${runtime}/boards")
  endif()
  include(${board}/generated/board.cmake)  # sets FINEMOTE_BOARD_CHIPS: folders below runtime/chips; none is this computer
  set(chips ${FINEMOTE_BOARD_CHIPS})
  finemote_check_compiler(${arg_BOARD} "${chips}")
  if(NOT arg_OPTIMIZE)
    set(arg_OPTIMIZE -Os)
  endif()

  file(GLOB_RECURSE generated CONFIGURE_DEPENDS ${arg_GENERATED}/*.cpp)
  list(TRANSFORM chips REPLACE "(.+)" "${runtime}/chips/\\1/*.cpp" OUTPUT_VARIABLE starts)
  file(GLOB board_sources CONFIGURE_DEPENDS ${board}/*.cpp ${starts})
  set(library finemote_runtime_${arg_BOARD}${arg_OPTIMIZE})
  finemote_runtime_library(${library} ${arg_BOARD} "${chips}" ${arg_OPTIMIZE})

  add_executable(${target} ${generated} ${arg_SOURCES} ${board_sources})
  finemote_target_options(${target} ${arg_BOARD} "${chips}" ${arg_OPTIMIZE})
  target_include_directories(${target} PRIVATE ${arg_GENERATED} ${arg_INCLUDES})
  target_compile_definitions(${target} PRIVATE ${arg_DEFINITIONS})
  target_link_libraries(${target} PRIVATE ${library})
  if(arg_DURATION)
    finemote_nanoseconds("${arg_DURATION}" duration)
    target_compile_definitions(${target} PRIVATE FINEMOTE_RUN_DURATION_NS=${duration})
  endif()
  if(arg_TRACE)
    target_compile_definitions(${target} PRIVATE FINEMOTE_TRACE)
  endif()
  if(arg_MONITOR)
    target_compile_definitions(${target} PRIVATE FINEMOTE_MONITOR)
  endif()
  if(chips)
    set_target_properties(${target} PROPERTIES SUFFIX .elf LINK_DEPENDS
                          "${board}/generated/board.ld;${runtime}/chips/cortex_m4/sections.ld")
    target_link_options(${target} PRIVATE -nostartfiles -T ${board}/generated/board.ld -L ${runtime}/chips/cortex_m4
                        -Wl,--gc-sections -Wl,-Map=${target}.map -Wl,--fatal-warnings -Wl,--no-warn-rwx-segments)
    if(arg_STACK)
      target_link_options(${target} PRIVATE -Wl,--defsym=finemote_stack_size=${arg_STACK})
    endif()
  endif()
endfunction()
