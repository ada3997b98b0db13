// I2cPort in virtual time: an exchange takes its time on the wire, then the attached parts answer.
#include "finemote/i2c.hpp"

#include <utility>

#include "finemote/host.hpp"
#include "finemote/host_ports.hpp"

namespace finemote {

struct I2cHardware {
  I2cBus* bus = nullptr;
  std::int64_t clock_hz = 400'000;
  std::uint64_t exchange = 0;  // number of the exchange under way or of the last; an aborted one loses its end
  bool held = false;
  host::I2cParts parts;

  [[nodiscard]] Duration wire_time(const I2cMessage& message) const {
    std::int64_t bytes = 1 + message.write_size;
    if (message.read_size > 0) bytes += message.read_size + (message.write_size > 0 ? 1 : 0);
    return (bytes * 9 + 2) * kSecond / clock_hz;  // nine bits a byte, and START and STOP
  }

  void end(const I2cMessage& message, std::uint64_t number) {
    if (number != exchange) return;
    switch (parts ? parts(message) : host::I2cAnswer::kNack) {
      case host::I2cAnswer::kDone:
        return bus->on_interrupt(I2cEvent::kDone);
      case host::I2cAnswer::kNack:
        return bus->on_interrupt(I2cEvent::kNack);
      case host::I2cAnswer::kError:
        return bus->on_interrupt(I2cEvent::kError);
      case host::I2cAnswer::kNever:
        return;
    }
  }
};

namespace {

I2cHardware hardware[2];

I2cHardware& of(const I2cPort& port) { return hardware[&port == &ports::i2c3 ? 1 : 0]; }

}  // namespace

I2cPort ports::i2c2{hardware[0]};
I2cPort ports::i2c3{hardware[1]};

void I2cPort::configure(std::int64_t clock_hz, I2cBus& bus) {
  hardware_->bus = &bus;
  hardware_->clock_hz = clock_hz;
}

void I2cPort::pend() {
  I2cBus* bus = hardware_->bus;
  host::interrupt_at(now(), [bus] { bus->on_interrupt(I2cEvent::kNone); });
}

void I2cPort::begin(const I2cMessage& message) {
  I2cHardware* port = hardware_;
  const std::uint64_t number = ++port->exchange;
  host::interrupt_at(now() + port->wire_time(message), [port, message, number] { port->end(message, number); });
}

void I2cPort::abort() { ++hardware_->exchange; }

I2cPort::Recovery I2cPort::recover(unsigned step) {
  if (step + 1 < kMaxRecoverySteps) return Recovery::kBusy;
  return hardware_->held ? Recovery::kStuck : Recovery::kFree;
}

namespace host {

void attach(const I2cPort& port, I2cParts parts) { of(port).parts = std::move(parts); }
void hold(const I2cPort& port, bool held) { of(port).held = held; }

}  // namespace host
}  // namespace finemote
