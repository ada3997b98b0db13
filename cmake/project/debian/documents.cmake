# Run by CPack before it packs: what a Debian package has to say of itself, in usr/share/doc/finemote.
#
# The programs hold code of the packages below: headers, and one static library. Their licences are taken from where the system
# that builds keeps them.
set(bundled libcli11-dev nlohmann-json3-dev libvalijson-dev libkainjow-mustache-dev libdtl-dev libeigen3-dev libboost-dev
            libcapstone-dev)

set(documents ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/usr/share/doc/finemote)
file(MAKE_DIRECTORY ${documents})

file(READ ${CMAKE_CURRENT_LIST_DIR}/copyright text)
foreach(package ${bundled})
  file(READ /usr/share/doc/${package}/copyright licence)
  string(APPEND text "\n${package}\n${licence}")
endforeach()
file(WRITE ${documents}/copyright "${text}")

# SOURCE_DATE_EPOCH is what the clock shows.
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(WRITE ${documents}/changelog
     "finemote (${CPACK_DEBIAN_PACKAGE_VERSION}) stable; urgency=medium\n\n"
     "  * The changes are in CHANGELOG.md of the sources.\n\n"
     " -- ${CPACK_PACKAGE_CONTACT}  ${date}\n")
file(COPY ${CPACK_FINEMOTE_SOURCES}/CHANGELOG.md DESTINATION ${documents})
file(CREATE_LINK ../../finemote/README.md ${documents}/README.md SYMBOLIC)
file(CREATE_LINK ../../finemote/docs ${documents}/docs SYMBOLIC)
# Where Debian's zsh looks for what packages bring.
file(RENAME ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/usr/share/zsh/site-functions
     ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/usr/share/zsh/vendor-completions)
file(GLOB pages ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/usr/share/man/man1/*.1)
execute_process(COMMAND gzip -9nf ${documents}/changelog ${documents}/CHANGELOG.md ${pages} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND chmod -R u=rwX,go=rX ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/usr COMMAND_ERROR_IS_FATAL ANY)
