// The core's own registers that the runtime uses (PM0214 rev 10; section numbers beside each).
#pragma once

#include <cstdint>

namespace finemote::cortex_m4 {

/// A register at a fixed address. Stateless, so that it works before any constructor has run.
template <std::uintptr_t Address, class Word = std::uint32_t>
struct Register {
  static Word read() { return *reinterpret_cast<volatile Word*>(Address); }
  static void write(Word value) { *reinterpret_cast<volatile Word*>(Address) = value; }
  static void set(Word bits) { write(static_cast<Word>(read() | bits)); }
};

constexpr std::uint32_t bit(unsigned n) { return std::uint32_t{1} << n; }

namespace systick {  // 4.5
using Control = Register<0xE000E010>;
using Reload = Register<0xE000E014>;
using Value = Register<0xE000E018>;
constexpr std::uint32_t kEnable = bit(0), kInterrupt = bit(1), kCoreClock = bit(2);
constexpr std::uint32_t kMaxInterval = 1U << 24;
}  // namespace systick

namespace scb {                                 // 4.4
using InterruptControl = Register<0xE000ED04>;  // 4.4.3
constexpr std::uint32_t kSysTickPending = bit(26), kClearSysTick = bit(25), kClearPendSv = bit(27);
using VectorTable = Register<0xE000ED08>;   // 4.4.4
using ResetControl = Register<0xE000ED0C>;  // 4.4.5
constexpr std::uint32_t kResetKey = 0x05FA0000, kSystemReset = bit(2), kPriorityGroupMask = 7U << 8;
using HandlerControl = Register<0xE000ED24>;  // 4.4.9
constexpr std::uint32_t kMemoryFault = bit(16), kBusFault = bit(17), kUsageFault = bit(18);
using FaultStatus = Register<0xE000ED28>;         // 4.4.10
using HardFaultStatus = Register<0xE000ED2C>;     // 4.4.14
using MemoryFaultAddress = Register<0xE000ED34>;  // 4.4.15
using BusFaultAddress = Register<0xE000ED38>;     // 4.4.16
using CoprocessorAccess = Register<0xE000ED88>;   // 4.6.1
constexpr std::uint32_t kFpuFullAccess = 0xFU << 20;

/// Priority of a system handler, exception number 4..15: 4.4.8.
inline void set_priority(unsigned exception, std::uint8_t level) {
  *reinterpret_cast<volatile std::uint8_t*>(0xE000ED18U + exception - 4) = static_cast<std::uint8_t>(level << 4);
}
}  // namespace scb

namespace nvic {                                              // 4.3; `word` is line / 32
constexpr unsigned kLines = 82, kWords = (kLines + 31) / 32;  // of the STM32F405/407: RM0090 12.2
inline void enable(unsigned line) {
  *reinterpret_cast<volatile std::uint32_t*>(0xE000E100U + 4 * (line / 32)) = bit(line % 32);
}
inline void disable(unsigned line) {  // 4.3.3
  *reinterpret_cast<volatile std::uint32_t*>(0xE000E180U + 4 * (line / 32)) = bit(line % 32);
}
inline void clear_pending(unsigned line) {  // 4.3.5
  *reinterpret_cast<volatile std::uint32_t*>(0xE000E280U + 4 * (line / 32)) = bit(line % 32);
}
inline void disable_all() {
  for (unsigned word = 0; word < kWords; ++word) {
    *reinterpret_cast<volatile std::uint32_t*>(0xE000E180U + 4 * word) = UINT32_MAX;
    *reinterpret_cast<volatile std::uint32_t*>(0xE000E280U + 4 * word) = UINT32_MAX;
  }
}
inline volatile std::uint32_t& set_pending(unsigned word) {
  return *reinterpret_cast<volatile std::uint32_t*>(0xE000E200U + 4 * word);
}
inline volatile std::uint32_t& active(unsigned word) {
  return *reinterpret_cast<volatile std::uint32_t*>(0xE000E300U + 4 * word);
}
inline void set_priority(unsigned line, std::uint8_t level) {
  *reinterpret_cast<volatile std::uint8_t*>(0xE000E400U + line) = static_cast<std::uint8_t>(level << 4);
}
}  // namespace nvic

namespace mpu {  // 4.2
using Control = Register<0xE000ED94>;
constexpr std::uint32_t kEnable = bit(0), kBackground = bit(2);
using Number = Register<0xE000ED98>;
using Base = Register<0xE000ED9C>;
using Attributes = Register<0xE000EDA0>;
/// Of a region's attributes, 4.2.10; the size, the power of two of its bytes less 1, stands from bit 1 on.
constexpr std::uint32_t kNormal = bit(17), kReadWrite = 3U << 24, kReadOnly = 5U << 24, kExecuteNever = bit(28);

/// Turns region 0..7 on. `base` is a multiple of its size.
inline void set_region(std::uint32_t number, std::uint32_t base, std::uint32_t attributes) {
  Number::write(number);
  Base::write(base);
  Attributes::write(attributes | 1U);
}
}  // namespace mpu

inline void barrier() { asm volatile("dsb\n\tisb" : : : "memory"); }

/// Masks every exception at `level` and below it (BASEPRI, 2.1.3); more urgent ones stay.
inline void mask_from(std::uint8_t level) {
  asm volatile("msr basepri, %0\n\tisb" : : "r"(static_cast<std::uint32_t>(level) << 4) : "memory");
}

/// Lets every exception in: PRIMASK, FAULTMASK and BASEPRI as after a reset, 2.1.3.
inline void unmask_all() {
  mask_from(0);
  asm volatile("cpsie f\n\tcpsie i" : : : "memory");
}

inline std::uint32_t exception_number() {
  std::uint32_t number;
  asm volatile("mrs %0, ipsr" : "=r"(number));
  return number;
}

}  // namespace finemote::cortex_m4
