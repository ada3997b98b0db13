// I2C by looking at the flags: RM0090 27.3.3. The processor does nothing else until a transaction has ended.
#include "i2c_port.hpp"
#include "marks.hpp"

namespace baseline {

namespace {

using namespace finemote::stm32f4;

/// @return  whether the masked bits came to be `value` in time
[[gnu::noinline]] bool wait(const Register& status, std::uint32_t mask, std::uint32_t value, finemote::Duration time) {
  const Spinning spinning;
  const std::uint32_t from = finemote::cortex_m4::cycles(), limit = cycles_in(time);
  do {
    if ((status.read() & mask) == value) return true;
  } while (finemote::cortex_m4::cycles() - from < limit);
  return false;
}

bool fail() {
  kI2c.sr1().write(~i2c::kErrors & 0xDFFF);  // cleared by writing 0: RM0090 27.6.6
  kI2c.cr1().write(i2c::kOn | i2c::kStop);
  return false;
}

/// An event of SR1, or no acknowledge.
bool event(std::uint32_t flag) {
  const bool came = wait(kI2c.sr1(), flag, flag, i2c_policy.step);
  return came || fail();
}

bool wait_for_address() {
  const Spinning spinning;
  const std::uint32_t from = finemote::cortex_m4::cycles(), limit = cycles_in(i2c_policy.step);
  do {
    const std::uint32_t status = kI2c.sr1().read();
    if ((status & i2c::kAddressSent) != 0) return true;
    if ((status & i2c::kErrors) != 0) return false;
  } while (finemote::cortex_m4::cycles() - from < limit);
  return false;
}

/// CR1 must not be written while a STOP is pending: RM0090 27.6.1.
bool is_bus_free() {
  return wait(kI2c.cr1(), i2c::kStop, 0, i2c_policy.step) && wait(kI2c.sr2(), i2c::kBusy, 0, i2c_policy.bus_free);
}

bool begin(std::uint8_t address, bool reads, std::uint32_t acknowledge) {
  if (!is_bus_free()) {
    if (i2c_policy.recovers) free_i2c();
    return false;
  }
  kI2c.cr1().write(i2c::kOn | i2c::kStart | acknowledge);
  if (!event(i2c::kStartSent)) return false;
  kI2c.dr().write(std::uint32_t{address} << 1 | (reads ? 1 : 0));
  return wait_for_address() || fail();
}

void let_address_go() { static_cast<void>(kI2c.sr2().read()); }

std::uint8_t byte() { return static_cast<std::uint8_t>(kI2c.dr().read()); }

}  // namespace

void start_i2c() { set_up_i2c(); }

bool write_i2c(std::uint8_t address, const std::uint8_t* bytes, std::size_t size) {
  if (!begin(address, false, 0)) return false;
  let_address_go();
  for (std::size_t i = 0; i < size; ++i) {
    if (!event(i2c::kTransmitEmpty)) return false;
    kI2c.dr().write(bytes[i]);
  }
  if (!event(i2c::kByteFinished)) return false;
  kI2c.cr1().write(i2c::kOn | i2c::kStop);
  return true;
}

/// The ends of reads by their length: RM0090 27.3.3, "Master receiver".
bool read_i2c(std::uint8_t address, std::uint8_t* bytes, std::size_t size) {
  if (!begin(address, true, i2c::kAcknowledge | (size == 2 ? i2c::kAckNext : 0))) return false;
  if (size == 2) kI2c.cr1().write(i2c::kOn | i2c::kAckNext);  // no acknowledge for the byte after the next
  let_address_go();
  if (size == 3) {
    if (!event(i2c::kByteFinished)) return false;
    kI2c.cr1().write(i2c::kOn);  // no acknowledge for the last byte
    *bytes++ = byte();
  }
  if (!event(i2c::kByteFinished)) return false;
  kI2c.cr1().write(i2c::kOn | i2c::kStop);
  bytes[0] = byte();
  bytes[1] = byte();
  return true;
}

}  // namespace baseline
