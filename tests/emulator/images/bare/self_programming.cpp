// Keeps a table in the last sector of flash: erased and programmed by the program itself, as ST's HAL does it
// (HAL_FLASHEx_Erase, HAL_FLASH_Program), with the caches flushed after the erase. RM0090 3.6.
#include <cstdint>
#include <initializer_list>

#include "clocks.hpp"
#include "registers.hpp"

namespace {

constexpr std::uint32_t kAcr = 0x40023C00, kKey = 0x40023C04, kSr = 0x40023C0C, kCr = 0x40023C10;
constexpr std::uint32_t kBusy = 1U << 16, kErrors = 0xF0, kLocked = 1U << 31;
constexpr std::uint32_t kSector = 11, kTable = 0x080E0000;

}  // namespace

extern "C" {
volatile std::uint32_t errors, before_erase, after_erase, programmed[4], bytes_programmed, erase_ms;
volatile std::uint32_t is_locked;
}

namespace {

void wait() {
  while ((word_at(kSr) & kBusy) != 0) {}
  errors = errors | (word_at(kSr) & kErrors);
  if ((word_at(kSr) & 1) != 0) word_at(kSr) = 1;
}

void unlock() {
  if ((word_at(kCr) & kLocked) == 0) return;
  word_at(kKey) = 0x45670123;
  word_at(kKey) = 0xCDEF89AB;
}

void lock() { set(word_at(kCr), kLocked); }

/// HAL_FLASHEx_Erase, which then turns the caches off, resets them and turns them on again.
void erase() {
  wait();
  change(word_at(kCr), 3U << 8, 2U << 8);
  change(word_at(kCr), 0xFU << 3, 2 | kSector << 3);
  set(word_at(kCr), 1U << 16);
  wait();
  clear(word_at(kCr), 2 | 0xFU << 3);
  for (const unsigned cache : {9U, 10U}) {
    clear(word_at(kAcr), 1U << cache);
    set(word_at(kAcr), 1U << (cache + 2));
    clear(word_at(kAcr), 1U << (cache + 2));
    set(word_at(kAcr), 1U << cache);
  }
}

void program_word(std::uint32_t address, std::uint32_t value) {
  wait();
  change(word_at(kCr), 3U << 8, 2U << 8);
  set(word_at(kCr), 1);
  word_at(address) = value;
  wait();
  clear(word_at(kCr), 1);
}

void program_byte(std::uint32_t address, std::uint8_t value) {
  wait();
  clear(word_at(kCr), 3U << 8);
  set(word_at(kCr), 1);
  byte_at(address) = value;
  wait();
  clear(word_at(kCr), 1);
}

}  // namespace

int main() {
  start_clocks();
  before_erase = word_at(kTable);
  const std::uint32_t begin = ticks;
  unlock();
  erase();
  after_erase = word_at(kTable);
  erase_ms = ticks - begin;
  for (std::uint32_t i = 0; i < 4; ++i) {
    program_word(kTable + 4 * i, 0x11111111 * (i + 1));
    programmed[i] = word_at(kTable + 4 * i);
  }
  program_byte(kTable + 16, 0x5A);
  bytes_programmed = byte_at(kTable + 16);
  lock();
  is_locked = word_at(kCr) >> 31;
  for (;;) {}
}
