// The bench on which a device is tested on the computer: virtual time, the wires of every port, and a robot whose two
// buckets are functions of the test.
//
// Parts hang on the wires: models of real ones (finemote/bench/parts.hpp), or a test's own. The wires record what
// happens on them, bytes take their time, and faults can be scripted. `finemote::host::usart1`, `i2c2`, `can1`, `pwm1`
// and so on are the wires of the ports of the same names; each structure says in its header what a test can do with it.
// A test program (finemote_add_device_test) uses one bench, one test after the other, and calls reset() before each.
#pragma once

#include <functional>
#include <utility>

#include "finemote/host.hpp"
#include "finemote/time.hpp"
#include "runtime/boards/host/ports/can_wire.hpp"
#include "runtime/boards/host/ports/i2c_wire.hpp"
#include "runtime/boards/host/ports/pins.hpp"
#include "runtime/boards/host/ports/spi_wire.hpp"
#include "runtime/boards/host/ports/uart_wire.hpp"

namespace finemote::bench {

/// What the schedule of the bench calls. Empty functions do nothing.
struct Robot {
  std::function<void()> start;  ///< before the first release: starts the buses
  std::function<void()> safe;   ///< once it has stopped: the safe outputs
  std::function<void()> fast;   ///< every 5 ms
  std::function<void()> slow;   ///< every 10 ms
};

/// The robot of the bench: a test sets its functions.
Robot& robot();

/// Time 0, wires without parts, no functions.
void reset();

/// Runs the robot for so long. False: it stopped itself, host::stop_text() says why.
inline bool run(Duration duration) { return host::run(duration); }

/// Calls `routine` at this time, before the buckets of the same instant.
inline void at(Time when, std::function<void()> routine) { host::interrupt_at(when, std::move(routine)); }

}  // namespace finemote::bench
