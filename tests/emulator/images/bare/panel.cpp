// LEDs, buzzer and heater by timers and as plain pins, the key by its edge: HAL_TIM_PWM_Start, HAL_TIM_Base_Start_IT
// and HAL_GPIO_EXTI_IRQHandler in registers. RM0090 8, 10.2, 18.3, 19.3.
#include <cstdint>
#include <initializer_list>

#include "clocks.hpp"
#include "registers.hpp"

namespace {

constexpr std::uint32_t kTim4 = 0x40000800, kTim5 = 0x40000C00, kTim10 = 0x40014400, kTim14 = 0x40002000;
constexpr std::uint32_t kExti = 0x40013C00, kSyscfg = 0x40013800;

}  // namespace

extern "C" {
volatile std::uint32_t periods, presses, releases;

void TIM8_TRG_COM_TIM14_IRQHandler() {
  if ((word_at(kTim14 + 0x10) & 1) == 0) return;
  word_at(kTim14 + 0x10) = ~1U;
  touch(kTim14 + 0x10);  // HAL goes on and asks for other flags
  periods = periods + 1;
}

void EXTI0_IRQHandler() {
  if ((word_at(kExti + 0x14) & 1) == 0) return;
  word_at(kExti + 0x14) = 1;
  const bool is_down = (word_at(gpio::base('A') + 0x10) & 1) == 0;
  if (is_down)
    presses = presses + 1;
  else
    releases = releases + 1;
}
}

namespace {

/// A channel from 1 to 4 of a timer counts in PWM mode 1 with preload.
void start_pulses(std::uint32_t timer, unsigned channel, std::uint32_t prescaler, std::uint32_t period,
                  std::uint32_t width) {
  clear(word_at(timer), 0x370);
  set(word_at(timer), 1U << 7);
  word_at(timer + 0x2C) = period - 1;
  word_at(timer + 0x28) = prescaler - 1;
  word_at(timer + 0x14) = 1;
  const std::uint32_t mode = timer + 0x18 + 4 * ((channel - 1) / 2);
  const unsigned shift = (channel - 1) % 2 * 8;
  clear(word_at(timer + 0x20), 1U << (4 * (channel - 1)));
  change(word_at(mode), 0xFFU << shift, 0x60U << shift);
  word_at(timer + 0x34 + 4 * (channel - 1)) = width;
  set(word_at(mode), 8U << shift);
  clear(word_at(mode), 4U << shift);
  set(word_at(timer + 0x20), 1U << (4 * (channel - 1)));
  set(word_at(timer), 1);
}

/// A timer whose update interrupts every ms, as HAL uses one for its time base beside an operating system.
void start_time_base() {
  rcc::enable(rcc::kApb1, 8);
  clear(word_at(kTim14), 0x370);
  word_at(kTim14 + 0x2C) = 999;
  word_at(kTim14 + 0x28) = 83;
  word_at(kTim14 + 0x14) = 1;
  clear(word_at(kTim14 + 0x10), 1);
  set(word_at(kTim14 + 0x0C), 1);
  set(word_at(kTim14), 1);
  nvic::priority(45, 15);
  nvic::enable(45);
}

/// Both edges of PA0, with the pull-up.
void watch_key() {
  rcc::enable(rcc::kAhb1, 0);
  change(word_at(gpio::base('A') + 0x0C), 3, 1);
  change(word_at(gpio::base('A')), 3, 0);
  rcc::enable(rcc::kApb2, 14);
  change(word_at(kSyscfg + 0x08), 0xF, 0);
  set(word_at(kExti + 0x08), 1);
  set(word_at(kExti + 0x0C), 1);
  clear(word_at(kExti + 0x04), 1);
  set(word_at(kExti), 1);
  nvic::priority(6, 5);
  nvic::enable(6);
}

}  // namespace

int main() {
  start_clocks();
  for (const unsigned bit : {2U, 3U}) rcc::enable(rcc::kApb1, bit);
  rcc::enable(rcc::kApb2, 17);
  rcc::enable(rcc::kAhb1, 7);
  start_time_base();
  watch_key();
  start_pulses(kTim5, 1, 84, 1000, 250);
  gpio::alternate('H', 10, 2);
  change(word_at(gpio::base('H')), 3U << 22, 1U << 22);  // PH11: an output
  start_pulses(kTim4, 3, 84, 500, 250);
  start_pulses(kTim10, 1, 1, 5000, 2500);
  gpio::alternate('F', 6, 3);
  bool sounds = false;
  for (;;) {
    const bool is_down = (word_at(gpio::base('A') + 0x10) & 1) == 0;
    word_at(gpio::base('H') + 0x18) = is_down ? 1U << 11 : 1U << 27;
    if (is_down && !sounds) gpio::alternate('D', 14, 2);
    if (!is_down && sounds) change(word_at(gpio::base('D')), 3U << 28, 0);
    sounds = is_down;
  }
}
