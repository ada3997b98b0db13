# Compiler options shared by all host code: C++20, warnings as errors, optional sanitizers, ccache.
option(FINEMOTE_TESTS "Build the tests, with warnings" ON)
option(FINEMOTE_PRECOMPILED "Compile all host code with one precompiled header" OFF)
set(FINEMOTE_UNITY 0 CACHE STRING "Source files of a module that are compiled as one at most; 0: each by itself")
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(FINEMOTE_TESTS)
  add_compile_options(-Wall -Wextra -Wpedantic)
  # Errors with the compilers of Debian 12: newer ones warn of more, and newer libraries deprecate what it has nothing else for.
  if((CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13) OR
     (CMAKE_CXX_COMPILER_ID STREQUAL "Clang" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 15))
    add_compile_options(-Werror)
  endif()
endif()
# Floating point is computed as written, so that the same input gives the same bytes on every machine.
add_compile_options(-ffp-contract=off)

if(FINEMOTE_PRECOMPILED)
  find_program(FINEMOTE_GOLD ld.gold)  # links in less than half the time, where a system still has it
  if(FINEMOTE_GOLD)
    add_link_options(-fuse-ld=gold)
  endif()
  add_compile_definitions(EIGEN_DONT_VECTORIZE)  # as the emulator has it: all that share a header share its definitions
endif()

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

# finemote_precompiled(TARGET): gives it the precompiled header, if there is one. It holds what takes long to read; nothing may
# rely on it.
function(finemote_precompiled target)
  if(NOT FINEMOTE_PRECOMPILED)
    return()
  endif()
  if(NOT TARGET finemote_common_headers)
    add_library(finemote_common_headers OBJECT ${PROJECT_SOURCE_DIR}/cmake/project/common_headers.cpp)
    target_include_directories(finemote_common_headers PRIVATE ${PROJECT_SOURCE_DIR})
    target_link_libraries(finemote_common_headers PRIVATE fmt::fmt nlohmann_json::nlohmann_json Eigen3::Eigen)
    target_precompile_headers(finemote_common_headers PRIVATE <fmt/format.h> <nlohmann/json.hpp> <Eigen/Geometry> <algorithm>
                              <filesystem> <functional> "${PROJECT_SOURCE_DIR}/emulator/outfit/outfit.hpp"
                              "${PROJECT_SOURCE_DIR}/generator/run/run_result.hpp")
  endif()
  target_precompile_headers(${target} REUSE_FROM finemote_common_headers)
endfunction()

# finemote_unity(TARGET): compiles its sources in batches of one size, if asked for, so that no core waits for the largest. So names
# in a module's files differ, those of unnamed namespaces too.
function(finemote_unity target)
  if(NOT FINEMOTE_UNITY GREATER 0)
    return()
  endif()
  get_target_property(sources ${target} SOURCES)
  list(LENGTH sources count)
  math(EXPR batches "(${count} + ${FINEMOTE_UNITY} - 1) / ${FINEMOTE_UNITY}")
  math(EXPR size "(${count} + ${batches} - 1) / ${batches}")
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${size})
endfunction()

# finemote_module(NAME SOURCES a.cpp ... [LINK lib ...])
# One pipeline stage as a static library `finemote_NAME`; headers are included as "generator/NAME/x.hpp" from the root.
function(finemote_module name)
  cmake_parse_arguments(arg "" "" "SOURCES;LINK" ${ARGN})
  add_library(finemote_${name} STATIC ${arg_SOURCES})
  target_include_directories(finemote_${name} PUBLIC ${PROJECT_SOURCE_DIR})
  target_link_libraries(finemote_${name} PUBLIC ${arg_LINK})
  finemote_precompiled(finemote_${name})
  finemote_unity(finemote_${name})
endfunction()

# finemote_test(NAME SOURCES a_test.cpp ... [LINK lib ...])
# One Catch2 program, registered with CTest under its name.
function(finemote_test name)
  cmake_parse_arguments(arg "" "" "SOURCES;LINK" ${ARGN})
  add_executable(${name} ${arg_SOURCES})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/tests)
  target_link_libraries(${name} PRIVATE catch_main finemote_source_dir ${arg_LINK})
  add_test(NAME ${name} COMMAND ${name})
endfunction()
