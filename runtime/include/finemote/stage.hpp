// Brackets one stage for trace and monitor: nothing at all unless built with FINEMOTE_TRACE or FINEMOTE_MONITOR.
#pragma once

#include <cstdint>

#include "finemote/trace.hpp"
#ifdef FINEMOTE_MONITOR
#include "finemote/monitor.hpp"
#endif

namespace finemote {

/// Lives as long as the stage runs. Number: 2 * device index in schedule order + (0 update, 1 handle).
class Stage {
 public:
#if defined(FINEMOTE_TRACE) || defined(FINEMOTE_MONITOR)
  explicit Stage(std::uint16_t number) : number_(number) {
#ifdef FINEMOTE_TRACE
    trace(2U * number_);
#endif
  }
  ~Stage() {
#ifdef FINEMOTE_TRACE
    trace(2U * number_ + 1U);
#endif
#ifdef FINEMOTE_MONITOR
    if (number_ % 2U != 0) monitor_handle(number_ / 2U);
#endif
  }
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

 private:
  std::uint32_t number_;
#else
  constexpr explicit Stage(std::uint16_t) {}
  ~Stage() {}  // user-provided, so that a stage's bracket is no unused variable
#endif
};

}  // namespace finemote
