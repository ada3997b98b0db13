# The data the tool reads at run time: beside the built program as `share`, installed as `share/finemote`.
set(FINEMOTE_DATA_FOLDERS schemas templates runtime cmake)
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/share)
foreach(folder ${FINEMOTE_DATA_FOLDERS})
  file(CREATE_LINK ${PROJECT_SOURCE_DIR}/${folder} ${PROJECT_BINARY_DIR}/share/${folder} SYMBOLIC)
  install(DIRECTORY ${folder} DESTINATION share/finemote)
endforeach()
# The page of every diagnostic, which `finemote explain` prints.
file(CREATE_LINK ${PROJECT_SOURCE_DIR}/docs/diagnostics ${PROJECT_BINARY_DIR}/share/diagnostics SYMBOLIC)
install(DIRECTORY docs/diagnostics DESTINATION share/finemote)
install(TARGETS finemote finemote-emulator DESTINATION bin)
