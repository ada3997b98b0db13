// Interrupt lines of the chip, and how to ask for one (RM0090 12.2, table 62: vector table of the STM32F405/407).
#pragma once

#include <cstdint>

#include "runtime/chips/stm32f4/registers/register.hpp"

namespace finemote::stm32f4 {

/// Makes the line's routine run as soon as its priority allows: NVIC_ISPR, PM0214 4.3.4. From everywhere.
inline void pend_line(unsigned line) { Register{0xE000E200 + 4 * (line / 32)}.write(bit(line % 32)); }

/// Lets the bus see every write so far before the routine returns: a flag cleared by its last instruction could else
/// still raise the line when the return is made. Reads back a register of the same peripheral.
inline void settle(const Register& last_written) { static_cast<void>(last_written.read()); }

}  // namespace finemote::stm32f4
