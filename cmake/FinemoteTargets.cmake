# What is done with a firmware after it was built: targets beside the one of finemote_add_firmware(NAME ...).
#
#   NAME-size       a table of what the image takes, by device and by class, held to FLASH_BUDGET and RAM_BUDGET
#   NAME-hex, -bin  NAME.hex and NAME.bin beside NAME.elf
#   NAME-flash      writes the image with OpenOCD, verifies it and starts it
#   NAME-debug      gdb at the reset of the board, with the image loaded; NAME.gdb tells it where the sources lie
#   NAME-rtt        serves the trace of the running board at TCP port 9090 (an image with TRACE); does not halt it
#   NAME-generate   writes the generated sources (finemote_add_firmware with INPUT)
#   NAME-fresh      fails where committed sources are not those of the robot; -flash, -debug, -hex and -bin ask it first
#
# The first firmware of a project has them under the short names as well: flash, debug, rtt, size, hex, bin, generate.
#
# FINEMOTE_PROBE chooses the debug probe: stlink, cmsis-dap or jlink. Its OpenOCD configuration is openocd/<probe>.cfg of the
# project, or the one that finemote ships. FINEMOTE_OPENOCD and FINEMOTE_GDB name the programs.
set(FINEMOTE_PROBE stlink CACHE STRING "debug probe: stlink, cmsis-dap or jlink")
set_property(CACHE FINEMOTE_PROBE PROPERTY STRINGS stlink cmsis-dap jlink)
option(FINEMOTE_FLASH_STALE "what is flashed may be older than the robot" OFF)
find_program(FINEMOTE_OPENOCD openocd)
find_program(FINEMOTE_GDB NAMES gdb-multiarch arm-none-eabi-gdb)

# The configuration file of the chosen probe.
function(finemote_probe_file result)
  foreach(folder ${CMAKE_SOURCE_DIR} ${FINEMOTE_ROOT}/templates/project)
    if(EXISTS ${folder}/openocd/${FINEMOTE_PROBE}.cfg)
      set(${result} ${folder}/openocd/${FINEMOTE_PROBE}.cfg PARENT_SCOPE)
      return()
    endif()
  endforeach()
  message(FATAL_ERROR "finemote: no file openocd/${FINEMOTE_PROBE}.cfg for FINEMOTE_PROBE; known are stlink, cmsis-dap and jlink")
endfunction()

# finemote_probe_target(NAME what NEEDS program ... COMMAND ...): a target that talks to the board through a terminal, or says
# which of the programs that it needs are missing.
function(finemote_probe_target target what)
  cmake_parse_arguments(arg "" "" "NEEDS;COMMAND" ${ARGN})
  set(package_of_FINEMOTE_OPENOCD openocd)
  set(package_of_FINEMOTE_GDB gdb-multiarch)
  set(missing)
  foreach(program ${arg_NEEDS})
    if(NOT ${program})
      list(APPEND missing ${package_of_${program}})
    endif()
  endforeach()
  if(missing)
    list(JOIN missing " " packages)
    list(JOIN missing " and " words)
    set(arg_COMMAND ${CMAKE_COMMAND} -E echo "needs ${words}: apt-get install ${packages}, then configure again"
                    COMMAND ${CMAKE_COMMAND} -E false)
  endif()
  add_custom_target(${target}-${what} COMMAND ${arg_COMMAND} DEPENDS ${target} USES_TERMINAL VERBATIM)
endfunction()

# The image in the format that objcopy knows under this name.
function(finemote_copied_image target suffix format)
  set(file ${CMAKE_CURRENT_BINARY_DIR}/${target}.${suffix})
  add_custom_command(OUTPUT ${file} COMMAND ${CMAKE_OBJCOPY} -O ${format} $<TARGET_FILE:${target}> ${file}
                     DEPENDS ${target} VERBATIM)
  add_custom_target(${target}-${suffix} DEPENDS ${file})
endfunction()

# NAME.gdb: where the sources lie that the image names in short (finemote_compile_options). For a debugger on this computer.
function(finemote_source_paths target)
  set(text "")
  foreach(folder "robot ${CMAKE_SOURCE_DIR}" "build ${CMAKE_BINARY_DIR}" "finemote ${FINEMOTE_ROOT}")
    string(REPLACE " /" " \"/" folder "${folder}\"")
    string(APPEND text "set substitute-path ${folder}\n")
  endforeach()
  file(CONFIGURE OUTPUT ${target}.gdb CONTENT "${text}" @ONLY)
endfunction()

# Nothing goes to a board that was made of a robot as it was. A build does not ask: what is committed can be looked at.
function(finemote_refuse_stale target)
  if(NOT TARGET ${target}-fresh OR FINEMOTE_FLASH_STALE)
    return()
  endif()
  foreach(what flash debug hex bin)
    add_dependencies(${target}-${what} ${target}-fresh)
  endforeach()
endfunction()

# The short names, once in a project.
function(finemote_short_targets target)
  get_property(first GLOBAL PROPERTY FINEMOTE_FIRST_FIRMWARE)
  if(first)
    return()
  endif()
  set_property(GLOBAL PROPERTY FINEMOTE_FIRST_FIRMWARE ${target})
  foreach(what flash debug rtt size hex bin generate)
    if(TARGET ${target}-${what} AND NOT TARGET ${what})
      add_custom_target(${what} DEPENDS ${target}-${what})
    endif()
  endforeach()
endfunction()

function(finemote_firmware_targets target chips)
  cmake_parse_arguments(arg "" "FLASH_BUDGET;RAM_BUDGET" "" ${ARGN})
  if(chips)
    set(scripts ${FINEMOTE_ROOT}/cmake/scripts)
    set(image $<TARGET_FILE:${target}>)
    finemote_probe_file(probe)
    finemote_source_paths(${target})
    finemote_copied_image(${target} hex ihex)
    finemote_copied_image(${target} bin binary)
    add_custom_target(${target}-size COMMAND ${CMAKE_COMMAND} -DIMAGE=${image} -DNM=${CMAKE_NM} -DOBJDUMP=${CMAKE_OBJDUMP}
                      -DFLASH_BUDGET=${arg_FLASH_BUDGET} -DRAM_BUDGET=${arg_RAM_BUDGET} -P ${scripts}/size.cmake
                      DEPENDS ${target} VERBATIM)
    finemote_probe_target(${target} flash NEEDS FINEMOTE_OPENOCD
                          COMMAND ${FINEMOTE_OPENOCD} -f ${probe} -c "program {${image}} verify reset exit")
    finemote_probe_target(${target} debug NEEDS FINEMOTE_GDB FINEMOTE_OPENOCD COMMAND ${FINEMOTE_GDB} ${image}
                          -x ${CMAKE_CURRENT_BINARY_DIR}/${target}.gdb
                          -ex "target extended-remote | ${FINEMOTE_OPENOCD} -f '${probe}' -c 'gdb_port pipe' -c 'log_output openocd.log'"
                          -ex "monitor reset halt" -ex load -ex "monitor reset halt")
    finemote_probe_target(${target} rtt NEEDS FINEMOTE_OPENOCD COMMAND ${CMAKE_COMMAND} -DIMAGE=${image} -DNM=${CMAKE_NM}
                          -DOPENOCD=${FINEMOTE_OPENOCD} -DPROBE=${probe} -P ${scripts}/rtt.cmake)
    finemote_refuse_stale(${target})
  endif()
  finemote_short_targets(${target})
endfunction()
