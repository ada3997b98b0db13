// The I2C master of the four baselines: a call returns when its transfer has ended.
//
// Two drivers implement it: polled_i2c.cpp looks at the flags until they are there, waiting_i2c.cpp lets other tasks
// run meanwhile. A firmware is linked with one of them.
#pragma once

#include <cstddef>
#include <cstdint>

#include "finemote/time.hpp"

namespace baseline {

/// What a firmware does when the bus does not answer. Defined by the firmware.
struct I2cPolicy {
  finemote::Duration bus_free;  ///< longest wait for a bus that somebody else holds
  finemote::Duration step;      ///< longest wait for any other flag; of waiting_i2c.cpp: for a whole transfer
  bool recovers;                ///< a bus that was not free is clocked free: nine clocks and a STOP, UM10204 3.1.16
};
extern const I2cPolicy i2c_policy;

/// Port i2c2 at 400 kHz. Context: start.
void start_i2c();

/// One transaction: START, address, `size` bytes, STOP. @return  whether all of it was acknowledged
bool write_i2c(std::uint8_t address, const std::uint8_t* bytes, std::size_t size);
/// One transaction. @param size  2 or 3
bool read_i2c(std::uint8_t address, std::uint8_t* bytes, std::size_t size);

/// Waits without the schedule's time, which does not count yet. Context: start.
void wait_at_start(finemote::Duration time);

}  // namespace baseline
