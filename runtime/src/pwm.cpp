#include "finemote/pwm.hpp"

#include "finemote/fault.hpp"
#include "finemote/mark.hpp"
#include "start.hpp"

namespace finemote {

namespace {

/// Of module pwm, beyond those of the board's ports.
enum PwmFault : std::uint8_t { kNotTunable = 16 };

}  // namespace

void PwmOutput::set(std::uint8_t channel, std::uint32_t pulse) {
  if (channel >= count_) return;
  const std::uint32_t bit = std::uint32_t{1} << channel;
  const bool differs = channels_[channel].pulse.exchange(pulse) != pulse;
  if ((asked_.load() & bit) == 0) {
    asked_.set_bits(bit);
  } else if (!differs) {
    return;
  }
  mark_hand_over();
  changed_.set_bits(bit);
}

void PwmOutput::set_safe(std::uint8_t channel, std::uint32_t pulse) {
  if (channel >= count_) return;
  const std::uint32_t bit = std::uint32_t{1} << channel;
  const bool other = channels_[channel].safe.exchange(pulse) != pulse;
  if ((safe_known_.set_bits(bit) & bit) == 0 || other) safe_changed_.store(true);
}

void PwmChannel::set_share(float share) {
  // The comparisons are written so that what is no number is 0. Below 2^31 a conversion needs no library routine.
  const auto period = static_cast<std::int32_t>(output_->period());
  const float pulse = share > 0 ? (share < 1 ? share : 1) * static_cast<float>(period) : 0;
  set(static_cast<std::uint32_t>(static_cast<std::int32_t>(pulse)));
}

void PwmBus::start() { port_->start(period_.load()); }

void PwmBus::flush() {
  const MarkedWork<Work::flush_pwm> marked;
  const bool tuned = tuned_.exchange(false);
  if (tuned && !port_->tune(period_.load())) count_fault(Module::pwm, kNotTunable);
  // A stop may have cut off what had taken the change out and not written it.
  const bool is_certain = changed_.exchange(0) != 0 || tuned || detail::has_stopped();
  if (is_certain) port_->write(channel_.pulse.load());
}

}  // namespace finemote
