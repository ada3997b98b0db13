# Compiler options shared by all host code: C++20, warnings as errors, optional sanitizers, ccache.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
# Floating point is computed as written, so that the same input gives the same bytes on every machine.
add_compile_options(-Wall -Wextra -Wpedantic -Werror -ffp-contract=off)

if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()
set(CMAKE_CXX_FLAGS_RELEASE "-O2")
set(CMAKE_CXX_FLAGS_DEBUG "-O1 -g1")

option(FINEMOTE_SANITIZE "Build with address and undefined-behaviour sanitizers" OFF)
if(FINEMOTE_SANITIZE)
  add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=address,undefined)
  add_compile_options($<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)  # GCC 12 misfires inside std::regex and std::optional when sanitizing
endif()

find_program(FINEMOTE_CCACHE ccache)
if(FINEMOTE_CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${FINEMOTE_CCACHE})
endif()

# finemote_module(NAME SOURCES a.cpp ... [LINK lib ...])
# One pipeline stage as a static library `finemote_NAME`; headers are included as "generator/NAME/x.hpp" from the root.
function(finemote_module name)
  cmake_parse_arguments(arg "" "" "SOURCES;LINK" ${ARGN})
  add_library(finemote_${name} STATIC ${arg_SOURCES})
  target_include_directories(finemote_${name} PUBLIC ${PROJECT_SOURCE_DIR})
  target_link_libraries(finemote_${name} PUBLIC ${arg_LINK})
endfunction()

# finemote_test(NAME SOURCES a_test.cpp ... [LINK lib ...])
# One Catch2 program, registered with CTest under its name. Runs with the source folder as FINEMOTE_SOURCE_DIR.
function(finemote_test name)
  cmake_parse_arguments(arg "" "" "SOURCES;LINK" ${ARGN})
  add_executable(${name} ${arg_SOURCES})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/tests)
  target_compile_definitions(${name} PRIVATE FINEMOTE_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  target_link_libraries(${name} PRIVATE catch_main ${arg_LINK})
  add_test(NAME ${name} COMMAND ${name})
endfunction()
