# Cross-compiles for a Cortex-M4 with single-precision FPU, with newlib-nano.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR cortex-m4)
find_program(FINEMOTE_ARM_COMPILER arm-none-eabi-g++)
if(NOT FINEMOTE_ARM_COMPILER)
  message(FATAL_ERROR "there is no 'arm-none-eabi-g++' in PATH; install it, for example: "
                      "apt-get install gcc-arm-none-eabi libnewlib-arm-none-eabi libstdc++-arm-none-eabi-newlib")
endif()
set(CMAKE_CXX_COMPILER arm-none-eabi-g++)
# Of projects that have such sources; without them CMake would look for compilers of this computer.
set(CMAKE_C_COMPILER arm-none-eabi-gcc)
set(CMAKE_ASM_COMPILER arm-none-eabi-gcc)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
# Not -ffreestanding: from GCC 13 on that takes <cmath> away. Of it, only that calls and loops stay what the source says is
# wanted. Beside CMAKE_CXX_FLAGS, which are the user's; the compiler takes one --specs, and theirs counts.
set(finemote_options -mcpu=cortex-m4 -mthumb -mfpu=fpv4-sp-d16 -mfloat-abi=hard -fno-builtin)
if(NOT CMAKE_CXX_FLAGS MATCHES "--specs=")
  list(APPEND finemote_options --specs=nano.specs)
endif()
add_compile_options(${finemote_options})
add_link_options(${finemote_options})
# The headers of the C++ library are enough for what finemote ships and generates; its archive is linked where it is installed.
if(NOT FINEMOTE_CXX_ARCHIVE_OF STREQUAL FINEMOTE_ARM_COMPILER OR NOT EXISTS "${FINEMOTE_CXX_ARCHIVE}")
  execute_process(COMMAND ${FINEMOTE_ARM_COMPILER} -mcpu=cortex-m4 -mthumb -mfpu=fpv4-sp-d16 -mfloat-abi=hard
                          -print-file-name=libstdc++.a OUTPUT_VARIABLE finemote_cxx_archive OUTPUT_STRIP_TRAILING_WHITESPACE)
  set(FINEMOTE_CXX_ARCHIVE ${finemote_cxx_archive} CACHE INTERNAL "")
  set(FINEMOTE_CXX_ARCHIVE_OF ${FINEMOTE_ARM_COMPILER} CACHE INTERNAL "")
endif()
if(NOT EXISTS "${FINEMOTE_CXX_ARCHIVE}")
  add_link_options(-nodefaultlibs)
  foreach(language C CXX)
    set(CMAKE_${language}_STANDARD_LIBRARIES_INIT "-Wl,--start-group -lc_nano -lm -lgcc -Wl,--end-group")
  endforeach()
endif()
# These options decide what is built; a build type would only add to them.
set(CMAKE_BUILD_TYPE "" CACHE STRING "")
