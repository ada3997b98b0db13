#include "emulator/parts/ms5837.hpp"

#include <cmath>

namespace finemote::emulator {
namespace {

// Calibration of the data sheets' own examples.
constexpr Ms5837::Prom kProm02 = {0x0000, 46372, 43981, 29059, 27842, 31553, 28165};
constexpr Ms5837::Prom kProm30 = {0x0000, 34982, 36352, 20328, 22354, 26646, 26146};

// Longest conversion for oversampling 256, 512, ... 8192.
constexpr std::uint64_t kConversionNs[] = {600'000, 1'170'000, 2'280'000, 4'540'000, 9'040'000, 18'080'000};
constexpr std::uint64_t kResetNs = 10'000'000;

/// CRC-4 of the PROM by the polynomial division of application note AN520: x^4 + x + 1 over 16 bytes.
std::uint16_t crc4(std::array<std::uint16_t, 8> words) {
  words[0] &= 0x0FFF;
  words[7] = 0;
  unsigned remainder = 0;
  for (unsigned i = 0; i < 16; ++i) {
    remainder ^= i % 2 == 1 ? words[i / 2] & 0xFFU : words[i / 2] >> 8;
    for (unsigned bit = 0; bit < 8; ++bit)
      remainder = (remainder & 0x8000) != 0 ? (remainder << 1 ^ 0x3000) & 0xFFFF : remainder << 1;
  }
  return static_cast<std::uint16_t>(remainder >> 12 & 0xF);
}

}  // namespace

Ms5837::Ms5837(Variant variant, std::function<Time()> now, std::function<double(Time)> pressure)
    : variant_(variant), now_(std::move(now)), pressure_(std::move(pressure)) {
  calibrate(variant == Variant::k02BA ? kProm02 : kProm30);
}

void Ms5837::calibrate(const Prom& prom) {
  for (unsigned i = 0; i < 7; ++i) prom_[i] = prom[i];
  prom_[0] = static_cast<std::uint16_t>((prom_[0] & 0x0FFF) | crc4(prom_) << 12);
}

/// The inverse of the data sheet's compensation at 20.00 degrees, where dT and the second order are zero.
std::uint32_t Ms5837::raw_pressure(double pascal) const {
  const bool wide = variant_ == Variant::k30BA;
  const double sensitivity = prom_[1] * std::pow(2.0, wide ? 15 : 16),
               offset = prom_[2] * std::pow(2.0, wide ? 16 : 17);
  const double steps = wide ? pascal / 10 : pascal;  // 0.1 mbar or 0.01 mbar
  return static_cast<std::uint32_t>(
      std::llround((steps * std::pow(2.0, wide ? 13 : 15) + offset) * std::pow(2.0, 21) / sensitivity));
}

bool Ms5837::select(std::uint8_t address, bool) { return !dead && address == kAddress && now_() >= busy_until_; }

void Ms5837::answer(std::uint32_t value, unsigned bytes, Tag origin) {
  left_ = bytes;
  answered_ = origin;
  for (unsigned i = 0; i < bytes; ++i) answer_[i] = static_cast<std::uint8_t>(value >> (8 * (bytes - 1 - i)));
}

void Ms5837::convert(bool temperature, unsigned rate) {
  ++conversions_;
  converting_ = true;
  ready_ = now_() + from_ns(kConversionNs[rate]);
  result_ = temperature ? prom_[5] * 256U : raw_pressure(pressure_(now_()));
  converted_ = !temperature && on_sample ? on_sample(now_()) : Tag::none;
}

bool Ms5837::write(WireByte command) {
  if (command == 0x1E) {
    busy_until_ = now_() + from_ns(kResetNs);
    converting_ = false;
  } else if (command >= 0xA0 && command <= 0xAC && command % 2 == 0) {
    answer(prom_[(command - 0xA0U) / 2] ^ prom_damage, 2);
  } else if (command >= 0x40 && command <= 0x5A && command % 2 == 0) {
    const bool temperature = command >= 0x50;
    const unsigned rate = (command & 0x0FU) / 2;
    if (rate < 6) convert(temperature, rate);
  } else if (command == 0x00) {
    const bool done = converting_ && now_() >= ready_;
    if (!done) ++early_reads_;
    answer(done ? result_ : 0, 3, done ? converted_ : Tag::none);  // 0 when read before the end
    converting_ = false;
  }
  return true;
}

WireByte Ms5837::read() {
  if (left_ == 0) return 0xFF;
  const std::uint8_t byte = answer_[0];
  answer_[0] = answer_[1];
  answer_[1] = answer_[2];
  --left_;
  return {byte, answered_};
}

}  // namespace finemote::emulator
