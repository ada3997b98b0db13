#include "emulator/outfit/element.hpp"

#include "emulator/outfit.hpp"

namespace finemote::emulator {

Time Element::now() const { return outfit_.now(); }

void Element::record_sample(Time from, Time until) {
  outfit_.record(PartEvent{name_, PartEvent::Kind::sample, 0, to_ns(from), to_ns(until), 0});
}

void Element::record_sample(Time from) {
  outfit_.record(PartEvent{name_, PartEvent::Kind::sample, 0, to_ns(from), outfit_.board().now_ns(), 0});
}

void Element::record_output(unsigned channel, double value) {
  const std::uint64_t now_ns = outfit_.board().now_ns();
  outfit_.record(PartEvent{name_, PartEvent::Kind::output, channel, now_ns, now_ns, value});
}

}  // namespace finemote::emulator
