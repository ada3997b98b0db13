// What goes over a bus to the time it takes there and the service routines it runs.
#pragma once

#include "generator/bus/bus_kind.hpp"
#include "generator/timing/integer.hpp"

namespace finemote::gen::timing {

struct WireRate {
  BusKind kind = {};
  Ns bits_per_s = 1;
  Ns bits_per_byte = 10;  ///< of a serial line: start, data, parity and stop bits
};

/// Time on the wire and service routines of what goes over a bus together, one unit after the other.
struct WireUse {
  Ns wire_ns = 0;
  Ns interrupts = 0;
  Ns min_interval_ns = 0;

  /// Throws Overflow.
  void add(const WireRate& rate, Ns write, Ns read);
};

}  // namespace finemote::gen::timing
