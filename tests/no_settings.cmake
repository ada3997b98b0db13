# Included by ctest before it runs a test: none sees the settings of whoever started it.
file(STRINGS ${CMAKE_CURRENT_LIST_DIR}/settings_of_users.txt names)
foreach(name ${names})
  unset(ENV{${name}})
endforeach()
