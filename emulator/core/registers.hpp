// The registers of the core as the interpreter keeps them: ARMv7-M Architecture Reference Manual B1.4 and A2.5.
#pragma once

#include <array>
#include <cstdint>
#include <utility>

namespace finemote::emulator {

struct Registers {
  std::array<std::uint32_t, 16> r{};  ///< r[13]: of the stack in use; r[15]: the instruction begun last, plus 4
  std::uint32_t next = 0;             ///< address of the instruction to run

  // Condition flags, taken apart: N is bit 31 of `n`, Z means `z` is 0, C is `c` (0 or 1), V is bit 31 of `v`.
  std::uint32_t n = 0, z = 1, c = 0, v = 0;
  std::uint32_t q = 0;   ///< 0 or 1
  std::uint32_t ge = 0;  ///< four bits
  std::uint32_t it = 0;  ///< IT state of the instruction to run; 0 outside a block

  std::uint32_t exception = 0;  ///< IPSR
  std::uint32_t primask = 0, basepri = 0, faultmask = 0, control = 0;
  bool exclusive = false;  ///< the local monitor

  std::array<std::uint32_t, 32> s{};  ///< floating-point registers, as bits
  std::uint32_t fpscr = 0;

  [[nodiscard]] std::uint32_t flags() const {
    return (n & 0x80000000U) | (z == 0 ? 1U << 30 : 0) | c << 29 | (v >> 31) << 28 | q << 27;
  }
  /// N and Z of a result.
  void set_nz(std::uint32_t result) { n = z = result; }
  void set_flags(std::uint32_t xpsr) {
    n = xpsr & 0x80000000U;
    z = (xpsr >> 30 & 1) ^ 1;
    c = xpsr >> 29 & 1;
    v = xpsr << 3 & 0x80000000U;
    q = xpsr >> 27 & 1;
  }
  /// Flags, IT state, Thumb bit, GE bits and exception number: B1.4.2.
  [[nodiscard]] std::uint32_t xpsr() const {
    return flags() | (it & 3) << 25 | (it >> 2) << 10 | 1U << 24 | ge << 16 | exception;
  }
  void set_xpsr(std::uint32_t value) {
    set_flags(value);
    it = (value >> 25 & 3) | (value >> 10 & 0x3F) << 2;
    ge = value >> 16 & 0xF;
    enter_mode(value & 0x1FF, control);
  }

  static constexpr std::uint32_t kProcessStack = 2;  ///< CONTROL.SPSEL
  /// Handler mode, or thread mode with CONTROL.SPSEL clear, uses the main stack.
  [[nodiscard]] bool on_process_stack() const { return exception == 0 && (control & kProcessStack) != 0; }
  /// In handler mode it says what thread mode will use.
  void choose_stack(bool process) {
    enter_mode(exception, process ? control | kProcessStack : control & ~kProcessStack);
  }
  void enter_mode(std::uint32_t new_exception, std::uint32_t new_control) {
    const bool was = on_process_stack();
    exception = new_exception;
    control = new_control;
    if (on_process_stack() != was) std::swap(r[13], other_stack_);
  }
  [[nodiscard]] std::uint32_t& main_stack() { return on_process_stack() ? other_stack_ : r[13]; }
  [[nodiscard]] std::uint32_t& process_stack() { return on_process_stack() ? r[13] : other_stack_; }

 private:
  std::uint32_t other_stack_ = 0;
};

}  // namespace finemote::emulator
