# From a robot to the sources of its firmware: used by finemote_add_firmware(... INPUT ...).

# The words after `finemote generate` or `finemote check` that name the robot.
function(finemote_robot_words result input board devices arguments)
  set(words ${input} --data-dir ${FINEMOTE_ROOT})
  finemote_stands_in("${board}" stands_in)
  if(board AND NOT stands_in)  # one that stands in runs what was made for the robot's own board
    list(APPEND words --board ${board})
  endif()
  foreach(folder ${devices})
    get_filename_component(folder ${folder} ABSOLUTE)
    list(APPEND words --device-path ${folder})
  endforeach()
  set(${result} ${words} ${arguments} PARENT_SCOPE)
endfunction()

# What `finemote generate --list` says of the robot, as JSON.
function(finemote_ask_for_list target words result)
  get_target_property(program finemote::finemote IMPORTED_LOCATION)
  execute_process(COMMAND ${program} generate ${words} --list --format json OUTPUT_VARIABLE document RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "finemote_add_firmware(${target}): no firmware can be made of this robot; see above")
  endif()
  set(${result} "${document}" PARENT_SCOPE)
endfunction()

# The strings of a list in a JSON document; `member` takes one out of each entry.
function(finemote_strings document name result)
  set(strings)
  string(JSON size LENGTH "${document}" ${name})
  if(size GREATER 0)
    math(EXPR last "${size} - 1")
    foreach(i RANGE ${last})
      string(JSON text GET "${document}" ${name} ${i} ${ARGN})
      list(APPEND strings "${text}")
    endforeach()
  endif()
  set(${result} "${strings}" PARENT_SCOPE)
endfunction()

# A path as file(GLOB) takes it: a folder whose name has brackets is no pattern.
function(finemote_glob_path path result)
  string(REPLACE "[" "[[]" escaped "${path}")
  set(${result} "${escaped}" PARENT_SCOPE)
endfunction()

# Where the robot's timing file is, or would be.
function(finemote_timing_file_of input result)
  string(REGEX REPLACE "(\\.urdf)?\\.xacro$|\\.urdf$" "" base ${input})
  set(${result} ${base}.timing.json PARENT_SCOPE)
endfunction()

# The files beside the robot that count as soon as they are there: every build looks for them.
function(finemote_files_beside input result)
  get_filename_component(folder ${input} DIRECTORY)
  finemote_timing_file_of(${input} times)
  finemote_glob_path("${folder}/finemote.json;${times}" patterns)
  file(GLOB files CONFIGURE_DEPENDS ${patterns})
  set(${result} ${files} PARENT_SCOPE)
endfunction()

