# cmake -DPROGRAM=finemote -DWORDS=words -DIMAGE=elf -DTIMES=robot.timing.json -DBOUNDS=file -P times.cmake
#
# Bounds the stages of a linked image, and fails where one can take longer than the robot's timing file says, or has no bound
# although it has one there.
cmake_policy(VERSION 3.25)
if(NOT EXISTS ${TIMES})
  return()
endif()

# Sets `prefix`_DEVICE.STAGE to the bound of each stage of a document of finemote.wcet/1, and `prefix` to their names.
function(bounds_of document prefix)
  string(JSON count LENGTH "${document}" stages)
  set(names)
  if(count GREATER 0)
    math(EXPR last "${count} - 1")
    foreach(i RANGE ${last})
      string(JSON device GET "${document}" stages ${i} device)
      string(JSON stage GET "${document}" stages ${i} stage)
      string(JSON bound GET "${document}" stages ${i} wcet_ns)
      list(APPEND names ${device}.${stage})
      set(${prefix}_${device}.${stage} ${bound} PARENT_SCOPE)
    endforeach()
  endif()
  set(${prefix} ${names} PARENT_SCOPE)
endfunction()

execute_process(COMMAND ${PROGRAM} -q wcet ${WORDS} --elf ${IMAGE} -o ${BOUNDS} RESULT_VARIABLE status OUTPUT_QUIET)
if(NOT status MATCHES "^[01]$")  # 1: something has no bound; whether it had one is seen below
  message(FATAL_ERROR "the execution times of ${IMAGE} cannot be bounded; see above")
endif()
file(READ ${TIMES} granted)
file(READ ${BOUNDS} found)
bounds_of("${granted}" allowed)
bounds_of("${found}" bound)
set(mistakes)
foreach(stage ${allowed})
  if(NOT DEFINED bound_${stage})
    string(APPEND mistakes "  ${stage} has no bound any more\n")
  elseif(bound_${stage} GREATER allowed_${stage})
    string(APPEND mistakes "  ${stage} can take ${bound_${stage}} ns, ${allowed_${stage}} ns are granted\n")
  endif()
endforeach()
if(mistakes)
  list(GET WORDS 0 input)
  message(FATAL_ERROR "this image is slower than ${TIMES} says:\n${mistakes}"
                      "make the code faster, or bound it anew and look at the difference: finemote wcet ${input} -o ${TIMES}")
endif()
