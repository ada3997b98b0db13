#include "generator/timing/wire_use.hpp"

#include "generator/bus/bus_type.hpp"

namespace finemote::gen::timing {

void WireUse::add(const WireRate& rate, Ns write, Ns read) {
  const BusType& type = bus_type(rate.kind);
  if (type.unit == nullptr) return;
  const WireUnit unit = type.unit(write, read, rate.bits_per_byte);
  wire_ns = gen::add(wire_ns, ceil_div(multiply(unit.bits, 1'000'000'000), rate.bits_per_s));
  interrupts += unit.interrupts;
}

}  // namespace finemote::gen::timing
