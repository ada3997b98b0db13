# cmake -DIMAGE=elf -DNM=program -DOPENOCD=program -DPROBE=cfg -P rtt.cmake: serves RTT channel 0 of a running board.
#
# OpenOCD gets the place of the control block from the image: it would take the first text in RAM that looks like one. It has
# no work area, because using one would overwrite the RAM of a robot that runs.
execute_process(COMMAND ${NM} ${IMAGE} OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
if(NOT symbols MATCHES "([0-9a-f]+) [A-Za-z] _SEGGER_RTT\n")
  message(FATAL_ERROR "this image records no trace: add TRACE to finemote_add_firmware")
endif()
set(address 0x${CMAKE_MATCH_1})
message(STATUS "trace of the board at localhost:9090, until Ctrl-C; for example: nc localhost 9090 > trace.bin")
execute_process(COMMAND ${OPENOCD} -c "set WORKAREASIZE 0" -f ${PROBE} -c init -c "rtt setup ${address} 16 \"SEGGER RTT\""
                        -c "rtt polling_interval 1" -c "rtt start" -c "rtt server start 9090 0"
                COMMAND_ERROR_IS_FATAL ANY)
