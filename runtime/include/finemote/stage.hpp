// Brackets one stage: with marks that cost no instruction, and with the calls of trace and monitor where the firmware
// is built with FINEMOTE_TRACE or FINEMOTE_MONITOR.
#pragma once

#include <cstdint>
#include <type_traits>
#include <utility>

#include "finemote/contract.hpp"
#include "finemote/mark.hpp"
#include "finemote/trace.hpp"
#ifdef FINEMOTE_MONITOR
#include "finemote/monitor.hpp"
#endif

namespace finemote {

/// Lives as long as the stage runs. Its marks are twice its number, and one more at the end.
/// @tparam number   2 * device index in schedule order + (0 update, 1 handle)
/// @tparam updated  of an update: the device, whose stamp tools find by it
template <std::uint16_t number, auto&... updated>
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
    (tell_stamp<updated>(), ...);
#ifdef FINEMOTE_TRACE
    trace(2U * number + 1U);
#endif
#ifdef FINEMOTE_MONITOR
    if (number % 2U != 0) monitor_handle(number / 2U);
#endif
  }
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

 private:
  template <class Device, class = void>
  struct HasStamp : std::false_type {};
  template <class Device>
  struct HasStamp<Device, std::void_t<decltype(static_cast<const Stamp&>(std::declval<Device&>().state))>>
      : std::true_type {};

  /// Records the address of the device's stamp and the number in section `.debug_finemote_stamps`, two words each.
  template <auto& device>
  [[gnu::always_inline]] static void tell_stamp() {
#ifdef __arm__
    if constexpr (HasStamp<std::remove_reference_t<decltype(device)>>::value) {
      asm volatile(".pushsection .debug_finemote_stamps,\"\",%%progbits\n\t.word %c0, %c1\n\t.popsection" ::"i"(
                       static_cast<const Stamp*>(&device.state)),
                   "i"(number));
    }
#endif
  }
};

}  // namespace finemote
