#include "generator/timing/staircase.hpp"

#include <algorithm>

#include "generator/units/divider.hpp"

namespace finemote::gen::timing {
namespace {

using Step = Staircase::Step;

constexpr Duration kLongAgo = Duration::min();

/// Room for as many steps as there can be, after one that is none.
std::vector<Step> room_for(std::int64_t steps) {
  std::vector<Step> room(static_cast<std::size_t>(steps) + 2);
  room.front() = {0, kLongAgo};
  return room;
}

}  // namespace

std::int64_t steps_in(const Staircase& above, Duration length) {
  return static_cast<std::int64_t>(above.steps.size()) * floor_div(length, above.length);
}

// Whether a step goes on or a new one begins is unpredictable: these loops do not branch on it.

Staircase step_down(const Staircase& above, Duration length, Duration period, LagCursor lag) {
  std::vector<Step> room = room_for(steps_in(above, length));
  Step* last = room.data();
  const Divider by_period(period.ns());
  std::int64_t root_shift = 0;
  for (Duration shift; shift < length; shift += above.length, root_shift += above.root_releases) {
    for (const Step& step : above.steps) {
      const Duration decided = step.device + shift;
      const Duration seen = -by_period.floor(-(decided + lag.at(decided)).ns()) * period;
      last[1] = {step.root + root_shift, seen};  // and forgotten where the step before has led there already
      last += seen > last->device ? 1 : 0;
    }
  }
  const Step* first = room.data() + 1;
  // The first step may only go on with the last one of the repetition before.
  if (first->device == last->device - length) ++first;
  return {length, root_shift, std::vector<Step>(first, static_cast<const Step*>(last) + 1)};
}

Staircase step_up(const Staircase& above, Duration length, Duration period, LagCursor lag) {
  std::vector<Step> room = room_for(steps_in(above, length));
  Step* last = room.data();
  const Divider by_period(period.ns());
  std::int64_t root_shift = 0;
  for (Duration shift; shift < length; shift += above.length, root_shift += above.root_releases) {
    for (const Step& step : above.steps) {
      const Duration use = step.device + shift;
      const Duration release = by_period.floor(use.ns()) * period;
      const Duration source = release + lag.at(release) > use ? release - period : release;  // not there yet
      last += source != last->device ? 1 : 0;
      *last = {step.root + root_shift, source};
    }
  }
  const Step* first = room.data() + 1;
  // The last step may go on into the next repetition, where it is the first one.
  if (last->device == first->device + length) --last;
  return {length, root_shift, std::vector<Step>(first, static_cast<const Step*>(last) + 1)};
}

std::vector<TerminalUse> join(const Staircase& down, const Staircase& up, Duration length) {
  const std::size_t down_size = down.steps.size();
  const auto repetitions = static_cast<std::size_t>(floor_div(length, down.length));
  std::vector<TerminalUse> uses(down_size * repetitions + 1);
  TerminalUse* use = uses.data();
  Duration up_shift;
  std::int64_t up_root_shift = 0, root_shift = 0;
  const Staircase::Step* source = up.steps.data();
  const Staircase::Step* const up_end = source + up.steps.size();
  for (Duration shift; shift < length; shift += down.length, root_shift += down.root_releases) {
    const Staircase::Step* step = down.steps.data();
    const Staircase::Step* const end = step + down_size;
    while (step != end) {
      // Either this use has found its source, or the source is too old: one of both goes on, without a branch.
      *use = {step->device + shift, source->device + up_shift};
      const bool is_too_old = source->root + up_root_shift < step->root + root_shift;
      source += is_too_old ? 1 : 0;
      step += is_too_old ? 0 : 1;
      use += is_too_old ? 0 : 1;
      if (source == up_end) {
        source = up.steps.data();
        up_shift += up.length;
        up_root_shift += up.root_releases;
      }
    }
  }
  uses.pop_back();
  return uses;
}

Duration oldest_age(const std::vector<TerminalUse>& uses) {
  Duration oldest = Duration::min();
  for (const TerminalUse& use : uses) oldest = std::max(oldest, use.next - use.source);
  return oldest;
}

}  // namespace finemote::gen::timing
