// Brackets one stage: with marks that cost no instruction, and with the calls of trace and monitor where the firmware
// is built with FINEMOTE_TRACE or FINEMOTE_MONITOR.
#pragma once

#include <cstdint>

#include "finemote/trace.hpp"
#ifdef FINEMOTE_MONITOR
#include "finemote/monitor.hpp"
#endif

namespace finemote {

/// Records the address of this place and `number` in section `.debug_finemote`, which tools read and which is not part
/// of the image that is flashed. No access to memory is moved across it. On a computer it does nothing.
template <std::uint32_t number>
[[gnu::always_inline]] inline void mark() {
#ifdef __arm__
  asm volatile("0: .pushsection .debug_finemote,\"\",%%progbits\n\t.word 0b, %c0\n\t.popsection" ::"i"(number)
               : "memory");
#endif
}

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
