#include "pulse_board.hpp"

#include "i2c_master.hpp"

namespace baseline {

namespace {

using finemote::Pca9685;

constexpr std::uint8_t kMux = 0x70, kMuxChannel = 4, kPart = 0x40;
// Registers and bits of MODE1, data sheet tables 4 and 5. Its common address stays off: 0x70 is the multiplexer's.
constexpr std::uint8_t kMode1 = 0x00, kLed0 = 0x06, kPrescale = 0xFE;
constexpr std::uint8_t kRestart = 0x80, kAutoIncrement = 0x20, kSleep = 0x10;
constexpr Pca9685::Config kConfig{};
constexpr std::uint32_t kCountsPerNs = Pca9685::counts_per_ns(kConfig);  // of 2^32

bool write_register(std::uint8_t address, std::uint8_t value) {
  const std::uint8_t bytes[] = {address, value};
  return write_i2c(kPart, bytes, sizeof bytes);
}

}  // namespace

bool PulseBoard::select() const {
  const auto byte = static_cast<std::uint8_t>(1U << kMuxChannel);
  return write_i2c(kMux, &byte, 1);
}

void PulseBoard::start(std::uint32_t neutral) {
  for (std::uint8_t channel = 0; channel < kThrusters; ++channel) set(channel, neutral);
  select();
  write_register(kMode1, kSleep | kAutoIncrement);
  write_register(kPrescale, Pca9685::prescale(kConfig));
  write_register(kMode1, kAutoIncrement);
  wait_at_start(500 * finemote::kMicrosecond);
  write_register(kMode1, kRestart | kAutoIncrement);
  write_all();
}

void PulseBoard::put(std::uint8_t* registers, std::uint8_t channel) const {
  const std::uint64_t ticks =
      (std::uint64_t{channel_[channel].pulse.load()} * kCountsPerNs + (std::uint64_t{1} << 31)) >> 32;
  registers[0] = registers[1] = 0;
  registers[2] = static_cast<std::uint8_t>(ticks & 0xFF);
  registers[3] = static_cast<std::uint8_t>(ticks >> 8 & 0x0F);
}

void PulseBoard::write_registers(std::uint8_t channel) const {
  std::uint8_t registers[4];
  put(registers, channel);
  for (std::uint8_t i = 0; i < 4; ++i) write_register(static_cast<std::uint8_t>(kLed0 + 4 * channel + i), registers[i]);
}

bool PulseBoard::write_channel(std::uint8_t channel) const {
  std::uint8_t bytes[5] = {static_cast<std::uint8_t>(kLed0 + 4 * channel)};
  put(bytes + 1, channel);
  return write_i2c(kPart, bytes, sizeof bytes);
}

bool PulseBoard::write_all() const {
  std::uint8_t bytes[1 + 4 * kThrusters] = {kLed0};
  for (std::uint8_t channel = 0; channel < kThrusters; ++channel) put(bytes + 1 + 4 * channel, channel);
  return write_i2c(kPart, bytes, sizeof bytes);
}

}  // namespace baseline
