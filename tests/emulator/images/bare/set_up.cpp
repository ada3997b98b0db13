// What the start of a program made by ST's code generator touches: real-time clock, random numbers, checksums, both
// converters with DMA, a digital output as analog, timers, an encoder, watchdog, SPI and I2C without anybody at them,
// the backup memory and a USB device without a cable; each in the order of HAL's own function. RM0090.
#include <cstdint>

#include "clocks.hpp"
#include "registers.hpp"

extern "C" {
volatile std::uint32_t seconds, random_words[2], checksum, temperature, reference, battery, dac_code, encoder, backup,
    usb_interrupts, updates, i2c_absent, spi_answer;
}

namespace {

/// HAL_RTC_Init on the LSI: RM0090 26.3.5.
void start_calendar() {
  constexpr std::uint32_t kRtc = 0x40002800, kPwr = 0x40007000;
  set(word_at(kPwr), 1U << 8);
  bit_at(rcc::kCsr, 0) = 1;
  while ((word_at(rcc::kCsr) & 2) == 0) {}
  if ((word_at(rcc::kBdcr) & 3U << 8) != 2U << 8) {
    bit_at(rcc::kBdcr, 16) = 1;
    bit_at(rcc::kBdcr, 16) = 0;
    set(word_at(rcc::kBdcr), 2U << 8);
  }
  bit_at(rcc::kBdcr, 15) = 1;
  word_at(kRtc + 0x24) = 0xCA;
  word_at(kRtc + 0x24) = 0x53;
  word_at(kRtc + 0x0C) = 0xFFFFFFFF;
  while ((word_at(kRtc + 0x0C) & 1U << 6) == 0) {}
  clear(word_at(kRtc + 0x08), 0x600040);
  word_at(kRtc + 0x10) = 255;
  set(word_at(kRtc + 0x10), 127U << 16);
  word_at(kRtc) = 0x00125930;      // 12:59:30
  word_at(kRtc + 4) = 0x0024C115;  // a Saturday, 15 January 24
  clear(word_at(kRtc + 0x0C), 1U << 7);
  word_at(kRtc + 0x24) = 0xFF;
  word_at(kRtc + 0x50) = 0x32F2;
  backup = word_at(kRtc + 0x50);
  while ((word_at(kRtc + 0x0C) & 1U << 5) == 0) {}
  seconds = word_at(kRtc) & 0x7F;
  touch(kRtc + 4);
}

void draw_numbers() {
  constexpr std::uint32_t kRng = 0x50060800;
  rcc::enable(rcc::kAhb2, 6);
  set(word_at(kRng), 4);
  for (volatile std::uint32_t& word : random_words) {
    while ((word_at(kRng + 4) & 1) == 0) {}
    word = word_at(kRng + 8);
  }
}

void sum_up() {
  constexpr std::uint32_t kCrc = 0x40023000;
  rcc::enable(rcc::kAhb1, 12);
  set(word_at(kCrc + 8), 1);
  word_at(kCrc) = 0x12345678;
  checksum = word_at(kCrc);
}

/// tSTAB of a converter, 3 us at most: DS8626 5.3.21.
void wait_until_stable() {
  for (volatile unsigned turns = 168; turns != 0; turns = turns - 1) {}
}

/// A scan of temperature and reference by DMA, and a single conversion of the battery.
void convert() {
  constexpr std::uint32_t kAdc1 = 0x40012000, kAdc3 = 0x40012200, kCommon = 0x40012304, kStream = 0x40026410;
  static volatile std::uint16_t codes[2];
  rcc::enable(rcc::kApb2, 8);
  rcc::enable(rcc::kApb2, 10);
  rcc::enable(rcc::kAhb1, 22);
  rcc::enable(rcc::kAhb1, 5);
  set(word_at(gpio::base('F')), 3U << 20);
  change(word_at(kCommon), 3U << 16, 1U << 16 | 1U << 23);
  word_at(kStream) = 1U << 10 | 1U << 11 | 1U << 13;  // halfwords, memory by one
  word_at(kStream + 0x04) = 2;
  word_at(kStream + 0x08) = kAdc1 + 0x4C;
  word_at(kStream + 0x0C) = reinterpret_cast<std::uint32_t>(codes);
  set(word_at(kStream), 1);
  set(word_at(kAdc1 + 4), 1U << 8);
  word_at(kAdc1 + 0x0C) = 7U << 18 | 7U << 21;
  word_at(kAdc1 + 0x34) = 16 | 17U << 5;
  word_at(kAdc1 + 0x2C) = 1U << 20;
  set(word_at(kAdc1 + 8), 1U << 10 | 1);
  wait_until_stable();
  set(word_at(kAdc1 + 8), 1U << 8);
  set(word_at(kAdc1 + 8), 1U << 30);
  while ((word_at(0x40026400) & 1U << 5) == 0) {}
  temperature = codes[0];
  reference = codes[1];
  word_at(kAdc3 + 0x10) = 7U << 24;
  word_at(kAdc3 + 0x34) = 8;
  set(word_at(kAdc3 + 8), 1);
  wait_until_stable();
  set(word_at(kAdc3 + 8), 1U << 30);
  while ((word_at(kAdc3) & 2) == 0) {}
  battery = word_at(kAdc3 + 0x4C);
}

void put_out() {
  constexpr std::uint32_t kDac = 0x40007400;
  rcc::enable(rcc::kApb1, 29);
  set(word_at(kDac), 1);
  word_at(kDac + 8) = 2048;
  dac_code = word_at(kDac + 0x2C);
}

/// A timer that interrupts nobody but counts, and another that reads an encoder: HAL_TIM_Base_Start, _Encoder_Start.
void count() {
  constexpr std::uint32_t kTim2 = 0x40000000, kTim6 = 0x40001000;
  rcc::enable(rcc::kApb1, 0);
  rcc::enable(rcc::kApb1, 4);
  change(word_at(kTim6), 1U << 7, 1U << 7);
  word_at(kTim6 + 0x2C) = 999;
  word_at(kTim6 + 0x28) = 83;
  word_at(kTim6 + 0x14) = 1;
  clear(word_at(kTim6 + 0x10), 1);
  set(word_at(kTim6), 1);
  word_at(kTim2 + 0x2C) = 0xFFFFFFFF;
  word_at(kTim2 + 0x28) = 0;
  word_at(kTim2 + 0x08) = 3;
  word_at(kTim2 + 0x18) = 1 | 1U << 8;
  word_at(kTim2 + 0x20) = 1 | 1U << 4;
  word_at(kTim2 + 0x14) = 1;
  set(word_at(kTim2), 1);
  for (unsigned i = 0; i < 3; ++i) {
    while ((word_at(kTim6 + 0x10) & 1) == 0) {}
    word_at(kTim6 + 0x10) = ~1U;
    updates = updates + 1;
  }
  encoder = word_at(kTim2 + 0x24);
}

void ask_nobody() {
  constexpr std::uint32_t kSpi2 = 0x40003800, kI2c2 = 0x40005800;
  rcc::enable(rcc::kApb1, 14);
  gpio::alternate('B', 13, 5);
  gpio::alternate('B', 14, 5);
  gpio::alternate('B', 15, 5);
  clear(word_at(kSpi2), 1U << 6);
  word_at(kSpi2) = 1U << 2 | 1U << 8 | 1U << 9 | 5U << 3;
  word_at(kSpi2 + 4) = 0;
  clear(word_at(kSpi2 + 0x1C), 1U << 11);
  set(word_at(kSpi2), 1U << 6);
  word_at(kSpi2 + 0x0C) = 0x80;
  while ((word_at(kSpi2 + 8) & 1) == 0) {}
  spi_answer = word_at(kSpi2 + 0x0C);
  rcc::enable(rcc::kApb1, 22);
  gpio::alternate('F', 0, 4);
  gpio::alternate('F', 1, 4);
  set(word_at(gpio::base('F') + 4), 3);
  set(word_at(kI2c2), 1U << 15);
  clear(word_at(kI2c2), 1U << 15);
  change(word_at(kI2c2 + 4), 0x3F, 42);
  word_at(kI2c2 + 0x20) = 43;
  word_at(kI2c2 + 0x1C) = 210;
  word_at(kI2c2 + 8) = 0x4000;
  set(word_at(kI2c2), 1);
  set(word_at(kI2c2), 1U << 8);
  while ((word_at(kI2c2 + 0x14) & 1) == 0) {}
  word_at(kI2c2 + 0x10) = 0xA0;
  while ((word_at(kI2c2 + 0x14) & (1U << 10 | 2)) == 0) {}
  i2c_absent = word_at(kI2c2 + 0x14) >> 10 & 1;
  set(word_at(kI2c2), 1U << 9);
  word_at(kI2c2 + 0x14) = ~(1U << 10) & 0xDF00;
}

/// USB_CoreInit, USB_SetCurrentMode, USB_DevInit and the soft connect.
void wait_for_cable() {
  constexpr std::uint32_t kUsb = 0x50000000, kDevice = kUsb + 0x800;
  rcc::enable(rcc::kAhb2, 7);
  gpio::alternate('A', 11, 10);
  gpio::alternate('A', 12, 10);
  clear(word_at(kUsb + 8), 1);
  set(word_at(kUsb + 0x0C), 1U << 6);
  while ((word_at(kUsb + 0x10) & 1U << 31) == 0) {}
  set(word_at(kUsb + 0x10), 1);
  while ((word_at(kUsb + 0x10) & 1) != 0) {}
  set(word_at(kUsb + 0x38), 1U << 16);
  clear(word_at(kUsb + 0x0C), 3U << 29);
  set(word_at(kUsb + 0x0C), 1U << 30);
  while ((word_at(kUsb + 0x14) & 1) != 0) {}
  set(word_at(kUsb + 0x38), 1U << 21);
  word_at(kUsb + 0xE00) = 0;
  set(word_at(kDevice), 3);
  word_at(kUsb + 0x10) = 1U << 5 | 0x10U << 6;
  while ((word_at(kUsb + 0x10) & 1U << 5) != 0) {}
  word_at(kUsb + 0x10) = 1U << 4;
  while ((word_at(kUsb + 0x10) & 1U << 4) != 0) {}
  word_at(kDevice + 0x10) = 0;
  word_at(kDevice + 0x14) = 0;
  word_at(kDevice + 0x1C) = 0;
  for (unsigned i = 0; i < 4; ++i) {
    word_at(kUsb + 0x900 + 0x20 * i) = (word_at(kUsb + 0x900 + 0x20 * i) & 1U << 31) != 0 ? 1U << 30 | 1U << 27 : 0;
    word_at(kUsb + 0x910 + 0x20 * i) = 0;
    word_at(kUsb + 0x908 + 0x20 * i) = 0xFB7F;
  }
  word_at(kUsb + 0x18) = 0;
  word_at(kUsb + 0x14) = 0xBFFFFFFF;
  set(word_at(kUsb + 0x18), 0x803C3810 | 1U << 30 | 4);
  word_at(kUsb + 0x24) = 0x80;
  word_at(kUsb + 0x28) = 0x40U << 16 | 0x80;
  word_at(kUsb + 0x104) = 0x80U << 16 | 0xC0;
  clear(word_at(kDevice + 4), 2);
  set(word_at(kUsb + 8), 1);
  usb_interrupts = word_at(kUsb + 0x14) & word_at(kUsb + 0x18) & 0x1000;  // a reset by the host
}

void start_watchdog() {
  word_at(0x40003000) = 0xCCCC;
  word_at(0x40003000) = 0x5555;
  word_at(0x40003004) = 4;
  word_at(0x40003008) = 4095;
  while (word_at(0x4000300C) != 0) {}
  word_at(0x40003000) = 0xAAAA;
}

}  // namespace

extern "C" volatile std::uint32_t laps;
volatile std::uint32_t laps;

int main() {
  start_clocks();
  start_calendar();
  draw_numbers();
  sum_up();
  convert();
  put_out();
  count();
  ask_nobody();
  wait_for_cable();
  start_watchdog();
  for (;;) {
    word_at(0x40003000) = 0xAAAA;
    laps = laps + 1;
  }
}
