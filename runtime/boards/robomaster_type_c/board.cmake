# An STM32F407 on the shared Cortex-M4 code. Ports (ports/*.cpp) are linked when a robot uses them: with a port come its
# interrupt routines and buffers.
set(FINEMOTE_BOARD_FAMILY cortex_m4)
set(FINEMOTE_BOARD_DEFINITIONS FINEMOTE_SILENT)  # nobody listens: a debugger reads the fault records
