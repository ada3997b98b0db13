// SpiPort without chips: every exchange ends at once and reads ones. Interrupts are real, pended by software.
#include "runtime/boards/qemu_f405/ports/spi.hpp"

namespace finemote {

void SpiPort::configure(std::int64_t, SpiBus& bus) {
  hardware_->bus = &bus;
  cortex_m4::enable_line(hardware_->line, cortex_m4::kSlowBusPriority);
}
std::uint16_t SpiPort::moved() const { return 0; }
void SpiPort::pend() { hardware_->pend(); }
void SpiPort::begin(const SpiMessage& message) {
  for (std::uint16_t i = 0; message.read != nullptr && i < message.size; ++i) message.read[i] = 0xFF;
  hardware_->exchange = true;
  hardware_->pend();
}
void SpiPort::abort() { hardware_->exchange = false; }

}  // namespace finemote
