// From the reset clock of 16 MHz to 168 MHz out of a crystal of 12 MHz, register by register in the order ST's HAL
// takes: HAL_Init, HAL_RCC_OscConfig and HAL_RCC_ClockConfig. RM0090 3.5, 5.1.4, 7.2, 7.3.
#pragma once

#include <cstdint>

extern "C" volatile std::uint32_t ticks;  ///< ms since start_clocks(), counted by SysTick

/// What else there is to do at a tick, in its interrupt. A program without it does nothing else.
void on_tick();

/// Waits on the tick with every step, as HAL does. A clock that does not come up holds it for ever.
void start_clocks();
