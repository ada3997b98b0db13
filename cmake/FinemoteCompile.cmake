# How sources are compiled for a board: used by FinemoteFirmware.cmake and FinemoteDeviceTest.cmake.
#
# Nobody's build shows warnings of what finemote ships: its headers are system headers, its sources compiled with -w.
# FINEMOTE_WARNINGS replaces this -w, for those who work on the runtime.

# What a board is made of: folders below runtime/chips (none: this computer), and definitions.
function(finemote_board board chips definitions)
  set(boards ${FINEMOTE_ROOT}/runtime/boards)
  if(NOT EXISTS ${boards}/${board}/generated/board.cmake)
    message(FATAL_ERROR "finemote_add_firmware: no board '${board}' in ${boards}")
  endif()
  include(${boards}/${board}/generated/board.cmake)
  set(${chips} ${FINEMOTE_BOARD_CHIPS} PARENT_SCOPE)
  if(NOT FINEMOTE_BOARD_CHIPS)
    list(APPEND FINEMOTE_BOARD_DEFINITIONS FINEMOTE_TRACE)  # costs nothing on the host
  endif()
  set(${definitions} ${FINEMOTE_BOARD_DEFINITIONS} PARENT_SCOPE)
endfunction()

# Whether the board stands in for that of a robot: what runs there is held to no bound.
function(finemote_stands_in board result)
  set(file ${FINEMOTE_ROOT}/runtime/boards/${board}/generated/board.cmake)
  if(board AND EXISTS ${file})
    include(${file})
  endif()
  set(${result} ${FINEMOTE_BOARD_STANDS_IN} PARENT_SCOPE)
endfunction()

# Stops where the compiler is not one for the chips of the board: it would fail in every assembler line.
function(finemote_check_compiler board chips)
  if(NOT FINEMOTE_MACHINE_OF STREQUAL CMAKE_CXX_COMPILER)
    execute_process(COMMAND ${CMAKE_CXX_COMPILER} -dumpmachine OUTPUT_VARIABLE machine OUTPUT_STRIP_TRAILING_WHITESPACE)
    set(FINEMOTE_MACHINE ${machine} CACHE INTERNAL "what the compiler compiles for")
    set(FINEMOTE_MACHINE_OF ${CMAKE_CXX_COMPILER} CACHE INTERNAL "")
  endif()
  set(machine ${FINEMOTE_MACHINE})
  if(NOT chips AND machine MATCHES "^arm-none-eabi")
    message(FATAL_ERROR "finemote: board 'host' runs on this computer, and the compiler is one for '${machine}'; "
                        "configure without cmake/toolchain-arm-none-eabi.cmake")
  elseif(chips AND NOT machine MATCHES "^arm-none-eabi")
    message(FATAL_ERROR "finemote: board '${board}' needs a compiler for 'arm-none-eabi', and this one is for "
                        "'${machine}'; in an empty build folder configure with\n"
                        "  -DCMAKE_TOOLCHAIN_FILE=${FINEMOTE_ROOT}/cmake/toolchain-arm-none-eabi.cmake")
  endif()
endfunction()

# How everything is compiled for a board. Build types make no difference where there is a chip: -Os stands behind their -O3.
function(finemote_compile_options target board chips optimize)
  set_target_properties(${target} PROPERTIES CXX_STANDARD 17 CXX_STANDARD_REQUIRED ON CXX_EXTENSIONS OFF
                        UNITY_BUILD OFF INTERPROCEDURAL_OPTIMIZATION OFF)  # bounds are of files compiled one by one
  foreach(type DEBUG RELEASE RELWITHDEBINFO MINSIZEREL)
    set_target_properties(${target} PROPERTIES INTERPROCEDURAL_OPTIMIZATION_${type} OFF)
  endforeach()
  target_include_directories(${target} SYSTEM PRIVATE ${FINEMOTE_ROOT}/runtime/include
                             ${FINEMOTE_ROOT}/runtime/boards/${board}/generated ${FINEMOTE_ROOT})
  if(NOT chips)
    target_compile_options(${target} PRIVATE -g)
    return()
  endif()
  target_compile_options(${target} PRIVATE -g ${optimize}
                         "$<$<COMPILE_LANGUAGE:CXX>:-fno-exceptions;-fno-rtti;-fno-threadsafe-statics;-fno-use-cxa-atexit>"
                         -fno-math-errno -fno-unwind-tables -fno-asynchronous-unwind-tables -ffunction-sections
                         -fdata-sections
                         # the same bytes wherever the sources lie, also behind links; of several that fit the last one counts
                         -fno-canonical-system-headers
                         -ffile-prefix-map=${CMAKE_SOURCE_DIR}=robot -ffile-prefix-map=${CMAKE_BINARY_DIR}=build
                         -ffile-prefix-map=${FINEMOTE_ROOT}=finemote)
