# find_package(finemote): the program, and the functions that make firmware of a robot and test its devices.
#
#   finemote::finemote         the program, to be used in commands; -DFINEMOTE_EXECUTABLE=... names another one
#   finemote_add_firmware      FinemoteFirmware.cmake
#   finemote_add_device_test   FinemoteDeviceTest.cmake
#
# The package runs on the computer that builds, also where the project is configured for a board: it is found like any
# package, by CMAKE_PREFIX_PATH, or because `finemote` is in PATH. Nothing in it is an absolute path.
include(${CMAKE_CURRENT_LIST_DIR}/FinemoteFirmware.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/FinemoteDeviceTest.cmake)

if(NOT TARGET finemote::finemote)
  set(finemote_program ${FINEMOTE_EXECUTABLE})
  # installed; staged by the build of finemote; its sources
  foreach(place ${FINEMOTE_ROOT}/../../bin ${FINEMOTE_ROOT}/.. ${FINEMOTE_ROOT}/build/host)
    if(NOT finemote_program AND EXISTS ${place}/finemote)
      get_filename_component(finemote_program ${place}/finemote ABSOLUTE)
    endif()
  endforeach()
  if(NOT finemote_program)
    set(finemote_FOUND FALSE)
    set(finemote_NOT_FOUND_MESSAGE "the program 'finemote' is not beside the package; set FINEMOTE_EXECUTABLE to its path")
    return()
  endif()
  add_executable(finemote::finemote IMPORTED GLOBAL)
  set_target_properties(finemote::finemote PROPERTIES IMPORTED_LOCATION ${finemote_program})
  unset(finemote_program)
endif()
