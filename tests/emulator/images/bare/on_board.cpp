// The board's compass and IMU as ST's HAL talks to them, by polling: HAL_I2C_Mem_Write and _Mem_Read of one, two, three
// and six bytes, HAL_SPI_TransmitReceive byte by byte with the chip selects as pins. RM0090 27.3.3, 28.3.7; data sheets
// of IST8310 and BMI088.
#include <cstdint>
#include <initializer_list>

#include "clocks.hpp"
#include "registers.hpp"

extern "C" {
volatile std::uint32_t compass_identity, compass_pair, compass_three, ready_edges, rounds;
volatile std::uint32_t accelerometer_identity, gyroscope_identity, timeouts;
std::uint8_t field[6], rates[6], acceleration[6];
}

namespace {

constexpr std::uint8_t kCompass = 0x0E << 1;

void delay(std::uint32_t ms) {
  for (const std::uint32_t begin = ticks; ticks - begin < ms;) {}
}

void wait_for(std::uint32_t where, std::uint32_t mask, std::uint32_t value) {
  const std::uint32_t begin = ticks;
  while ((word_at(where) & mask) != value) {
    if (ticks - begin < 25) continue;
    timeouts = timeouts + 1;
    return;
  }
}

namespace i2c {

constexpr std::uint32_t kBase = 0x40005C00, kCr1 = kBase, kDr = kBase + 0x10, kSr1 = kBase + 0x14, kSr2 = kBase + 0x18;
constexpr std::uint32_t kStart = 1U << 8, kStop = 1U << 9, kAck = 1U << 10, kPos = 1U << 11;
constexpr std::uint32_t kSb = 1, kAddr = 2, kBtf = 4, kRxne = 1U << 6, kTxe = 1U << 7, kBusy = 2;

void set_up() {
  gpio::alternate('A', 8, 4);
  gpio::alternate('C', 9, 4);
  set(word_at(gpio::base('A') + 4), 1U << 8);
  set(word_at(gpio::base('C') + 4), 1U << 9);
  rcc::enable(rcc::kApb1, 23);
  clear(word_at(kCr1), 1);
  set(word_at(kCr1), 1U << 15);
  clear(word_at(kCr1), 1U << 15);
  change(word_at(kBase + 0x04), 0x3F, 42);
  change(word_at(kBase + 0x20), 0x3F, 13);
  change(word_at(kBase + 0x1C), 0xCFFF, 1U << 15 | 35);  // 400 kHz
  change(word_at(kCr1), 0xC0, 0);
  change(word_at(kBase + 0x08), 0xC3FF, 0x4000);
  change(word_at(kBase + 0x0C), 0xFF, 0);
  set(word_at(kCr1), 1);
}

void address(std::uint8_t byte) {
  wait_for(kSr1, kSb, kSb);
  word_at(kDr) = byte;
  wait_for(kSr1, kAddr, kAddr);
}

void clear_address() {
  touch(kSr1);
  touch(kSr2);
}

void begin(std::uint8_t where) {
  wait_for(kSr2, kBusy, 0);
  clear(word_at(kCr1), kPos);
  set(word_at(kCr1), kAck);
  set(word_at(kCr1), kStart);
  address(kCompass);
  clear_address();
  wait_for(kSr1, kTxe, kTxe);
  word_at(kDr) = where;
  wait_for(kSr1, kTxe, kTxe);
}

void write(std::uint8_t where, std::uint8_t value) {
  begin(where);
  word_at(kDr) = value;
  wait_for(kSr1, kBtf, kBtf);
  set(word_at(kCr1), kStop);
}

/// The last three bytes of a longer read.
void read_last_three(std::uint8_t* to) {
  wait_for(kSr1, kBtf, kBtf);
  clear(word_at(kCr1), kAck);
  asm volatile("cpsid i" ::: "memory");
  to[0] = static_cast<std::uint8_t>(word_at(kDr));
  wait_for(kSr1, kBtf, kBtf);
  set(word_at(kCr1), kStop);
  to[1] = static_cast<std::uint8_t>(word_at(kDr));
  asm volatile("cpsie i" ::: "memory");
  wait_for(kSr1, kRxne, kRxne);
  to[2] = static_cast<std::uint8_t>(word_at(kDr));
}

void read_two(std::uint8_t* to) {
  clear(word_at(kCr1), kAck);
  set(word_at(kCr1), kPos);
  asm volatile("cpsid i" ::: "memory");
  clear_address();
  clear(word_at(kCr1), kAck);
  asm volatile("cpsie i" ::: "memory");
  wait_for(kSr1, kBtf, kBtf);
  asm volatile("cpsid i" ::: "memory");
  set(word_at(kCr1), kStop);
  to[0] = static_cast<std::uint8_t>(word_at(kDr));
  asm volatile("cpsie i" ::: "memory");
  to[1] = static_cast<std::uint8_t>(word_at(kDr));
}

void read(std::uint8_t where, std::uint8_t* to, unsigned size) {
  begin(where);
  set(word_at(kCr1), kStart);
  address(kCompass | 1);
  if (size == 1) {
    clear(word_at(kCr1), kAck);
    asm volatile("cpsid i" ::: "memory");
    clear_address();
    set(word_at(kCr1), kStop);
    asm volatile("cpsie i" ::: "memory");
    wait_for(kSr1, kRxne, kRxne);
    to[0] = static_cast<std::uint8_t>(word_at(kDr));
    return;
  }
  if (size == 2) return read_two(to);
  clear_address();
  for (; size > 3; --size) {
    wait_for(kSr1, kRxne, kRxne);
    *to++ = static_cast<std::uint8_t>(word_at(kDr));
    if ((word_at(kSr1) & kBtf) == 0 || size == 4) continue;
    *to++ = static_cast<std::uint8_t>(word_at(kDr));
    --size;
  }
  read_last_three(to);
}

}  // namespace i2c

namespace spi {

constexpr std::uint32_t kBase = 0x40013000, kSr = kBase + 0x08, kDr = kBase + 0x0C;

void put_out(char port, unsigned pin) {
  word_at(gpio::base(port) + 0x18) = 1U << pin;
  change(word_at(gpio::base(port)), 3U << (2 * pin), 1U << (2 * pin));
}

void set_up() {
  gpio::alternate('B', 3, 5);
  gpio::alternate('B', 4, 5);
  gpio::alternate('A', 7, 5);
  put_out('A', 4);
  put_out('B', 0);
  rcc::enable(rcc::kApb2, 12);
  clear(word_at(kBase), 1U << 6);
  word_at(kBase) = 1U << 2 | 3 | 1U << 9 | 1U << 8 | 3U << 3;  // mode 3, 84 MHz / 16
  word_at(kBase + 0x04) = 0;
  word_at(kBase + 0x10) = 10;
  clear(word_at(kBase + 0x1C), 1U << 11);
}

std::uint8_t exchange(std::uint8_t byte) {
  if ((word_at(kBase) & 1U << 6) == 0) set(word_at(kBase), 1U << 6);
  *reinterpret_cast<volatile std::uint8_t*>(kDr) = byte;
  wait_for(kSr, 1, 1);
  const std::uint8_t answer = byte_at(kDr);
  wait_for(kSr, 1U << 7, 0);
  return answer;
}

struct Chip {
  char port;
  unsigned pin, dummies;
};
constexpr Chip kAccelerometer{'A', 4, 1}, kGyroscope{'B', 0, 0};

void select(const Chip& chip, bool on) {
  word_at(gpio::base(chip.port) + 0x18) = on ? 1U << (chip.pin + 16) : 1U << chip.pin;
}

void read(const Chip& chip, std::uint8_t where, std::uint8_t* to, unsigned size) {
  select(chip, true);
  exchange(where | 0x80);
  for (unsigned i = 0; i < chip.dummies; ++i) exchange(0x55);
  for (unsigned i = 0; i < size; ++i) to[i] = exchange(0x55);
  select(chip, false);
}

void write(const Chip& chip, std::uint8_t where, std::uint8_t value) {
  select(chip, true);
  exchange(where);
  exchange(value);
  select(chip, false);
}

}  // namespace spi

void start_imu() {
  std::uint8_t identity = 0;
  spi::read(spi::kAccelerometer, 0x00, &identity, 1);  // turns it to SPI
  delay(1);
  spi::write(spi::kAccelerometer, 0x7E, 0xB6);
  delay(80);
  spi::read(spi::kAccelerometer, 0x00, &identity, 1);
  delay(1);
  spi::read(spi::kAccelerometer, 0x00, &identity, 1);
  accelerometer_identity = identity;
  spi::write(spi::kAccelerometer, 0x7D, 0x04);
  delay(1);
  spi::write(spi::kAccelerometer, 0x7C, 0x00);
  delay(1);
  spi::write(spi::kGyroscope, 0x14, 0xB6);
  delay(80);
  spi::read(spi::kGyroscope, 0x00, &identity, 1);
  gyroscope_identity = identity;
}

void start_compass() {
  spi::put_out('G', 6);
  word_at(gpio::base('G') + 0x18) = 1U << 22;
  delay(50);
  word_at(gpio::base('G') + 0x18) = 1U << 6;
  delay(50);
  std::uint8_t bytes[3];
  i2c::read(0x00, bytes, 1);
  compass_identity = bytes[0];
  i2c::write(0x0B, 0x08);  // data ready, low
  i2c::write(0x41, 0x09);
  i2c::write(0x42, 0xC0);
  i2c::write(0x0A, 0x0B);
  i2c::read(0x0A, bytes, 2);
  compass_pair = bytes[0] | static_cast<std::uint32_t>(bytes[1]) << 8;
  i2c::read(0x0A, bytes, 3);
  compass_three = bytes[0] | static_cast<std::uint32_t>(bytes[1]) << 8;
}

}  // namespace

int main() {
  start_clocks();
  for (const char port : {'A', 'B', 'C', 'G'}) rcc::enable(rcc::kAhb1, static_cast<unsigned>(port - 'A'));
  spi::set_up();
  i2c::set_up();
  start_imu();
  start_compass();
  bool was_ready = false;
  for (;;) {
    const bool ready = (word_at(gpio::base('G') + 0x10) & 1U << 3) == 0;
    if (ready && !was_ready) {
      ready_edges = ready_edges + 1;
      i2c::read(0x03, field, sizeof field);
    }
    was_ready = ready;
    spi::read(spi::kGyroscope, 0x02, rates, sizeof rates);
    spi::read(spi::kAccelerometer, 0x12, acceleration, sizeof acceleration);
    rounds = rounds + 1;
  }
}
