#include "emulator/outfit/element.hpp"

#include "emulator/outfit/outfit.hpp"

namespace finemote::emulator {

Time Element::now() const { return outfit_.now(); }

PartClock Element::part_clock() const {
  Outfit& outfit = outfit_;
  return {[&outfit] { return outfit.now(); },
          [&outfit](Time at, EventQueue::Action action) { outfit.board().world().at(at, std::move(action)); }};
}

Tag Element::record_sample(Time from, Time until) {
  const Tag sample = outfit_.sample(name_, 0, from, until);
  const std::uint32_t n = outfit_.board().world().provenance().origin(sample).n;
  outfit_.record(PartEvent{name_, PartEvent::Kind::sample, 0, from, until, 0, {}, n});
  return sample;
}

Tag Element::begin_sample(unsigned channel, Time from) { return outfit_.sample(name_, channel, from, from); }

void Element::end_sample(unsigned channel, Tag sample) {
  const Origin& origin = outfit_.board().world().provenance().origin(sample);
  outfit_.record(PartEvent{name_, PartEvent::Kind::sample, channel, origin.from, now(), 0, {}, origin.n});
}

void Element::record_output(unsigned channel, double value, Tag origin) {
  PartEvent event{name_, PartEvent::Kind::output, channel, now(), now(), value};
  if (const Origin* job = outfit_.board().world().provenance().job(origin)) {
    event.stage = job->source;
    event.n = job->n;
  }
  outfit_.record(event);
}

}  // namespace finemote::emulator
