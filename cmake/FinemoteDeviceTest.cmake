# Tests devices on the computer, without a board.
#
#   finemote_add_device_test(NAME SOURCES file ... [INCLUDES dir ...] [LINK library ...])
#
# Makes a program of SOURCES, which have a main(), and registers it with CTest. It is linked with the runtime, all shipped
# devices and the bench: virtual time, a wire behind every port, and models of parts (finemote/bench/bench.hpp, parts.hpp,
# checks.hpp). INCLUDES: folders of the devices under test. LINK: a test framework, for example.
include(${CMAKE_CURRENT_LIST_DIR}/FinemoteCompile.cmake)

# The bench and the host board, compiled once in a project.
function(finemote_bench_objects definitions)
  if(TARGET finemote_bench)
    return()
  endif()
  set(runtime ${FINEMOTE_ROOT}/runtime)
  file(GLOB sources ${runtime}/bench/*.cpp ${runtime}/boards/host/*.cpp)
  list(REMOVE_ITEM sources ${runtime}/boards/host/main.cpp)
  finemote_shipped_library(finemote_bench OBJECT host "" "" SOURCES ${sources} DEFINITIONS ${definitions})
  target_include_directories(finemote_bench SYSTEM PRIVATE ${runtime}/bench)
endfunction()

function(finemote_add_device_test name)
  cmake_parse_arguments(arg "" "" "SOURCES;INCLUDES;LINK" ${ARGN})
  if(arg_UNPARSED_ARGUMENTS OR NOT arg_SOURCES)
    message(FATAL_ERROR "finemote_add_device_test(${name}): write finemote_add_device_test(${name} SOURCES file ... "
                        "[INCLUDES dir ...] [LINK library ...])")
  endif()
  finemote_board(host chips definitions)
  finemote_check_compiler(host "${chips}")
  finemote_bench_objects("${definitions}")
  finemote_runtime_library(runtime host "" "${definitions}" "")
  add_executable(${name} ${arg_SOURCES} $<TARGET_OBJECTS:finemote_bench>)
  finemote_compile_options(${name} host "" "")
  target_compile_definitions(${name} PRIVATE ${definitions})
  target_include_directories(${name} SYSTEM PRIVATE ${FINEMOTE_ROOT}/runtime/bench)
  target_include_directories(${name} PRIVATE ${arg_INCLUDES})
  target_link_libraries(${name} PRIVATE ${arg_LINK} ${runtime})
  add_test(NAME ${name} COMMAND ${name})
endfunction()
