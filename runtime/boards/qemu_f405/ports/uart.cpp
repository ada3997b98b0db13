// UartPort without a line: nothing arrives, and what is sent has left at once.
#include "finemote/uart.hpp"

namespace finemote {

struct UartHardware {
  static constexpr std::uint32_t kRing = 64;
  static constexpr std::size_t kTransmit = 64;
  std::uint8_t ring[kRing]{};
  std::uint8_t out[kTransmit]{};
};

namespace {

UartHardware hardware[3];

}  // namespace

UartPort ports::usart1{hardware[0]};
UartPort ports::usart3{hardware[1]};
UartPort ports::usart6{hardware[2]};

void UartPort::start(std::int64_t, UartFormat) {}
void UartPort::drive_with(std::uint8_t, bool) {}
UartRing UartPort::ring() const { return {hardware_->ring, UartHardware::kRing}; }
std::uint32_t UartPort::received() const { return 0; }
UartIdle UartPort::idle() const { return {}; }
UartErrors UartPort::errors() const { return {}; }
bool UartPort::receive_halted() const { return false; }
void UartPort::restart_receive() {}
std::uint8_t* UartPort::transmit_buffer() { return hardware_->out; }
std::size_t UartPort::transmit_capacity() const { return UartHardware::kTransmit; }
bool UartPort::transmitting() const { return false; }
void UartPort::transmit(std::size_t) {}
void UartPort::abort_transmit() {}

}  // namespace finemote
