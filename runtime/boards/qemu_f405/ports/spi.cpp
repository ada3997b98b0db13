// SpiPort without chips: every exchange ends at once and reads ones. Interrupts are real, pended by software.
#include "finemote/spi.hpp"

#include "runtime/boards/cortex_m4/core.hpp"
#include "runtime/boards/cortex_m4/registers.hpp"

namespace finemote {

struct SpiHardware {
  unsigned line;
  SpiBus* bus = nullptr;
  bool exchange = false;

  void pend() const { cortex_m4::nvic::set_pending(line / 32) = cortex_m4::bit(line % 32); }
  void on_line() {
    const bool ended = exchange;
    exchange = false;
    if (bus != nullptr) bus->on_interrupt(ended ? SpiEvent::kDone : SpiEvent::kNone);
  }
};

namespace {

SpiHardware spi1{35};
SpiHardware spi2{36};

}  // namespace

SpiPort ports::spi1{finemote::spi1};
SpiPort ports::spi2{finemote::spi2};

void SpiPort::configure(std::int64_t, SpiBus& bus) {
  hardware_->bus = &bus;
  cortex_m4::enable_line(hardware_->line, cortex_m4::kSlowBusPriority);
}
void SpiPort::pend() { hardware_->pend(); }
void SpiPort::begin(const SpiMessage& message) {
  for (std::uint16_t i = 0; message.read != nullptr && i < message.size; ++i) message.read[i] = 0xFF;
  hardware_->exchange = true;
  hardware_->pend();
}
void SpiPort::abort() { hardware_->exchange = false; }

}  // namespace finemote

extern "C" void finemote_line_35() { finemote::spi1.on_line(); }
extern "C" void finemote_line_36() { finemote::spi2.on_line(); }
