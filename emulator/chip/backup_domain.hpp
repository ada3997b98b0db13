// What chooses the clock of the calendar, and outlives a reset: RCC_BDCR, RM0090 7.3.20.
#pragma once

#include <cstdint>
#include <functional>

namespace finemote::emulator {

/// The crystal of 32.768 kHz never gets ready: no board here has one.
class BackupDomain {
 public:
  enum class RtcSource : std::uint8_t { none, low_crystal, low_internal, crystal };

  [[nodiscard]] std::uint32_t read() const { return bdcr_; }
  void write(std::uint32_t value) {
    if (!is_open || !is_open()) return;  // PWR_CR.DBP: RM0090 5.1.2
    if (before_change) before_change();
    if ((value & kReset) != 0 && (bdcr_ & kReset) == 0 && on_reset) on_reset();
    const std::uint32_t chosen = bdcr_ & kSource;
    bdcr_ = (value & kReset) != 0 ? kReset : value & (kOn | kBypass | kSource | kRtcOn);
    if (chosen != 0 && (value & kReset) == 0) bdcr_ = (bdcr_ & ~kSource) | chosen;  // only a reset lets choose again
  }
  /// Of a calendar that runs.
  [[nodiscard]] RtcSource rtc_source() const {
    return (bdcr_ & kRtcOn) != 0 ? static_cast<RtcSource>(bdcr_ >> 8 & 3) : RtcSource::none;
  }

  std::function<bool()> is_open;
  std::function<void()> on_reset, before_change;

 private:
  static constexpr std::uint32_t kOn = 1, kBypass = 4, kSource = 3U << 8, kRtcOn = 1U << 15, kReset = 1U << 16;
  std::uint32_t bdcr_ = 0;
};

}  // namespace finemote::emulator