endfunction()

# finemote_shipped_library(NAME KIND SOURCES file ... DEFINITIONS NAME=value ...): of sources of finemote, once in a project.
function(finemote_shipped_library name kind board chips optimize)
  cmake_parse_arguments(arg "" "" "SOURCES;DEFINITIONS" ${ARGN})
  add_library(${name} ${kind} EXCLUDE_FROM_ALL ${arg_SOURCES})
  finemote_compile_options(${name} ${board} "${chips}" "${optimize}")
  target_compile_definitions(${name} PRIVATE ${arg_DEFINITIONS})
  if(FINEMOTE_WARNINGS)
    target_compile_options(${name} PRIVATE ${FINEMOTE_WARNINGS})
  else()
    target_compile_options(${name} PRIVATE -w)
  endif()
endfunction()

# What does not depend on the robot: compiled once per board and optimisation level (of a chip) of a project. Devices and ports the
# robot does not use stay out of the image: the linker takes from this library what it needs.
function(finemote_runtime_library result board chips definitions optimize)
  if(NOT chips)
    set(optimize)  # the build type decides
  endif()
  set(name finemote_runtime_${board}${optimize})
  set(${result} ${name} PARENT_SCOPE)
  if(TARGET ${name})
    return()
  endif()
  set(runtime ${FINEMOTE_ROOT}/runtime)
  list(TRANSFORM chips REPLACE "(.+)" "${runtime}/chips/\\1/ports/*.cpp" OUTPUT_VARIABLE drivers)
  file(GLOB sources ${runtime}/src/*.cpp ${runtime}/devices/*.cpp ${drivers}
       ${runtime}/boards/${board}/ports/*.cpp ${runtime}/boards/${board}/generated/ports/*.cpp)
  finemote_shipped_library(${name} STATIC ${board} "${chips}" "${optimize}" SOURCES ${sources} DEFINITIONS ${definitions})
endfunction()

# Start-up, trace and everything else that depends on the definitions of a firmware: compiled once for each set of them.
# `without`: names of files that the firmware brings itself.
function(finemote_board_objects result board chips definitions optimize without)
  list(JOIN definitions "," key)
  list(JOIN without "," absent)
  string(APPEND key ";${absent}")
  string(MD5 key "${key}")
  set(name finemote_board_${board}${optimize}_${key})
  set(${result} ${name} PARENT_SCOPE)
  if(TARGET ${name})
    return()
  endif()
  set(runtime ${FINEMOTE_ROOT}/runtime)
  list(TRANSFORM chips REPLACE "(.+)" "${runtime}/chips/\\1/*.cpp" OUTPUT_VARIABLE starts)
  file(GLOB sources ${runtime}/boards/${board}/*.cpp ${starts})
  foreach(file ${without})
    list(FILTER sources EXCLUDE REGEX "/${file}$")
  endforeach()
  finemote_shipped_library(${name} OBJECT ${board} "${chips}" "${optimize}" SOURCES ${sources} DEFINITIONS ${definitions})
  # Before the copy there is nothing that it could call, so all has to be inlined, which -O0 does not do. The last level counts.
  set(copiers ${sources})
  list(FILTER copiers INCLUDE REGEX "/code_in_sram\\.cpp$")
  if(copiers)
    set_source_files_properties(${copiers} PROPERTIES COMPILE_OPTIONS -Os)
  endif()
endfunction()
