// A CAN bus without other nodes, with a real interrupt that software pends.
#pragma once

#include "finemote/can.hpp"
#include "runtime/chips/cortex_m4/core.hpp"
#include "runtime/chips/cortex_m4/registers.hpp"

namespace finemote {

struct CanHardware {
  unsigned line;
  CanBus* bus = nullptr;

  void pend() const { cortex_m4::nvic::set_pending(line / 32) = cortex_m4::bit(line % 32); }
  void on_line() const {
    if (bus != nullptr) bus->on_interrupt();
  }
};

}  // namespace finemote
