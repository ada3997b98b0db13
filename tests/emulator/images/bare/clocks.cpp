#include "clocks.hpp"

#include "registers.hpp"

volatile std::uint32_t ticks = 0;

__attribute__((weak)) void on_tick() {}

extern "C" void SysTick_Handler() {
  ticks = ticks + 1;
  on_tick();
}

namespace {

constexpr std::uint32_t kFlashAcr = 0x40023C00, kPwrCr = 0x40007000;

/// A tick every ms, at the lowest priority: PM0214 4.5, 4.4.8.
void start_tick(std::uint32_t core_hz) {
  word_at(0xE000E014) = core_hz / 1000 - 1;
  byte_at(0xE000ED23) = 0xF0;
  word_at(0xE000E018) = 0;
  word_at(0xE000E010) = 7;
}

void wait_for(Register where, std::uint32_t mask, std::uint32_t value) {
  const std::uint32_t begin = ticks;
  while ((where & mask) != value) {
    if (ticks - begin > 100) asm volatile("bkpt 0");
  }
}

void start_pll() {
  constexpr unsigned kPllOn = 24;
  bit_at(rcc::kCr, kPllOn) = 0;
  wait_for(word_at(rcc::kCr), 1U << 25, 0);
  word_at(rcc::kPllCfgr) = 6 | 168U << 6 | 0U << 16 | 1U << 22 | 7U << 24;
  bit_at(rcc::kCr, kPllOn) = 1;
  wait_for(word_at(rcc::kCr), 1U << 25, 1U << 25);
}

void change_over() {
  byte_at(kFlashAcr) = 5;  // wait states, of which HAL writes the lowest byte alone
  wait_for(word_at(kFlashAcr), 0xF, 5);
  change(word_at(rcc::kCfgr), 7U << 10, 7U << 10);
  change(word_at(rcc::kCfgr), 7U << 13, 7U << 13);
  change(word_at(rcc::kCfgr), 0xFU << 4, 0);
  change(word_at(rcc::kCfgr), 3, 2);
  wait_for(word_at(rcc::kCfgr), 3U << 2, 2U << 2);
  change(word_at(rcc::kCfgr), 7U << 10, 5U << 10);
  change(word_at(rcc::kCfgr), 7U << 13, 4U << 13);
}

}  // namespace

void start_clocks() {
  set(word_at(kFlashAcr), 1U << 9);
  set(word_at(kFlashAcr), 1U << 10);
  set(word_at(kFlashAcr), 1U << 8);
  word_at(0xE000ED0C) = 0x05FA0000 | 3U << 8;  // four bits of priority, no sub-priorities
  start_tick(16'000'000);
  rcc::enable(rcc::kApb2, 14);
  rcc::enable(rcc::kApb1, 28);
  change(word_at(kPwrCr), 1U << 14, 1U << 14);
  set(word_at(rcc::kCr), 1U << 16);
  wait_for(word_at(rcc::kCr), 1U << 17, 1U << 17);
  start_pll();
  change_over();
  start_tick(168'000'000);
}
