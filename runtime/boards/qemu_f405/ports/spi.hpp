// An SPI bus without chips, with a real interrupt that software pends.
#pragma once

#include "finemote/spi.hpp"
#include "runtime/chips/cortex_m4/core.hpp"
#include "runtime/chips/cortex_m4/registers.hpp"

namespace finemote {

struct SpiHardware {
  unsigned line;
  SpiBus* bus = nullptr;
  bool exchange = false;

  void pend() const { cortex_m4::nvic::set_pending(line / 32) = cortex_m4::bit(line % 32); }
  void on_line() {
    const bool ended = exchange;
    exchange = false;
    if (bus != nullptr) bus->on_interrupt(ended ? SpiEvent::kDone : SpiEvent::kNone);
  }
};

}  // namespace finemote
