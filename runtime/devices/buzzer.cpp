#include "finemote/devices/buzzer.hpp"

namespace finemote {

void Buzzer::update() {
  state.origin = now();
  state.valid = !channel_.unreachable();
  state.frequency = frequency_;
}

void Buzzer::handle() {
  // The comparisons are written so that what is no number makes no sound.
  const bool tone = command.frequency >= kLowest && command.frequency <= kHighest && command.volume > 0;
  if (!is_fresh(command, now(), config_.max_age) || !tone) return safe();
  if (frequency_ != command.frequency) {
    frequency_ = command.frequency;
    channel_.tune(static_cast<std::uint32_t>(static_cast<std::int32_t>(1e9F / frequency_ + 0.5F)));
  }
  // Half on, half off is the loudest; the ear hears shares about as their square root.
  const float loud = (command.volume < 1 ? command.volume : 1) * config_.volume;
  channel_.set_share(0.5F * loud * loud);
}

void Buzzer::safe() {
  frequency_ = 0;
  channel_.set(0);
}

}  // namespace finemote
