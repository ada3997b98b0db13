// What is known of the processor fault that ended the last run; survives the reset that follows it.
#pragma once

#include <cstdint>

#include "finemote/fault.hpp"

namespace finemote::cortex_m4 {

struct LastFault {
  std::uint32_t magic;  ///< kFaultMagic when the rest is meant
  CoreFault fault;
  std::uint32_t exception;  ///< its number: 2 NMI, 3 hard fault, 4 memory, 5 bus, 6 usage, 16 + line
  std::uint32_t pc;         ///< of the interrupted code; 0 when the stack frame is not to be trusted
  std::uint32_t lr;
  std::uint32_t status;   ///< CFSR, PM0214 4.4.10
  std::uint32_t address;  ///< MMFAR or BFAR where `status` says it is valid
};
inline constexpr std::uint32_t kFaultMagic = 0x46415553;

/// Read by a debugger after a fault; not zeroed at start.
extern LastFault last_fault;

/// Lets faults be told apart, and puts the guard under the stack.
void start_guards();

/// Regions 0 to 6 of the memory protection unit: code may be read and run, and nothing else may be run. Defined by a
/// chip that runs code in SRAM.
void protect_code();

/// The fault that caused this start, cleared by asking; false when the start was an ordinary one.
bool restarted_by_fault(CoreFault& fault);

}  // namespace finemote::cortex_m4
