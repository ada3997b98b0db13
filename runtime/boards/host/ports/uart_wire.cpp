#include "runtime/boards/host/ports/uart_wire.hpp"

#include <algorithm>

#include "finemote/host.hpp"
#include "runtime/boards/host/ports/pins.hpp"

namespace finemote {

namespace {

int bits_per_byte(UartFormat format) {
  if (format == UartFormat::k8N1) return 10;
  return format == UartFormat::k8E1 || format == UartFormat::k8E1Inverted ? 11 : 12;
}

}  // namespace

// ---------------------------------------------------------------------------------------------------------------- wire

void UartHardware::feed(Time at, const std::vector<std::uint8_t>& bytes) {
  Time begin = std::max(at, line_free);
  for (const std::uint8_t value : bytes) {
    begin += byte_time;
    coming.push_back({begin, value});
  }
  line_free = begin;
}

void UartHardware::feed(Time at, const std::string& text) {
  feed(at, std::vector<std::uint8_t>(text.begin(), text.end()));
}

void UartHardware::halt_reception() {
  catch_up();
  halted = true;
}

void UartHardware::reset() {
  coming.clear();
  sent.clear();
  errors = {};
  halted = blocked = sending = false;
  last = line_free = sending_until = 0;
  driver = -1;
  received = 0;
  idle = {};
}

void UartHardware::catch_up() {
  while (!coming.empty() && coming.front().at <= now()) {
    const Byte byte = coming.front();
    coming.pop_front();
    const Time begin = byte.at - byte_time;
    if (received != idle.received && begin > last + byte_time) idle = {received, last + byte_time};
    last = byte.at;
    if (halted || ring.size == 0) continue;
    ring.bytes[received % ring.size] = byte.value;
    ++received;
  }
  if (received != idle.received && now() >= last + byte_time && !halted) idle = {received, last + byte_time};
}

// ---------------------------------------------------------------------------------------------------------------- port

void UartPort::start(std::int64_t baud, UartFormat format, UartRing ring) {
  hardware_->ring = ring;
  hardware_->byte_time = bits_per_byte(format) * kSecond / baud;
}

void UartPort::allow_events(std::uint32_t) {}

void UartPort::drive_with(std::uint8_t pin, bool active_low) {
  hardware_->driver = pin;
  hardware_->driver_low = active_low;
}

std::uint32_t UartPort::received() const {
  hardware_->catch_up();
  return hardware_->received;
}

UartIdle UartPort::idle() const {
  hardware_->catch_up();
  return hardware_->idle;
}

UartSeen UartPort::seen() const { return {received(), idle()}; }

bool UartPort::tells_silence_after(std::uint32_t) const { return !hardware_->halted; }

UartErrors UartPort::errors() const { return hardware_->errors; }

bool UartPort::receive_halted() const { return hardware_->halted; }

std::uint32_t UartPort::restart_receive() {
  UartHardware& line = *hardware_;
  line.catch_up();
  line.halted = false;
  line.received = (line.received + line.ring.size - 1) / line.ring.size * line.ring.size;
  line.idle = {line.received, kLongAgo};
  return line.received;
}

std::uint8_t* UartPort::transmit_buffer() { return hardware_->buffer; }
std::size_t UartPort::transmit_capacity() const { return UartHardware::kBuffer; }

bool UartPort::transmitting() const { return hardware_->sending && now() < hardware_->sending_until; }

void UartPort::transmit(std::size_t size) {
  UartHardware& line = *hardware_;
  const auto wire_time = static_cast<Duration>(size) * line.byte_time;
  line.sending = true;
  line.sending_until = line.blocked ? INT64_MAX : now() + wire_time;
  if (line.driver >= 0) {
    const auto pin = static_cast<std::uint8_t>(line.driver);
    host::gpio.levels[pin] = !line.driver_low;
    if (!line.blocked) {
      host::interrupt_at(line.sending_until, [&line, pin] { host::gpio.levels[pin] = line.driver_low; });
    }
  }
  if (!line.blocked) line.sent.push_back({now(), now() + wire_time, {line.buffer, line.buffer + size}});
}

void UartPort::abort_transmit() {
  hardware_->sending = false;
  if (hardware_->driver >= 0) host::gpio.levels[static_cast<std::uint8_t>(hardware_->driver)] = hardware_->driver_low;
}

}  // namespace finemote
