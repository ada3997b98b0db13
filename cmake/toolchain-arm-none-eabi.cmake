# Cross-compiles for a Cortex-M4 with single-precision FPU, with newlib-nano.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR cortex-m4)
find_program(FINEMOTE_ARM_COMPILER arm-none-eabi-g++)
if(NOT FINEMOTE_ARM_COMPILER)
  message(FATAL_ERROR "there is no 'arm-none-eabi-g++' in PATH; install it, for example: "
                      "apt-get install gcc-arm-none-eabi libnewlib-arm-none-eabi libstdc++-arm-none-eabi-newlib")
endif()
set(CMAKE_CXX_COMPILER arm-none-eabi-g++)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
# Beside CMAKE_CXX_FLAGS, which are the user's; the compiler takes one --specs, and theirs counts.
set(finemote_options -mcpu=cortex-m4 -mthumb -mfpu=fpv4-sp-d16 -mfloat-abi=hard -ffreestanding)
if(NOT CMAKE_CXX_FLAGS MATCHES "--specs=")
  list(APPEND finemote_options --specs=nano.specs)
endif()
add_compile_options(${finemote_options})
add_link_options(${finemote_options})
# These options decide what is built; a build type would only add to them.
set(CMAKE_BUILD_TYPE "" CACHE STRING "")
