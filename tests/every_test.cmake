# What becomes of tests that cannot run here. `./dev test` sets the option on Debian 12, where every tool is to be had.
option(FINEMOTE_EVERY_TEST "A test that cannot run is a failure" OFF)

# finemote_without(WHAT): some tests are left out, because something is missing.
function(finemote_without what)
  if(FINEMOTE_EVERY_TEST)
    message(FATAL_ERROR "${what}")
  endif()
  message(WARNING "${what}")
endfunction()

# finemote_may_skip(TEST): exit status 77 says that it cannot run here.
function(finemote_may_skip test)
  if(NOT FINEMOTE_EVERY_TEST)
    set_tests_properties(${test} PROPERTIES SKIP_RETURN_CODE 77)
  endif()
endfunction()
