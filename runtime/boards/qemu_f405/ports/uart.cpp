// UartPort without a line: nothing arrives, and what is sent has left at once.
#include "runtime/boards/qemu_f405/ports/uart.hpp"

namespace finemote {

void UartPort::start(std::int64_t, UartFormat, UartRing) {}
void UartPort::allow_events(std::uint32_t) {}
void UartPort::drive_with(std::uint8_t, bool) {}
std::uint32_t UartPort::received() const { return 0; }
UartIdle UartPort::idle() const { return {}; }
UartSeen UartPort::seen() const { return {}; }
bool UartPort::tells_silence_after(std::uint32_t) const { return false; }
UartErrors UartPort::errors() const { return {}; }
bool UartPort::receive_halted() const { return false; }
std::uint32_t UartPort::restart_receive() { return 0; }
std::uint8_t* UartPort::transmit_buffer() { return hardware_->out; }
std::size_t UartPort::transmit_capacity() const { return UartHardware::kTransmit; }
bool UartPort::transmitting() const { return false; }
void UartPort::transmit(std::size_t) {}
void UartPort::abort_transmit() {}

}  // namespace finemote
