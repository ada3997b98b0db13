// A remote control's frames of 18 bytes by DMA into two buffers, which the interrupt of an idle line takes: the manner
// of RoboMaster's examples, registers only. RM0090 10.3.9, 30.3.3.
#include <cstdint>

#include "clocks.hpp"
#include "registers.hpp"

namespace {

constexpr std::uint32_t kUart = 0x40004800, kSr = kUart, kDr = kUart + 0x04, kStream = 0x40026028, kClear = 0x40026008;
constexpr std::uint32_t kEnable = 1, kTwoBuffers = 1U << 18, kSecond = 1U << 19;
constexpr unsigned kRoom = 36, kFrame = 18;

}  // namespace

extern "C" {
std::uint8_t buffers[2][kRoom];
volatile std::uint32_t frames[2], odd_lengths, channel, switches;

void USART3_IRQHandler() {
  const std::uint32_t status = word_at(kSr);
  if ((status & 1U << 5) != 0) {
    touch(kDr);
    return;
  }
  if ((status & 1U << 4) == 0) return;
  touch(kDr);
  clear(word_at(kStream), kEnable);
  while ((word_at(kStream) & kEnable) != 0) {}
  const std::uint32_t length = kRoom - word_at(kStream + 0x04);
  word_at(kStream + 0x04) = kRoom;
  const unsigned filled = (word_at(kStream) & kSecond) == 0 ? 0 : 1;
  word_at(kStream) = word_at(kStream) ^ kSecond;
  word_at(kClear) = 0x3DU << 6;
  set(word_at(kStream), kEnable);
  if (length != kFrame) {
    odd_lengths = odd_lengths + 1;
    return;
  }
  const std::uint8_t* bytes = buffers[filled];
  frames[filled] = frames[filled] + 1;
  channel = (bytes[0] | bytes[1] << 8) & 0x7FF;
  switches = bytes[5] >> 4;
}
}

int main() {
  start_clocks();
  rcc::enable(rcc::kAhb1, 21);
  rcc::enable(rcc::kApb1, 18);
  gpio::alternate('C', 10, 7);
  gpio::alternate('C', 11, 7);
  word_at(kUart + 0x08) = 420;  // 42 MHz / 100000
  word_at(kUart + 0x10) = 0;
  change(word_at(kUart + 0x0C), 0x960C, 1U << 12 | 1U << 10 | 0xC);  // nine bits, one of them the even parity
  set(word_at(kUart + 0x0C), 1U << 13);
  word_at(kStream) = 4U << 25 | 2U << 16 | 1U << 10;
  set(word_at(kUart + 0x14), 1U << 6);
  set(word_at(kUart + 0x0C), 1U << 4);
  clear(word_at(kStream), kEnable);
  while ((word_at(kStream) & kEnable) != 0) {}
  word_at(kStream + 0x08) = kDr;
  word_at(kStream + 0x0C) = reinterpret_cast<std::uint32_t>(buffers[0]);
  word_at(kStream + 0x10) = reinterpret_cast<std::uint32_t>(buffers[1]);
  word_at(kStream + 0x04) = kRoom;
  set(word_at(kStream), kTwoBuffers);
  word_at(kClear) = 0x3DU << 6;
  set(word_at(kStream), kEnable);
  nvic::priority(39, 5);
  nvic::enable(39);
  for (;;) {}
}
