// A robot whose two buckets are functions of the test: devices and buses run in virtual time.
#pragma once

#include <functional>

#include "finemote/host.hpp"
#include "finemote/time.hpp"
#include "runtime/boards/host/ports/can_wire.hpp"
#include "runtime/boards/host/ports/i2c_wire.hpp"
#include "runtime/boards/host/ports/pins.hpp"
#include "runtime/boards/host/ports/spi_wire.hpp"
#include "runtime/boards/host/ports/uart_wire.hpp"

namespace bench {

/// What the schedule of tests/devices/schedule.cpp calls. Empty functions do nothing.
struct Robot {
  std::function<void()> start, safe;
  std::function<void()> fast;  ///< every 5 ms
  std::function<void()> slow;  ///< every 10 ms
};

Robot& robot();

/// Time 0, wires without parts, no functions.
void reset();

/// Runs the robot for so long.
inline bool run(finemote::Duration duration) { return finemote::host::run(duration); }

/// Calls `routine` at this time, before the buckets of the same instant.
inline void at(finemote::Time when, std::function<void()> routine) {
  finemote::host::interrupt_at(when, std::move(routine));
}

}  // namespace bench
