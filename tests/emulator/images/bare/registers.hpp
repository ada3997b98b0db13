// Registers of the chip by their addresses: RM0090 2.3, PM0214 2.2.
#pragma once

#include <cstdint>

using Register = volatile std::uint32_t&;

inline Register word_at(std::uint32_t address) { return *reinterpret_cast<volatile std::uint32_t*>(address); }
inline volatile std::uint8_t& byte_at(std::uint32_t address) {
  return *reinterpret_cast<volatile std::uint8_t*>(address);
}

/// Reads a register for what reading does.
inline std::uint32_t touch(std::uint32_t address) { return word_at(address); }

/// The word that stands for one bit of a peripheral's register: PM0214 2.2.5.
inline Register bit_at(std::uint32_t address, unsigned bit) {
  return word_at(0x42000000 + (address - 0x40000000) * 32 + bit * 4);
}

inline void set(Register where, std::uint32_t bits) { where = where | bits; }
inline void clear(Register where, std::uint32_t bits) { where = where & ~bits; }
inline void change(Register where, std::uint32_t mask, std::uint32_t bits) { where = (where & ~mask) | bits; }

namespace rcc {
constexpr std::uint32_t kBase = 0x40023800, kCr = kBase, kPllCfgr = kBase + 0x04, kCfgr = kBase + 0x08,
                        kAhb1 = kBase + 0x30, kAhb2 = kBase + 0x34, kApb1 = kBase + 0x40, kApb2 = kBase + 0x44,
                        kBdcr = kBase + 0x70, kCsr = kBase + 0x74;

/// Turns a clock on and, as RM0090 7.3.10 wants before the first access, reads it back.
inline void enable(std::uint32_t which, unsigned bit) {
  set(word_at(which), 1U << bit);
  touch(which);
}
}  // namespace rcc

namespace gpio {
constexpr std::uint32_t base(char port) { return 0x40020000 + 0x400 * static_cast<std::uint32_t>(port - 'A'); }

/// An alternate function, fast, with the pull-up: the registers in the order ST's HAL writes them.
inline void alternate(char port, unsigned pin, std::uint32_t function) {
  rcc::enable(rcc::kAhb1, static_cast<unsigned>(port - 'A'));
  change(word_at(base(port) + 0x08), 3U << (2 * pin), 3U << (2 * pin));
  clear(word_at(base(port) + 0x04), 1U << pin);
  change(word_at(base(port) + 0x0C), 3U << (2 * pin), 1U << (2 * pin));
  change(word_at(base(port) + 0x20 + 4 * (pin / 8)), 0xFU << (4 * (pin % 8)), function << (4 * (pin % 8)));
  change(word_at(base(port)), 3U << (2 * pin), 2U << (2 * pin));
}
}  // namespace gpio

namespace nvic {
inline void priority(unsigned line, unsigned level) {
  byte_at(0xE000E400 + line) = static_cast<std::uint8_t>(level << 4);
}
inline void enable(unsigned line) { word_at(0xE000E100 + 4 * (line / 32)) = 1U << (line % 32); }
}  // namespace nvic
