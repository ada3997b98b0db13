# The Debian package, by CPack: `./dev package`.
#
# The version says for which system it was built: a package of Debian 12 is finemote_0.1.0~deb12_amd64.deb. Two packages of one
# commit are the same bytes: every date is SOURCE_DATE_EPOCH.
file(STRINGS /etc/os-release system_lines REGEX "^(ID|VERSION_ID)=")
foreach(line ${system_lines})
  if(line MATCHES "^([A-Z_]+)=\"?([^\"]*)\"?$")
    set(system_${CMAKE_MATCH_1} ${CMAKE_MATCH_2})
  endif()
endforeach()
string(REGEX REPLACE "^debian$" "deb" system_ID "${system_ID}")

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME finemote)
set(CPACK_PACKAGE_CONTACT "FineMote maintainers <finemote@users.noreply.github.com>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_PACKAGE_VERSION ${PROJECT_VERSION}~${system_ID}${system_VERSION_ID})
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION devel)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "firmware of robots from their URDF, with proven latency
finemote reads a URDF or xacro that is extended with board, buses, devices
and periods, proves how old every command can be, and generates the firmware
as plain C++17. This package has the generator, an emulated STM32F407 board
to run images on, the runtime that generated sources are linked with, and a
CMake package.")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS
    "cmake, ninja-build, g++, gcc-arm-none-eabi, libnewlib-arm-none-eabi, libstdc++-arm-none-eabi-newlib")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "openocd, gdb-multiarch")
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_LIST_DIR}/debian/postinst)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/debian/documents.cmake)
set(CPACK_FINEMOTE_SOURCES ${PROJECT_SOURCE_DIR})
include(CPack)
