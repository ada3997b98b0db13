#include "finemote/devices/battery.hpp"

#include "finemote/control/numbers.hpp"

namespace finemote {

void BatterySense::update() {
  const Time at = now();
  float voltage = 0;
  const bool ready = input_.sample(voltage);
  const bool plausible = ready && voltage >= kLeast && voltage < input_.full_scale();
  if (plausible && running_) take(voltage, begun_);
  if (ready && !plausible) state.valid = false;
  if (ready || !running_) begun_ = at;
  running_ = true;
  if (!is_fresh(state, at, kMaxAge)) state.valid = false;
}

void BatterySense::take(float voltage, Time at) {
  if (!state.valid) {
    state.voltage = voltage;  // the first one, or the first after a gap
  } else {
    const float dt = seconds(at - taken_), smooth = seconds(config_.smooth);
    const float sum = smooth + dt;
    state.voltage += (sum > 0 ? dt / sum : 1) * (voltage - state.voltage);
  }
  taken_ = at;
  state.origin = at;
  state.valid = true;
  state.low = low_.judge(state.voltage, config_.low, at, config_.hold);
  state.empty = empty_.judge(state.voltage, config_.empty, at, config_.hold);
}

bool BatterySense::Limit::judge(float voltage, float limit, Time at, Duration hold) {
  const bool other = below ? voltage > limit + kReturn : voltage < limit;
  if (!other) {
    changed = 0;
  } else if (changed == 0) {
    changed = at;
  }
  if (other && at - changed >= hold) {
    below = !below;
    changed = 0;
  }
  return below;
}

}  // namespace finemote
