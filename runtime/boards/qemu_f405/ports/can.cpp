// CanPort without other nodes: what is sent has left at once, nothing arrives. Interrupts are real, pended by software.
#include "finemote/can.hpp"

#include "runtime/boards/cortex_m4/core.hpp"
#include "runtime/boards/cortex_m4/registers.hpp"

namespace finemote {

struct CanHardware {
  unsigned line;
  CanBus* bus = nullptr;

  void pend() const { cortex_m4::nvic::set_pending(line / 32) = cortex_m4::bit(line % 32); }
  void on_line() const {
    if (bus != nullptr) bus->on_interrupt();
  }
};

namespace {

CanHardware can1{20};
CanHardware can2{64};

}  // namespace

CanPort ports::can1{finemote::can1};
CanPort ports::can2{finemote::can2};

void CanPort::configure(std::int64_t, CanBus& bus, const std::uint16_t*, std::size_t) {
  hardware_->bus = &bus;
  cortex_m4::enable_line(hardware_->line, cortex_m4::kSlowBusPriority);
}
void CanPort::pend() { hardware_->pend(); }
bool CanPort::send(const CanFrame&) { return true; }
void CanPort::abort() {}
bool CanPort::bus_off() const { return false; }
void CanPort::recover() {}
std::uint16_t CanPort::error_counters() const { return 0; }

}  // namespace finemote

extern "C" void finemote_line_20() { finemote::can1.on_line(); }
extern "C" void finemote_line_64() { finemote::can2.on_line(); }
