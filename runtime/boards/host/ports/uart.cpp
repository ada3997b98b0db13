// UartPort in virtual time: bytes arrive and leave at wire speed.
#include "finemote/uart.hpp"

#include <utility>

#include "finemote/host.hpp"
#include "finemote/host_ports.hpp"

namespace finemote {

struct UartHardware {
  static constexpr std::uint32_t kRing = 1024;
  static constexpr std::size_t kTransmit = 256;
  std::uint8_t ring[kRing]{};
  std::uint8_t out[kTransmit]{};
  std::uint32_t received = 0;
  UartIdle idle;
  Duration frame = 10 * kSecond / 115'200;
  bool transmitting = false;
  std::uint64_t block = 0;  // number of the block being sent or of the last; an aborted one loses its end
  std::function<void(const std::vector<std::uint8_t>&)> sink;

  void take(std::uint8_t byte) { ring[received++ % kRing] = byte; }
};

namespace {

UartHardware hardware[3];

UartHardware& of(const UartPort& port) {
  return hardware[&port == &ports::usart1 ? 0 : &port == &ports::usart3 ? 1 : 2];
}

// Start bit, eight data bits, parity where there is one, stop bits.
int bits_of(UartFormat format) {
  switch (format) {
    case UartFormat::k8N1:
      return 10;
    case UartFormat::k8E1:
    case UartFormat::k8E1Inverted:
      return 11;
    default:
      return 12;
  }
}

}  // namespace

UartPort ports::usart1{hardware[0]};
UartPort ports::usart3{hardware[1]};
UartPort ports::usart6{hardware[2]};

void UartPort::start(std::int64_t baud, UartFormat format) { hardware_->frame = bits_of(format) * kSecond / baud; }
UartRing UartPort::ring() const { return {hardware_->ring, UartHardware::kRing}; }
std::uint32_t UartPort::received() const { return hardware_->received; }
UartIdle UartPort::idle() const { return hardware_->idle; }
UartErrors UartPort::errors() const { return {}; }
bool UartPort::receive_halted() const { return false; }
void UartPort::restart_receive() {}
std::uint8_t* UartPort::transmit_buffer() { return hardware_->out; }
std::size_t UartPort::transmit_capacity() const { return UartHardware::kTransmit; }
bool UartPort::transmitting() const { return hardware_->transmitting; }

void UartPort::transmit(std::size_t size) {
  UartHardware* port = hardware_;
  port->transmitting = true;
  const std::uint64_t number = ++port->block;
  std::vector<std::uint8_t> bytes(port->out, port->out + size);
  host::interrupt_at(now() + static_cast<Duration>(size) * port->frame, [port, number, bytes] {
    if (number != port->block) return;
    port->transmitting = false;
    if (port->sink) port->sink(bytes);
  });
}

void UartPort::abort_transmit() {
  ++hardware_->block;
  hardware_->transmitting = false;
}

namespace host {

void receive(const UartPort& port, Time at, std::vector<std::uint8_t> bytes) {
  UartHardware* line = &of(port);
  for (const std::uint8_t byte : bytes) {
    at += line->frame;
    interrupt_at(at, [line, byte] { line->take(byte); });
  }
  at += line->frame;
  interrupt_at(at, [line, at] { line->idle = {line->received, at}; });
}

void on_sent(const UartPort& port, std::function<void(const std::vector<std::uint8_t>&)> sink) {
  of(port).sink = std::move(sink);
}

}  // namespace host
}  // namespace finemote
