// What has become of a transfer that a device asked for, whichever bus carries it.
#pragma once

#include <cstdint>

namespace finemote {

/// State of a slot's last transfer.
enum class SlotState : std::uint8_t {
  kIdle,    ///< nothing asked yet
  kQueued,  ///< waiting for the bus
  kActive,  ///< on the wire, mux selection included
  kDone,    ///< ended well; read bytes are valid
  kNack,    ///< the other side did not answer; on I2C that may be a mux
  kFailed,  ///< bus error, overdue, or refused because the bus is being recovered
};

/// A transfer waits for the bus or is on the wire. Context: any.
constexpr bool is_under_way(SlotState state) { return state == SlotState::kQueued || state == SlotState::kActive; }

/// After so many failures in a row nobody answers there.
inline constexpr std::uint8_t kUnreachableAfter = 3;

/// Failures in a row once another transfer has ended: 255 stands for all that are more. Context: any.
constexpr std::uint8_t failures_after(std::uint8_t before, bool failed) {
  if (!failed) return 0;
  return static_cast<std::uint8_t>(before == 255 ? 255 : before + 1);
}

}  // namespace finemote
