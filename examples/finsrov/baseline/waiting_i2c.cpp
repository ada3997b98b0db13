// I2C by interrupts: the calling task waits for a semaphore, and others run. Before the kernel runs it waits by
// looking.
//
// Procedures: RM0090 27.3.3, in the variant that holds the clock at the end of a byte.
#include "finemote/single_core.hpp"
#include "i2c_port.hpp"
#include "kernel.hpp"
#include "marks.hpp"
#include "runtime/chips/stm32f4/interrupt.hpp"

namespace baseline {

namespace {

using namespace finemote::stm32f4;

constexpr unsigned kEventLine = 33, kErrorLine = 34;

struct {
  std::uint8_t address = 0;
  bool reads = false;
  std::uint8_t* in = nullptr;
  const std::uint8_t* out = nullptr;
  std::size_t left = 0;
  volatile bool ended = true, good = false;
} transfer;

Semaphore done;

/// The routine and its caller see each other's stores.
void fence() { finemote::Shared<bool>::fence(); }

void finish(bool good) {
  transfer.good = good;
  transfer.ended = true;
  kI2c.cr2().clear(i2c::kEventInterrupt | i2c::kErrorInterrupt);
  if (kernel_runs()) done.give();
}

std::uint8_t byte() { return static_cast<std::uint8_t>(kI2c.dr().read()); }

void address_sent() {
  if (transfer.reads && transfer.left == 2) kI2c.cr1().write(i2c::kOn | i2c::kAckNext);
  static_cast<void>(kI2c.sr2().read());
  if (!transfer.reads) {
    kI2c.dr().write(*transfer.out++);
    --transfer.left;
  }
}

void byte_finished() {
  if (!transfer.reads && transfer.left != 0) {
    kI2c.dr().write(*transfer.out++);
    --transfer.left;
    return;
  }
  if (!transfer.reads) {
    kI2c.cr1().write(i2c::kOn | i2c::kStop);
    static_cast<void>(kI2c.dr().read());  // clears the flag
    return finish(true);
  }
  if (transfer.left == 3) {
    kI2c.cr1().write(i2c::kOn);  // no acknowledge for the last byte
    *transfer.in++ = byte();
    --transfer.left;
    return;
  }
  kI2c.cr1().write(i2c::kOn | i2c::kStop);
  transfer.in[0] = byte();
  transfer.in[1] = byte();
  finish(true);
}

/// At the end of a STOP the bus is free within a bit.
bool is_bus_free() {
  const Spinning spinning;
  const std::uint32_t from = finemote::cortex_m4::cycles(), limit = cycles_in(i2c_policy.bus_free);
  do {
    if (!kI2c.cr1().any(i2c::kStop) && !kI2c.sr2().any(i2c::kBusy)) return true;
  } while (finemote::cortex_m4::cycles() - from < limit);
  return false;
}

bool wait_for_end() {
  constexpr finemote::Duration kTick = finemote::kMillisecond;
  if (kernel_runs()) return done.take(static_cast<Tick>(i2c_policy.step / kTick) + 1);
  const std::uint32_t from = finemote::cortex_m4::cycles(), limit = cycles_in(i2c_policy.step);
  while (!transfer.ended && finemote::cortex_m4::cycles() - from < limit) {}
  fence();
  return transfer.ended;
}

bool exchange() {
  if (!is_bus_free()) {
    if (i2c_policy.recovers) free_i2c();
    return false;
  }
  transfer.ended = transfer.good = false;
  done.clear();
  fence();
  kI2c.cr2().set(i2c::kEventInterrupt | i2c::kErrorInterrupt);
  const std::uint32_t acknowledge = !transfer.reads      ? 0
                                    : transfer.left == 2 ? i2c::kAcknowledge | i2c::kAckNext
                                                         : i2c::kAcknowledge;
  kI2c.cr1().write(i2c::kOn | i2c::kStart | acknowledge);
  if (wait_for_end()) return transfer.good;
  kI2c.cr2().clear(i2c::kEventInterrupt | i2c::kErrorInterrupt);
  if (i2c_policy.recovers) free_i2c();
  return false;
}

}  // namespace

extern "C" void finemote_line_33() {
  const std::uint32_t status = kI2c.sr1().read();
  if ((status & i2c::kStartSent) != 0)
    kI2c.dr().write(std::uint32_t{transfer.address} << 1 | (transfer.reads ? 1 : 0));
  else if ((status & i2c::kAddressSent) != 0)
    address_sent();
  else if ((status & i2c::kByteFinished) != 0)
    byte_finished();
  settle(kI2c.cr1());
}

extern "C" void finemote_line_34() {
  kI2c.sr1().write(~i2c::kErrors & 0xDFFF);
  kI2c.cr1().write(i2c::kOn | i2c::kStop);
  finish(false);
  settle(kI2c.cr1());
}

void start_i2c() {
  set_up_i2c();
  finemote::cortex_m4::enable_line(kEventLine, finemote::cortex_m4::kSlowBusPriority);
  finemote::cortex_m4::enable_line(kErrorLine, finemote::cortex_m4::kSlowBusPriority);
}

bool write_i2c(std::uint8_t address, const std::uint8_t* bytes, std::size_t size) {
  transfer.address = address;
  transfer.reads = false;
  transfer.out = bytes;
  transfer.left = size;
  return exchange();
}

bool read_i2c(std::uint8_t address, std::uint8_t* bytes, std::size_t size) {
  transfer.address = address;
  transfer.reads = true;
  transfer.in = bytes;
  transfer.left = size;
  return exchange();
}

}  // namespace baseline
