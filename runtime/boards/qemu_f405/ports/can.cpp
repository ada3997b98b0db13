// CanPort without other nodes: what is sent has left at once, nothing arrives. Interrupts are real, pended by software.
#include "runtime/boards/qemu_f405/ports/can.hpp"

namespace finemote {

void CanPort::configure(std::int64_t, CanBus& bus) {
  hardware_->bus = &bus;
  cortex_m4::enable_line(hardware_->line, cortex_m4::kSlowBusPriority);
}
void CanPort::pend() { hardware_->pend(); }
bool CanPort::send(const CanFrame&) { return true; }
void CanPort::tell_when_sent() { pend(); }
unsigned CanPort::unsent() const { return 0; }
bool CanPort::idle(std::int64_t) const { return true; }
void CanPort::abort() {}
bool CanPort::bus_off() const { return false; }
bool CanPort::recover() { return true; }
std::uint16_t CanPort::error_counters() const { return 0; }

}  // namespace finemote
