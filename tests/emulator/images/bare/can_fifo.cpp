// Group frames to motors by mailboxes whose number TSR.CODE says, reports of the motors from FIFO 1 by interrupt, each
// identifier through a filter of its own. In the manner of ST's HAL: RM0090 32.7, 32.9.
#include <cstdint>

#include "clocks.hpp"
#include "registers.hpp"

namespace {

namespace can {
constexpr std::uint32_t kBase = 0x40006400, kMcr = kBase, kMsr = kBase + 0x04, kTsr = kBase + 0x08,
                        kFifo1 = kBase + 0x10, kIer = kBase + 0x14, kBtr = kBase + 0x1C, kFilterMode = kBase + 0x200,
                        kFilterList = kBase + 0x204, kFilterScale = kBase + 0x20C, kFilterFifo = kBase + 0x214,
                        kFilterOn = kBase + 0x21C, kFilters = kBase + 0x240;
constexpr std::uint32_t mailbox(unsigned number) { return kBase + 0x180 + 0x10 * number; }
constexpr std::uint32_t received(unsigned fifo) { return kBase + 0x1B0 + 0x10 * fifo; }
}  // namespace can

constexpr unsigned kFifo1Line = 21;

}  // namespace

extern "C" {
volatile std::uint32_t reports[4];  ///< of motors 1 to 4
volatile std::uint32_t last_words[4];
volatile std::uint32_t sent_frames, no_room, filter_matches, current;
}

namespace {

/// A filter of 32 bits by mask, into FIFO 1: HAL_CAN_ConfigFilter.
void add_filter(unsigned bank, std::uint32_t identifier) {
  set(word_at(can::kFilterMode), 1);
  change(word_at(can::kFilterMode), 0x3FU << 8, 14U << 8);
  clear(word_at(can::kFilterOn), 1U << bank);
  set(word_at(can::kFilterScale), 1U << bank);
  word_at(can::kFilters + 8 * bank) = identifier << 21;
  word_at(can::kFilters + 8 * bank + 4) = 0x7FFU << 21 | 6;
  clear(word_at(can::kFilterList), 1U << bank);
  set(word_at(can::kFilterFifo), 1U << bank);
  set(word_at(can::kFilterOn), 1U << bank);
  clear(word_at(can::kFilterMode), 1);
}

void start_controller() {
  rcc::enable(rcc::kApb1, 25);
  gpio::alternate('D', 0, 9);
  gpio::alternate('D', 1, 9);
  clear(word_at(can::kMcr), 2);
  while ((word_at(can::kMsr) & 2) != 0) {}
  set(word_at(can::kMcr), 1);
  while ((word_at(can::kMsr) & 1) == 0) {}
  word_at(can::kMcr) = (word_at(can::kMcr) & ~0xFCU) | 1U << 6 | 1U << 5 | 1U << 2;  // recovers, wakes, by request
  word_at(can::kBtr) = 2 | 9U << 16 | 2U << 20;                                      // 42 MHz / 3 / 14: 1 Mbit/s
  for (unsigned motor = 0; motor < 4; ++motor) add_filter(motor, 0x201 + motor);
  clear(word_at(can::kMcr), 1);
  while ((word_at(can::kMsr) & 1) != 0) {}
  set(word_at(can::kIer), 1U << 4);  // FMPIE1
}

/// HAL_CAN_AddTxMessage.
void send(std::uint32_t identifier, std::uint32_t low, std::uint32_t high) {
  const std::uint32_t status = word_at(can::kTsr);
  if ((status & 7U << 26) == 0) {
    no_room = no_room + 1;
    return;
  }
  const unsigned mailbox = status >> 24 & 3;
  word_at(can::mailbox(mailbox)) = identifier << 21;
  word_at(can::mailbox(mailbox) + 0x04) = 8;
  word_at(can::mailbox(mailbox) + 0x0C) = high;
  word_at(can::mailbox(mailbox) + 0x08) = low;
  set(word_at(can::mailbox(mailbox)), 1);
  sent_frames = sent_frames + 1;
}

}  // namespace

extern "C" void CAN1_RX1_IRQHandler() {
  while ((word_at(can::kFifo1) & 3) != 0) {
    const std::uint32_t identifier = word_at(can::received(1)) >> 21, match = word_at(can::received(1) + 4) >> 8 & 0xFF;
    const std::uint32_t low = word_at(can::received(1) + 8);
    set(word_at(can::kFifo1), 1U << 5);
    const std::uint32_t motor = identifier - 0x201;
    if (motor > 3) continue;
    reports[motor] = reports[motor] + 1;
    last_words[motor] = low;
    if (match == motor) filter_matches = filter_matches + 1;
  }
}

int main() {
  start_clocks();
  start_controller();
  nvic::priority(kFifo1Line, 5);
  nvic::enable(kFifo1Line);
  current = 500;
  std::uint32_t next = ticks;
  for (;;) {
    while (ticks == next) {}
    next = ticks;
    const std::uint32_t word = (current >> 8 & 0xFF) | (current & 0xFF) << 8;
    send(0x200, word | word << 16, word | word << 16);
    send(0x1FF, 0, 0);
  }
}
