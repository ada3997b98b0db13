// The pulse outputs and single pins of the host board, as a recorder sees them.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "board/wires.hpp"
#include "finemote/ports.hpp"

namespace finemote {

/// A pulse output, and the hardware behind PwmPort.
struct PwmHardware {
  /// A pulse the robot set.
  struct Write {
    Time at;              ///< when it was set
    std::uint32_t pulse;  ///< ns
  };
  Duration period = 0;        ///< ns; 0: not started
  bool alone = true;          ///< on its timer: tune() works
  std::vector<Write> writes;  ///< in order
};

/// The single pins by pin_number(), and the hardware behind GpioPort.
struct GpioHardware {
  std::map<std::uint8_t, bool> levels;          ///< outputs as written, inputs as the test set them; absent: low
  std::map<std::uint8_t, PinSetting> settings;  ///< as configured
};

/// A pin with an interrupt, and the hardware behind EdgePort.
struct EdgeHardware {
  /// An edge now, as its interrupt would note it.
  void edge() { last = {last.count + 1, now()}; }

  // ---- for the port
  bool started = false, falling = false;
  Edge last;
};

/// A converter, and the hardware behind AdcPort.
struct AdcHardware {
  static constexpr Duration kConversion = 24 * kMicrosecond;  ///< how long one takes
  std::map<std::uint8_t, std::uint16_t> codes;                ///< what each input measures, as the test set it
  bool broken = false;                                        ///< no conversion ends any more

  // ---- for the port
  int started = -1;  ///< input
  bool converting = false;
  std::uint8_t input = 0;
  std::uint16_t value = 0;
  Time ready_at = 0;
};

}  // namespace finemote
