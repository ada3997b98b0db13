// I2cPort without a bus: QEMU has no I2C peripheral, so nobody answers. Interrupts are real, pended by software.
#include "finemote/i2c.hpp"

#include "runtime/boards/cortex_m4/core.hpp"
#include "runtime/boards/cortex_m4/registers.hpp"

namespace finemote {

struct I2cHardware {
  unsigned line;
  I2cBus* bus = nullptr;
  bool exchange = false;

  void pend() const { cortex_m4::nvic::set_pending(line / 32) = cortex_m4::bit(line % 32); }
  void on_line() {
    const bool ended = exchange;
    exchange = false;
    if (bus != nullptr) bus->on_interrupt(ended ? I2cEvent::kNack : I2cEvent::kNone);
  }
};

namespace {

I2cHardware i2c2{33};
I2cHardware i2c3{72};

}  // namespace

I2cPort ports::i2c2{finemote::i2c2};
I2cPort ports::i2c3{finemote::i2c3};

void I2cPort::configure(std::int64_t, I2cBus& bus) {
  hardware_->bus = &bus;
  cortex_m4::enable_line(hardware_->line, cortex_m4::kSlowBusPriority);
}
void I2cPort::pend() { hardware_->pend(); }
void I2cPort::begin(const I2cMessage&) {
  hardware_->exchange = true;
  hardware_->pend();
}
void I2cPort::abort() { hardware_->exchange = false; }
I2cPort::Recovery I2cPort::recover(unsigned) { return Recovery::kFree; }

}  // namespace finemote

extern "C" void finemote_line_33() { finemote::i2c2.on_line(); }
extern "C" void finemote_line_72() { finemote::i2c3.on_line(); }
