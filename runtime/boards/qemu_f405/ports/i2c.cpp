// I2cPort without a bus: QEMU has no I2C peripheral, so nobody answers. Interrupts are real, pended by software.
#include "runtime/boards/qemu_f405/ports/i2c.hpp"

namespace finemote {

void I2cPort::configure(std::int64_t, I2cBus& bus) {
  hardware_->bus = &bus;
  cortex_m4::enable_line(hardware_->line, cortex_m4::kSlowBusPriority);
}
bool I2cPort::lines_free() const { return true; }
bool I2cPort::stands_still() const { return true; }
void I2cPort::pend() { hardware_->pend(); }
void I2cPort::begin(const I2cMessage&) {
  hardware_->exchange = true;
  hardware_->pend();
}
void I2cPort::abort() { hardware_->exchange = false; }
I2cPort::Recovery I2cPort::recover(unsigned) { return Recovery::kFree; }

}  // namespace finemote
