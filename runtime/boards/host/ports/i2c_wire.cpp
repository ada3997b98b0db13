#include "runtime/boards/host/ports/i2c_wire.hpp"

#include "finemote/host.hpp"
#include "finemote/i2c.hpp"

namespace finemote {

namespace {

/// START, STOP and 9 bits per byte, the address byte of each phase included.
Duration wire_time(const I2cHardware& wire, const I2cMessage& message) {
  const int phases = message.write_size != 0 && message.read_size != 0 ? 2 : 1;
  const std::int64_t bits = 9 * (phases + message.write_size + message.read_size) + phases + 1;
  return bits * kSecond / wire.clock_hz;
}

void interrupt(I2cHardware& wire, I2cEvent event) { wire.bus->on_interrupt(event); }

void end_exchange(I2cHardware& wire, std::uint64_t exchange, Time begin) {
  if (!wire.under_way || wire.exchange != exchange) return;  // aborted meanwhile
  if (wire.held != 0) return;                                // no clock comes through: only a deadline ends this
  wire.under_way = false;
  host::I2cExchange record{begin, now(), wire.message.address, {}, {}, I2cEvent::kNone};
  record.event = wire.perform(wire.message, record);
  wire.exchanges.push_back(record);
  interrupt(wire, record.event);
}

}  // namespace

// ---------------------------------------------------------------------------------------------------------------- wire

void I2cHardware::hold_sda(int clocks) { held = clocks; }

void I2cHardware::reset() {
  I2cHardware fresh;
  fresh.clock_hz = clock_hz;
  fresh.bus = bus;
  fresh.exchange = exchange + 1;
  *this = fresh;
}

host::I2cPart* I2cHardware::find(std::uint8_t address) {
  if (const auto found = parts.find(address); found != parts.end()) return found->second;
  for (const auto& [own, part] : parts) {
    if (host::I2cPart* behind = part->behind(address)) return behind;
  }
  return nullptr;
}

I2cEvent I2cHardware::perform(const I2cMessage& asked, host::I2cExchange& record) {
  if (disturbances > 0) {
    --disturbances;
    return I2cEvent::kError;
  }
  if (refusals > 0) {
    --refusals;
    return I2cEvent::kNack;
  }
  host::I2cPart* part = find(asked.address);
  if (part == nullptr) return I2cEvent::kNack;
  if (asked.write_size != 0 || asked.read_size == 0) {
    record.written.assign(asked.write, asked.write + asked.write_size);
    if (!part->write(record.written)) return I2cEvent::kNack;
  }
  if (asked.read_size != 0) {
    if (!part->read(asked.read_size, record.read)) return I2cEvent::kNack;
    record.read.resize(asked.read_size, 0xFF);
    for (std::size_t i = 0; i < record.read.size(); ++i) asked.read[i] = record.read[i];
  }
  return I2cEvent::kDone;
}

// ---------------------------------------------------------------------------------------------------------------- port

void I2cPort::configure(std::int64_t clock_hz, I2cBus& bus) {
  hardware_->clock_hz = clock_hz;
  hardware_->bus = &bus;
  pend();
}

bool I2cPort::lines_free() const { return hardware_->held == 0; }

bool I2cPort::stands_still() const { return true; }

void I2cPort::pend() {
  if (hardware_->when_pended) hardware_->when_pended();
  host::interrupt_at(now(), [wire = hardware_] { interrupt(*wire, I2cEvent::kNone); });
}

void I2cPort::begin(const I2cMessage& message) {
  I2cHardware& wire = *hardware_;
  wire.message = message;
  wire.under_way = true;
  const std::uint64_t exchange = ++wire.exchange;
  const Time begun = now();
  host::interrupt_at(begun + wire_time(wire, message),
                     [&wire, exchange, begun] { end_exchange(wire, exchange, begun); });
}

void I2cPort::abort() {
  if (!hardware_->under_way) return;
  hardware_->under_way = false;
  hardware_->exchanges.push_back({now(), now(), hardware_->message.address, {}, {}, I2cEvent::kNone});
}

// Three clocks per step, as the chip's port does it: nine clocks, then STOP.
I2cPort::Recovery I2cPort::recover(unsigned step) {
  constexpr unsigned kClocksPerStep = 3, kClocks = 9;
  I2cHardware& wire = *hardware_;
  if (step < kClocks / kClocksPerStep) {
    wire.recovery_clocks += kClocksPerStep;
    if (wire.held > 0) wire.held = wire.held > int{kClocksPerStep} ? wire.held - int{kClocksPerStep} : 0;
    return Recovery::kBusy;
  }
  return wire.held == 0 ? Recovery::kFree : Recovery::kStuck;
}

}  // namespace finemote
