# Turns generated sources and the runtime into firmware for a board.
#
# Works from the source tree and from an installed share/finemote: both hold runtime/ beside cmake/.
#
#   finemote_add_firmware(TARGET GENERATED dir BOARD board
#                         [TRACE] [DURATION 40ms] [DEFINITIONS NAME=value ...] [INCLUDES dir ...] [SOURCES file ...]
#                         [OPTIMIZE -O2|-Os])
#
# GENERATED   folder that `finemote generate` wrote; every .cpp in it is compiled
# TRACE       records begin and end of every stage (always on for the host)
# DURATION    a number and s, ms, us or ns: the run ends by itself (boards qemu_f405 and host); without it: forever
# INCLUDES    folders of the user's own device headers; SOURCES: their sources, if any
#
# For a Cortex-M4 board configure with cmake/toolchain-arm-none-eabi.cmake. The linker map is TARGET.map; stack usage and
# call graphs (.su, .ci) lie beside the objects.
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

function(finemote_add_firmware target)
  cmake_parse_arguments(arg "TRACE" "GENERATED;BOARD;DURATION;OPTIMIZE" "DEFINITIONS;INCLUDES;SOURCES" ${ARGN})
  set(runtime ${FINEMOTE_ROOT}/runtime)
  set(board ${runtime}/boards/${arg_BOARD})
  if(NOT EXISTS ${board}/board.cmake)
    message(FATAL_ERROR "finemote_add_firmware: no board '${arg_BOARD}' in ${runtime}/boards")
  endif()
  include(${board}/board.cmake)  # sets FINEMOTE_BOARD_FAMILY: host or cortex_m4
  set(family ${FINEMOTE_BOARD_FAMILY})

  file(GLOB_RECURSE generated CONFIGURE_DEPENDS ${arg_GENERATED}/*.cpp)
  file(GLOB common CONFIGURE_DEPENDS ${runtime}/src/*.cpp ${runtime}/devices/*.cpp
       ${board}/ports/*.cpp)
  file(GLOB board_sources CONFIGURE_DEPENDS ${board}/*.cpp)
  if(NOT family STREQUAL arg_BOARD)
    file(GLOB family_sources CONFIGURE_DEPENDS ${runtime}/boards/${family}/*.cpp)
  endif()

  # Devices and ports the robot does not use stay out of the image: the linker takes from this library what it needs.
  add_library(${target}_runtime STATIC ${common})
  add_executable(${target} ${generated} ${arg_SOURCES} ${board_sources} ${family_sources})
  target_link_libraries(${target} PRIVATE ${target}_runtime)

  if(arg_DURATION)
    finemote_nanoseconds("${arg_DURATION}" duration)
    list(APPEND arg_DEFINITIONS FINEMOTE_RUN_DURATION_NS=${duration})
  endif()
  if(arg_TRACE OR family STREQUAL "host")
    list(APPEND arg_DEFINITIONS FINEMOTE_TRACE)
  endif()
  if(NOT arg_OPTIMIZE)
    set(arg_OPTIMIZE -O2)
  endif()
  foreach(part ${target} ${target}_runtime)
    set_target_properties(${part} PROPERTIES CXX_STANDARD 17 CXX_STANDARD_REQUIRED ON CXX_EXTENSIONS OFF)
    target_include_directories(${part} PRIVATE ${arg_GENERATED} ${runtime}/include ${FINEMOTE_ROOT} ${arg_INCLUDES})
    target_compile_definitions(${part} PRIVATE ${arg_DEFINITIONS})
    target_compile_options(${part} PRIVATE -Wall -Wextra -Wpedantic -Werror -g)
    if(NOT family STREQUAL "host")
      target_compile_options(
        ${part} PRIVATE ${arg_OPTIMIZE} -fno-exceptions -fno-rtti -fno-threadsafe-statics -fno-use-cxa-atexit
                        -fno-unwind-tables -fno-asynchronous-unwind-tables -ffunction-sections -fdata-sections
                        -fstack-usage -fcallgraph-info=su)
    endif()
  endforeach()
  if(NOT family STREQUAL "host")
    set_target_properties(${target} PROPERTIES SUFFIX .elf LINK_DEPENDS
                          "${board}/board.ld;${runtime}/boards/${family}/sections.ld")
    target_link_options(${target} PRIVATE -nostartfiles -T ${board}/board.ld -L ${runtime}/boards/${family}
                        -Wl,--gc-sections -Wl,-Map=${target}.map -Wl,--fatal-warnings -Wl,--no-warn-rwx-segments)
  endif()
endfunction()
