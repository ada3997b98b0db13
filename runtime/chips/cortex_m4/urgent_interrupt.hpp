// When the event happened that an interrupt serves. Interrupts wait for each other, so their routines run later.
#pragma once

#include <cstdint>

#include "finemote/ports.hpp"

namespace finemote::cortex_m4 {

/// Lives as long as the routine of an interrupt of priority kBusPriority runs; every routine of that priority has one.
/// Nothing but each other keeps them waiting for long. Those that follow each other without a pause may all have waited
/// since the first of them began: that is when their events happened at the earliest.
class UrgentInterrupt {
 public:
  UrgentInterrupt();
  ~UrgentInterrupt();
  UrgentInterrupt(const UrgentInterrupt&) = delete;
  UrgentInterrupt& operator=(const UrgentInterrupt&) = delete;

  /// When the event happened that the routine serves.
  [[nodiscard]] Moment event() const;

 private:
  std::uint32_t begun_;  ///< cycles: the routine, or the first of those it followed
};

}  // namespace finemote::cortex_m4
