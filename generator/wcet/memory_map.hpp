// What is where in the address space of an STM32F405/407, and how long an access of the core waits there.
#pragma once

#include <cstdint>

#include "generator/wcet/interval.hpp"

namespace finemote::gen::wcet {

/// Cycles of the core.
using Cycles = std::int64_t;

/// Where the code runs.
enum class Placement {
  sram,   ///< in SRAM1, which is mapped to address 0, with all constants
  flash,  ///< in flash at 168 MHz, five wait states, caches and prefetch on
};

/// Longest wait of one access beyond what the instruction takes, wherever in `address` it goes; a store waits for its
/// write here, not where the next access meets it. DMA is not in it: it is a stream of its own.
/// An address of which nothing is known is one of a variable or a constant: no variable holds the address of a
/// peripheral, and where the code runs in SRAM the constants lie there, too.
/// Sources: RM0090 2.3 and 3.5 (no wait states in RAM, five in flash), AN4031 tables 4 and 5 (bus matrix, bridges).
Cycles longest_wait(Interval address, Placement placement);

}  // namespace finemote::gen::wcet
