# What `cmake --install` installs, and the data the tool reads at run time: beside the built program as `share`, installed as
# `share/finemote`. All destinations are relative, so that the installed folder can be moved.
include(CMakePackageConfigHelpers)

set(FINEMOTE_DATA_FOLDERS schemas templates runtime cmake examples)
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/share)
foreach(folder ${FINEMOTE_DATA_FOLDERS})
  file(CREATE_LINK ${PROJECT_SOURCE_DIR}/${folder} ${PROJECT_BINARY_DIR}/share/${folder} SYMBOLIC)
  install(DIRECTORY ${folder} DESTINATION share/finemote PATTERN cmake/project EXCLUDE PATTERN runtime/CMakeLists.txt EXCLUDE)
endforeach()
# The page of every diagnostic, which `finemote explain` prints.
file(CREATE_LINK ${PROJECT_SOURCE_DIR}/docs/diagnostics ${PROJECT_BINARY_DIR}/share/diagnostics SYMBOLIC)
install(DIRECTORY docs/diagnostics DESTINATION share/finemote)
# The manual, beside the folders that its pages link to.
install(FILES README.md README.zh-CN.md CHANGELOG.md LICENSE DESTINATION share/finemote)
install(DIRECTORY docs DESTINATION share/finemote PATTERN docs/diagnostics EXCLUDE PATTERN docs/build.sh EXCLUDE PATTERN docs/api.py EXCLUDE)
install(CODE [[file(CREATE_LINK ../diagnostics $ENV{DESTDIR}${CMAKE_INSTALL_PREFIX}/share/finemote/docs/diagnostics SYMBOLIC)]])
install(TARGETS finemote finemote-emulator DESTINATION bin)

# find_package looks into share/finemote/cmake. The package is for the computer that builds, whatever the project is for.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/finemoteConfigVersion.cmake VERSION ${PROJECT_VERSION}
                                 COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(FILES ${PROJECT_BINARY_DIR}/finemoteConfigVersion.cmake DESTINATION share/finemote/cmake)

# The manual pages, and what completes the words of a command line, made by the programs themselves.
set(pages ${PROJECT_BINARY_DIR}/pages)
file(MAKE_DIRECTORY ${pages})
add_custom_command(OUTPUT ${pages}/finemote.1 ${pages}/finemote-emulator.1 ${pages}/finemote ${pages}/_finemote
                          ${pages}/finemote.fish
                   COMMAND finemote man > ${pages}/finemote.1
                   COMMAND finemote-emulator --man > ${pages}/finemote-emulator.1
                   COMMAND finemote completion bash > ${pages}/finemote
                   COMMAND finemote completion zsh > ${pages}/_finemote
                   COMMAND finemote completion fish > ${pages}/finemote.fish
                   DEPENDS finemote finemote-emulator)
add_custom_target(finemote_pages ALL DEPENDS ${pages}/finemote.1)
install(FILES ${pages}/finemote.1 ${pages}/finemote-emulator.1 DESTINATION share/man/man1)
install(FILES ${pages}/finemote DESTINATION share/bash-completion/completions)
install(FILES ${pages}/_finemote DESTINATION share/zsh/site-functions)
install(FILES ${pages}/finemote.fish DESTINATION share/fish/vendor_completions.d)
