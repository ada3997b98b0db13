// What goes over a bus to the time it takes there and the service routines it runs.
#pragma once

#include "generator/bus/bus_type.hpp"
#include "generator/units/duration.hpp"

namespace finemote::gen::timing {

struct WireRate {
  BusKind kind = {};
  std::int64_t bits_per_s = 1;
  Mover mover = Mover::routine;
  std::int64_t bits_per_byte = 10;  ///< of a serial line: start, data, parity and stop bits
};

/// Time on the wire and service routines of what goes over a bus together, one unit after the other.
struct WireUse {
  Duration wire;
  std::int64_t steps = 0;       ///< interrupts in the midst of it
  std::int64_t ends = 0;        ///< exchanges or frames
  std::int64_t answers = 0;     ///< frames that come because they were asked for
  std::int64_t interrupts = 0;  ///< that the wire waits for, the one that begins it on an idle bus included
  /// One interrupt asks for all of it, also on a bus on which parts send by themselves.
  bool in_one_request = false;
  Duration min_interval;

  /// What a device asks for. Throws Overflow.
  void add(const WireRate& rate, std::int64_t write, std::int64_t read) { add(rate, write, read, true); }
  /// What a part sends by itself. Throws Overflow.
  void add_sent(const WireRate& rate, std::int64_t bytes) { add(rate, 0, bytes, false); }
  /// What a part answers to a frame that is counted elsewhere. Throws Overflow.
  void add_reply(const WireRate& rate, std::int64_t bytes);

 private:
  void add(const WireRate& rate, std::int64_t write, std::int64_t read, bool is_asked_for);
};

}  // namespace finemote::gen::timing
