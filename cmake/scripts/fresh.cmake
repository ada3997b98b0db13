# cmake -DPROGRAM=finemote -DWORDS=words -DFOLDER=generated -P fresh.cmake
#
# Fails where the sources in the folder are not what the robot gives. What else `finemote check` objects to, requirements for
# example, is no reason not to flash.
cmake_policy(VERSION 3.25)
execute_process(COMMAND ${PROGRAM} check ${WORDS} -o ${FOLDER} --format json OUTPUT_VARIABLE said ERROR_VARIABLE problem)
string(JSON fresh ERROR_VARIABLE unknown GET "${said}" fresh)
if(NOT fresh)
  execute_process(COMMAND ${PROGRAM} check ${WORDS} -o ${FOLDER})
  message(FATAL_ERROR "${FOLDER} is not what the robot gives; -DFINEMOTE_FLASH_STALE=ON flashes it all the same")
endif()
