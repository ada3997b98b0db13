// What is where in the address space of an STM32F405/407, and how long an access of the core waits there.
#pragma once

#include <cstdint>
#include <optional>

#include "generator/wcet/interval.hpp"

namespace finemote::gen::wcet {

/// Cycles of the core.
using Cycles = std::int64_t;

/// Where the code runs.
enum class Placement {
  sram,   ///< in SRAM1, which is mapped to address 0, with all constants
  flash,  ///< in flash at 168 MHz, five wait states, caches and prefetch on
};

/// Cycles of one access beyond what the instruction takes, by where it goes.
/// Sources: RM0090 2.3 and 3.5 (no wait states in RAM, five in flash), AN4031 tables 4 and 5 (bus matrix, bridges).
struct MemoryWaits {
  Cycles flash = 5 + 6;     ///< the wait states of a line, and one read in flight before it, which cannot be taken back
  Cycles fetched_sram = 2;  ///< the fetch of the code goes to the same memory
  Cycles sram = 1;          ///< arbitration of the matrix
  Cycles ahb = 2;           ///< arbitration and transfer
  Cycles apb2 = 8;          ///< 84 MHz: alignment, bridge and two of its cycles
  Cycles apb1 = 14;         ///< 42 MHz: the same
  Cycles own = 2;           ///< of the core's own bus no figure is documented: assumed
  Cycles bit_band_sram = 2 * (1 + 1), bit_band_apb = 2 * (14 + 1);  ///< read, changed and written
};

/// Longest wait of one access beyond what the instruction takes, wherever in `address` it goes; a store waits for its
/// write here, not where the next access meets it. DMA is not in it: it is a stream of its own
/// (tasks/robot_buses.cpp). An address of which nothing is known is one of a variable or a constant: no variable holds
/// the address of a peripheral nor, where the code runs in SRAM and the constants lie there, too, of flash. None of
/// what is outside of the chip: how long it takes depends on its memory controller.
std::optional<Cycles> longest_wait(Interval address, Placement placement, const MemoryWaits& waits);

/// Where in `address` an access need not be aligned: not in a peripheral, which is Device memory, of which that would
/// be unpredictable (ARMv7-M Architecture Reference Manual A3.2.1, B3.1).
std::optional<Interval> where_unaligned(Interval address);

}  // namespace finemote::gen::wcet
