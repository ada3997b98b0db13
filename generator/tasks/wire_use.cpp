#include "generator/tasks/wire_use.hpp"

#include "generator/bus/bus_type.hpp"

namespace finemote::gen::timing {

void WireUse::add(const WireRate& rate, std::int64_t write, std::int64_t read, bool is_asked_for) {
  const BusType& type = bus_type(rate.kind);
  if (type.unit == nullptr) return;
  const WireUnit unit = type.unit({write, read, rate.bits_per_byte, rate.mover, is_asked_for});
  wire += ceil_div(unit.bits * seconds(1), rate.bits_per_s);
  steps = gen::add(steps, unit.steps);
  ends = gen::add(ends, unit.ends);
  answers = gen::add(answers, unit.answers);
  if (type.is_mastered && interrupts == 0) ++interrupts;
  interrupts = gen::add(interrupts, gen::add(unit.steps, unit.ends));
}

void WireUse::add_reply(const WireRate& rate, std::int64_t bytes) {
  WireUse reply;
  reply.add_sent(rate, bytes);
  wire += reply.wire;
  answers = gen::add(answers, reply.ends);
}

}  // namespace finemote::gen::timing
