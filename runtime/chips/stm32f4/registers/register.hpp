// One memory-mapped register: an address that is known at compile time, read and written exactly as often as the code
// says.
#pragma once

#include <cstdint>

namespace finemote::stm32f4 {

/// A 32-bit register. Stateless and constant: usable before any constructor has run.
class Register {
 public:
  constexpr explicit Register(std::uint32_t address) : address_(address) {}

  [[nodiscard]] constexpr std::uint32_t address() const { return address_; }
  [[nodiscard]] std::uint32_t read() const { return *pointer(); }
  void write(std::uint32_t value) const { *pointer() = value; }
  void set(std::uint32_t bits) const { write(read() | bits); }
  void clear(std::uint32_t bits) const { write(read() & ~bits); }
  /// Replaces the bits of `mask` by those of `value`.
  void modify(std::uint32_t mask, std::uint32_t value) const { write((read() & ~mask) | value); }
  [[nodiscard]] bool any(std::uint32_t bits) const { return (read() & bits) != 0; }

 private:
  [[nodiscard]] volatile std::uint32_t* pointer() const { return reinterpret_cast<volatile std::uint32_t*>(address_); }

  std::uint32_t address_;
};

/// Bit `n` of a register.
constexpr std::uint32_t bit(unsigned n) { return std::uint32_t{1} << n; }

}  // namespace finemote::stm32f4
