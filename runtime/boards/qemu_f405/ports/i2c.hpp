// An I2C bus that nobody answers on, with a real interrupt that software pends.
#pragma once

#include "finemote/i2c.hpp"
#include "runtime/chips/cortex_m4/core.hpp"
#include "runtime/chips/cortex_m4/registers.hpp"

namespace finemote {

struct I2cHardware {
  unsigned line;
  I2cBus* bus = nullptr;
  bool exchange = false;

  void pend() const { cortex_m4::nvic::set_pending(line / 32) = cortex_m4::bit(line % 32); }
  void on_line() {
    const bool ended = exchange;
    exchange = false;
    if (bus != nullptr) bus->on_interrupt(ended ? I2cEvent::kNack : I2cEvent::kNone);
  }
};

}  // namespace finemote
