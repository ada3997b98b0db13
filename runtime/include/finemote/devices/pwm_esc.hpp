// Turns an effort into the pulse width of a bidirectional speed controller, and old data into neutral.
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"
#include "finemote/interfaces/thruster.hpp"
#include "finemote/pwm.hpp"

namespace finemote {

/// Drives while its command is valid, in range and made from data not older than `max_age`; otherwise neutral. It looks
/// at the age of the data, not of the call: a parent that goes on commanding from a silent sensor does not keep it
/// going.
class PwmEsc {
 public:
  struct Config {
    Duration neutral = 1500 * kMicrosecond;  ///< pulse at which it stands still
    Duration min = 1100 * kMicrosecond;      ///< pulse for effort -1
    Duration max = 1900 * kMicrosecond;      ///< pulse for effort +1
    bool reverse = false;                    ///< effort and pulse have opposite signs
    Duration max_age = 100 * kMillisecond;   ///< of the command's origin
    Duration dead_zone = 0;                  ///< pulse around neutral the controller ignores
  };

  constexpr PwmEsc(const Config& config, PwmChannel channel)
      : max_age_(config.max_age),
        channel_(channel),
        neutral_(static_cast<std::int32_t>(config.neutral)),
        min_(static_cast<std::int32_t>(config.min)),
        max_(static_cast<std::int32_t>(config.max)),
        dead_zone_(static_cast<std::int32_t>(config.dead_zone)),
        reverse_(config.reverse) {}

  void update();
  void handle();
  /// Neutral at the next flush, and from now on what the output part is sent first after a start or a recovery of its
  /// bus. May interrupt update() and handle().
  void safe();

  ThrusterState state;
  ThrusterCommand command;

  /// Pulse width [ns] for an effort in -1..1.
  [[nodiscard]] std::uint32_t pulse(float effort) const;

 private:
  const Duration max_age_;
  PwmChannel channel_;
  const std::int32_t neutral_, min_, max_, dead_zone_;  ///< ns
  const bool reverse_;
  float driven_ = 0;
};

}  // namespace finemote
