// An echo on USART6 in the manner of ST's HAL: received by circular DMA with interrupts at its half, at its end and on
// an idle line (ReceiveToIdle_DMA), sent by DMA until the transmission is complete. RM0090 10.3.17, 30.3.13.
#include <cstdint>

#include "clocks.hpp"
#include "registers.hpp"

namespace {

namespace uart {
constexpr std::uint32_t kBase = 0x40011400, kSr = kBase, kDr = kBase + 0x04, kBrr = kBase + 0x08, kCr1 = kBase + 0x0C,
                        kCr2 = kBase + 0x10, kCr3 = kBase + 0x14;
constexpr std::uint32_t kIdle = 1U << 4, kComplete = 1U << 6, kOverrun = 1U << 3;
}  // namespace uart

namespace dma {
constexpr std::uint32_t kBase = 0x40026400, kLowFlags = kBase, kHighFlags = kBase + 0x04, kLowClear = kBase + 0x08,
                        kHighClear = kBase + 0x0C;
constexpr std::uint32_t stream(unsigned number) { return kBase + 0x10 + 0x18 * number; }
constexpr std::uint32_t kHalf = 1U << 4, kEnd = 1U << 5, kAll = 0x3D;  // of a stream's flags
constexpr unsigned kShiftOf1 = 6, kShiftOf6 = 16;
}  // namespace dma

constexpr unsigned kRing = 32, kReceive = 1, kTransmit = 6;

}  // namespace

extern "C" {
std::uint8_t ring[kRing], reply[kRing];
volatile std::uint32_t halves, ends, idles, sent, overruns, taken, replies_waiting;
}

namespace {

unsigned position = 0;  ///< in the ring, of what was not taken yet
volatile bool is_sending = false;
std::uint8_t waiting[256];
unsigned waiting_size = 0;

/// The order of HAL_DMA_Start_IT: off, address, flags, interrupts, on.
void start_stream(unsigned number, std::uint32_t memory, std::uint32_t count, std::uint32_t control) {
  const std::uint32_t base = dma::stream(number);
  clear(word_at(base), 1);
  while ((word_at(base) & 1) != 0) {}
  clear(word_at(base), 1U << 18);
  word_at(base + 0x04) = count;
  word_at(base + 0x08) = uart::kDr;
  word_at(base + 0x0C) = memory;
  const std::uint32_t clear_at = number < 4 ? dma::kLowClear : dma::kHighClear;
  word_at(clear_at) = 0x3FU << (number == kReceive ? dma::kShiftOf1 : dma::kShiftOf6);
  set(word_at(base), control);
  set(word_at(base), 1);
}

void send_next() {
  if (is_sending || waiting_size == 0) return;
  const unsigned size = waiting_size < kRing ? waiting_size : kRing;
  for (unsigned i = 0; i < size; ++i) reply[i] = waiting[i];
  for (unsigned i = size; i < waiting_size; ++i) waiting[i - size] = waiting[i];
  waiting_size -= size;
  is_sending = true;
  start_stream(kTransmit, reinterpret_cast<std::uint32_t>(reply), size, 1U << 4 | 1U << 2 | 1U << 1);
  word_at(uart::kSr) = ~uart::kComplete;
  set(word_at(uart::kCr3), 1U << 7);
}

/// What arrived since the last time, in capitals.
void take() {
  const unsigned now = kRing - word_at(dma::stream(kReceive) + 0x04);
  for (; position != now % kRing; position = (position + 1) % kRing) {
    const std::uint8_t byte = ring[position];
    waiting[waiting_size++] = byte >= 'a' && byte <= 'z' ? static_cast<std::uint8_t>(byte - 32) : byte;
    taken = taken + 1;
  }
  send_next();
}

void set_up_streams() {
  rcc::enable(rcc::kAhb1, 22);
  constexpr std::uint32_t kChannel = 5U << 25, kMemoryIncrement = 1U << 10, kCircular = 1U << 8,
                          kToPeripheral = 1U << 6;
  word_at(dma::stream(kReceive)) = kChannel | kMemoryIncrement | kCircular;
  word_at(dma::stream(kReceive) + 0x14) = 0x20;
  word_at(dma::stream(kTransmit)) = kChannel | kMemoryIncrement | kToPeripheral;
  word_at(dma::stream(kTransmit) + 0x14) = 0x20;
}

void set_up_line() {
  rcc::enable(rcc::kApb2, 5);
  gpio::alternate('G', 9, 8);
  gpio::alternate('G', 14, 8);
  clear(word_at(uart::kCr1), 1U << 13);
  word_at(uart::kCr2) = 0;
  change(word_at(uart::kCr1), 0x960C, 0xC);
  word_at(uart::kCr3) = 0;
  word_at(uart::kBrr) = 0x2D9;  // 84 MHz / 115200
  set(word_at(uart::kCr1), 1U << 13);
}

}  // namespace

extern "C" {

void DMA2_Stream1_IRQHandler() {
  const std::uint32_t flags = word_at(dma::kLowFlags) >> dma::kShiftOf1;
  if ((flags & dma::kHalf) != 0) {
    word_at(dma::kLowClear) = dma::kHalf << dma::kShiftOf1;
    halves = halves + 1;
    take();
  }
  if ((flags & dma::kEnd) != 0) {
    word_at(dma::kLowClear) = dma::kEnd << dma::kShiftOf1;
    ends = ends + 1;
    take();
  }
}

void DMA2_Stream6_IRQHandler() {
  const std::uint32_t flags = word_at(dma::kHighFlags) >> dma::kShiftOf6;
  if ((flags & dma::kEnd) == 0) return;
  clear(word_at(dma::stream(kTransmit)), 1U << 4 | 1U << 2 | 1U << 1);
  word_at(dma::kHighClear) = dma::kEnd << dma::kShiftOf6;
  clear(word_at(uart::kCr3), 1U << 7);
  set(word_at(uart::kCr1), uart::kComplete);  // TCIE
}

void USART6_IRQHandler() {
  const std::uint32_t status = word_at(uart::kSr), control = word_at(uart::kCr1);
  if ((status & uart::kOverrun) != 0) overruns = overruns + 1;
  if ((status & uart::kIdle) != 0 && (control & uart::kIdle) != 0) {
    touch(uart::kSr);
    touch(uart::kDr);
    idles = idles + 1;
    take();
  }
  if ((status & uart::kComplete) != 0 && (control & uart::kComplete) != 0) {
    clear(word_at(uart::kCr1), uart::kComplete);
    sent = sent + 1;
    is_sending = false;
    send_next();
  }
}
}

int main() {
  start_clocks();
  set_up_streams();
  set_up_line();
  nvic::priority(57, 5);
  nvic::enable(57);
  nvic::priority(69, 5);
  nvic::enable(69);
  nvic::priority(71, 5);
  nvic::enable(71);
  start_stream(kReceive, reinterpret_cast<std::uint32_t>(ring), kRing, 1U << 4 | 1U << 3 | 1U << 2 | 1U << 1);
  set(word_at(uart::kCr3), 1);        // errors
  set(word_at(uart::kCr1), 1U << 8);  // parity
  set(word_at(uart::kCr3), 1U << 6);  // DMAR
  touch(uart::kSr);
  touch(uart::kDr);
  set(word_at(uart::kCr1), uart::kIdle);
  for (;;) {}
}
