// Brackets one stage: with marks that cost no instruction, and with the calls of trace and monitor where the firmware
// is built with FINEMOTE_TRACE or FINEMOTE_MONITOR.
#pragma once

#include <cstdint>

#include "finemote/mark.hpp"
#include "finemote/trace.hpp"
#ifdef FINEMOTE_MONITOR
#include "finemote/monitor.hpp"
#endif

namespace finemote {

/// Lives as long as the stage runs. Number: 2 * device index in schedule order + (0 update, 1 handle). Its marks are
/// twice that, and one more at the end.
template <std::uint16_t number>
class Stage {
 public:
  Stage() {
#ifdef FINEMOTE_TRACE
    trace(2U * number);
#endif
    mark<2U * number>();
  }
  ~Stage() {
    mark<2U * number + 1U>();
#ifdef FINEMOTE_TRACE
    trace(2U * number + 1U);
#endif
#ifdef FINEMOTE_MONITOR
    if (number % 2U != 0) monitor_handle(number / 2U);
#endif
  }
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;
};

}  // namespace finemote
