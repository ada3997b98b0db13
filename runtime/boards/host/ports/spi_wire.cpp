#include "runtime/boards/host/ports/spi_wire.hpp"

#include "finemote/host.hpp"
#include "finemote/spi.hpp"

namespace finemote {

namespace {

void end_exchange(SpiHardware& wire, std::uint64_t exchange, const SpiMessage& message) {
  if (wire.exchange != exchange || wire.blocked) return;
  std::vector<std::uint8_t> out(message.size, 0xFF), in(message.size, 0xFF);
  if (message.write != nullptr) out.assign(message.write, message.write + message.size);
  if (const auto part = wire.parts.find(message.select); part != wire.parts.end()) in = part->second->exchange(out);
  in.resize(message.size, 0xFF);
  for (std::size_t i = 0; message.read != nullptr && i < in.size(); ++i) message.read[i] = in[i];
  wire.bus->on_interrupt(SpiEvent::kDone);
}

}  // namespace

void SpiPort::configure(std::int64_t clock_hz, SpiBus& bus) {
  hardware_->clock_hz = clock_hz;
  hardware_->bus = &bus;
}

std::uint16_t SpiPort::moved() const { return 0; }

void SpiPort::pend() {
  host::interrupt_at(now(), [wire = hardware_] { wire->bus->on_interrupt(SpiEvent::kNone); });
}

void SpiPort::begin(const SpiMessage& message) {
  SpiHardware& wire = *hardware_;
  const std::uint64_t exchange = ++wire.exchange;
  host::interrupt_at(now() + 8 * message.size * kSecond / wire.clock_hz,
                     [&wire, exchange, message] { end_exchange(wire, exchange, message); });
}

void SpiPort::abort() { ++hardware_->exchange; }

}  // namespace finemote