# Sources that are generated into `folder` when something changed that they depend on. Files whose bytes stay the same are
# not touched, so nothing is compiled for them. Which files there are depends on the robot: when a file of its own changes,
# CMake asks for the list again.
function(finemote_generate_in_build target words beside folder list)
  if(NOT CMAKE_GENERATOR MATCHES "Ninja")
    message(FATAL_ERROR "finemote_add_firmware(${target}): without COMMITTED the build needs Ninja: configure with -G Ninja")
  endif()
  get_target_property(program finemote::finemote IMPORTED_LOCATION)
  finemote_strings("${list}" files files)
  list(TRANSFORM files PREPEND ${folder}/)
  set(manifest ${folder}/finemote.manifest.json)
  list(REMOVE_ITEM files ${manifest})
  file(GLOB templates ${FINEMOTE_ROOT}/templates/*.mustache)
  list(GET words 0 input)
  add_custom_command(OUTPUT ${manifest} BYPRODUCTS ${files}
                     COMMAND ${program} -q generate ${words} -o ${folder} --depfile ${folder}.d
                     DEPENDS ${input} ${beside} ${program} ${templates} DEPFILE ${folder}.d
                     COMMENT "Generating the sources of ${target}" VERBATIM)
  add_custom_target(${target}-generate DEPENDS ${manifest})
  finemote_strings("${list}" inputs inputs)
  foreach(file ${inputs})
    string(FIND "${file}" "${FINEMOTE_ROOT}/" at)
    if(NOT at EQUAL 0)  # those change with the program
      set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    endif()
  endforeach()
endfunction()

# Sources that lie in `folder`, as its manifest lists them; the test NAME-check and the target NAME-fresh hold them to the robot.
function(finemote_use_committed target words folder result)
  get_target_property(program finemote::finemote IMPORTED_LOCATION)
  list(JOIN words " " command)
  set(command "finemote generate ${command} -o ${folder}")
  set(manifest ${folder}/finemote.manifest.json)
  if(NOT EXISTS ${manifest})
    message(FATAL_ERROR "finemote_add_firmware(${target}): there are no generated sources in ${folder}; write them with\n"
                        "  ${command}")
  endif()
  file(READ ${manifest} document)
  finemote_strings("${document}" outputs files name)
  list(TRANSFORM files PREPEND ${folder}/)
  foreach(file ${files})
    if(NOT EXISTS ${file})
      message(FATAL_ERROR "finemote_add_firmware(${target}): ${file} is missing; write it with\n  ${command}")
    endif()
  endforeach()
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${manifest})
  add_custom_target(${target}-generate COMMAND ${program} generate ${words} -o ${folder} VERBATIM)
  add_test(NAME ${target}-check COMMAND ${program} check ${words} -o ${folder})
  add_custom_target(${target}-fresh COMMAND ${CMAKE_COMMAND} -DPROGRAM=${program} "-DWORDS=${words}" -DFOLDER=${folder}
                    -P ${FINEMOTE_ROOT}/cmake/scripts/fresh.cmake VERBATIM COMMENT "Checking that ${folder} is what the robot gives")
  set(${result} ${files} PARENT_SCOPE)
endfunction()

# A timing file bounds the image that `finemote wcet` builds: options that make another one are refused beside it.
function(finemote_check_timed_options target words optimize code robots_code)
  list(GET words 0 input)
  finemote_timing_file_of(${input} times)
  if(NOT EXISTS ${times})
    return()
  elseif(NOT optimize STREQUAL "-Os")
    message(FATAL_ERROR "finemote_add_firmware(${target}): ${times} bounds the code of -Os, not of ${optimize}: leave out "
                        "OPTIMIZE, or remove that file and the proof of these times")
  elseif(NOT code STREQUAL robots_code)
    message(FATAL_ERROR "finemote_add_firmware(${target}): ${times} bounds code in ${robots_code}, not in ${code}: instead of CODE "
                        "write <param name=\"code\">${code}</param> into the robot's <board>, and bound it anew")
  endif()
endfunction()

# After linking: no stage may take longer than the robot's timing file says, where it has one (docs/wcet.md).
function(finemote_hold_to_timing_file target words)
  list(GET words 0 input)
  finemote_timing_file_of(${input} times)
  get_target_property(program finemote::finemote IMPORTED_LOCATION)
  add_custom_command(TARGET ${target} POST_BUILD
                     COMMAND ${CMAKE_COMMAND} -DPROGRAM=${program} "-DWORDS=${words}" -DIMAGE=$<TARGET_FILE:${target}>
                             -DTIMES=${times} -DBOUNDS=${CMAKE_CURRENT_BINARY_DIR}/${target}.wcet.json
                             -P ${FINEMOTE_ROOT}/cmake/scripts/times.cmake
                     COMMENT "Checking ${target} against its timing file" VERBATIM)
  if(EXISTS ${times})
    set_property(TARGET ${target} APPEND PROPERTY LINK_DEPENDS ${times})
  endif()
endfunction()

# For finemote_add_firmware(NAME INPUT ...): sets generated_dir, generated, robot_code and robot_words, arg_BOARD where it is the robot's, and adds
# what belongs to the robot's own device types to arg_INCLUDES and arg_SOURCES. The arguments are those of the caller.
function(finemote_sources_of_input target)
  if(NOT TARGET finemote::finemote)
    message(FATAL_ERROR "finemote_add_firmware(${target}): INPUT needs find_package(finemote)")
  endif()
  get_filename_component(input ${arg_INPUT} ABSOLUTE)
  finemote_robot_words(words ${input} "${arg_BOARD}" "${arg_DEVICES}" "${arg_ARGS}")
  finemote_files_beside(${input} beside)
  finemote_ask_for_list(${target} "${words}" list)
  if(NOT arg_OUTPUT_DIR AND arg_COMMITTED)
    set(arg_OUTPUT_DIR generated)
  elseif(NOT arg_OUTPUT_DIR)
    set(arg_OUTPUT_DIR ${CMAKE_CURRENT_BINARY_DIR}/${target}.generated)
  endif()
  get_filename_component(folder ${arg_OUTPUT_DIR} ABSOLUTE)
  get_property(other GLOBAL PROPERTY "FINEMOTE_SOURCES_IN ${folder}")
  if(other AND NOT "${other}" STREQUAL "${words}")
    list(GET other 0 file)
    message(FATAL_ERROR "finemote_add_firmware(${target}): the sources in ${folder} are those of ${file} or of other arguments; give "
                        "each robot an OUTPUT_DIR of its own")
  endif()
  set_property(GLOBAL PROPERTY "FINEMOTE_SOURCES_IN ${folder}" "${words}")
  if(arg_COMMITTED)
    finemote_use_committed(${target} "${words}" ${folder} generated)
  else()
    finemote_generate_in_build(${target} "${words}" "${beside}" ${folder} "${list}")
    finemote_strings("${list}" files files)
    list(TRANSFORM files PREPEND ${folder}/ OUTPUT_VARIABLE generated)
  endif()

  list(FILTER generated INCLUDE REGEX "\\.cpp$")
  list(SORT generated)  # the order of the linker, and of `finemote run`
  if(NOT arg_BOARD)
    string(JSON arg_BOARD GET "${list}" board)
  endif()
  string(JSON robot_code GET "${list}" code)
  set(robot_code ${robot_code} PARENT_SCOPE)
  set(robot_words ${words} PARENT_SCOPE)
  finemote_strings("${list}" include_dirs folders)
  foreach(own ${folders})
    finemote_glob_path("${own}" pattern)
    file(GLOB sources "${pattern}/*.cpp")
    list(APPEND arg_SOURCES ${sources})
  endforeach()
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${folders})  # sources that come and go
  set(generated_dir ${folder} PARENT_SCOPE)
  set(generated ${generated} PARENT_SCOPE)
  set(arg_BOARD ${arg_BOARD} PARENT_SCOPE)
  set(arg_INCLUDES ${arg_INCLUDES} ${folders} PARENT_SCOPE)
  set(arg_SOURCES ${arg_SOURCES} PARENT_SCOPE)
endfunction()
