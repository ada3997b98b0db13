#include "finemote/pwm.hpp"

namespace finemote {

void PwmOutput::set(std::uint8_t channel, std::uint32_t pulse) {
  if (channel >= count_) return;
  if (channels_[channel].pulse.exchange(pulse) != pulse) changed_.set_bits(std::uint32_t{1} << channel);
}

void PwmOutput::set_safe(std::uint8_t channel, std::uint32_t pulse) {
  if (channel >= count_) return;
  const std::uint32_t bit = std::uint32_t{1} << channel;
  const bool other = channels_[channel].safe.exchange(pulse) != pulse;
  if ((safe_known_.set_bits(bit) & bit) == 0 || other) safe_changed_.store(true);
}

void PwmBus::start() { port_->start(period_); }

void PwmBus::flush() {
  if (changed_.exchange(0) != 0) port_->write(channel_.pulse.load());
}

}  // namespace finemote
