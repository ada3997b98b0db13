// Code in SRAM (board param `code`): what runs in flash before it, and what guards it afterwards. Empty where the code
// stays in flash.
#ifdef FINEMOTE_CODE_IN_SRAM
#include <cstdint>

#include "finemote/fault.hpp"
#include "runtime/chips/cortex_m4/fault.hpp"
#include "runtime/chips/cortex_m4/registers.hpp"
#include "runtime/chips/stm32f4/registers/clock.hpp"
#include "runtime/chips/stm32f4/registers/crc.hpp"
#include "runtime/chips/stm32f4/registers/gpio.hpp"

extern "C" {
// Defined by sections_sram.ld: the code in flash, and where it is copied to. It is linked to run at 0.
extern const std::uint32_t _code_load;
extern std::uint32_t _code_copy, _code_copy_end, _stack_top;
[[noreturn]] void finemote_reset();
[[noreturn]] void finemote_boot();
[[noreturn]] void finemote_boot_copy();
[[noreturn]] void finemote_boot_fault();

struct BootVectors {
  std::uint32_t* stack;
  void (*core[15])();  // exception numbers 1..15
};
extern const BootVectors finemote_boot_vectors;
#define FINEMOTE_BOOT __attribute__((section(".boot"), used))
__attribute__((section(".boot_vectors"), used)) const BootVectors finemote_boot_vectors{
    &_stack_top,
    {finemote_boot, finemote_boot_fault, finemote_boot_fault, finemote_boot_fault, finemote_boot_fault,
     finemote_boot_fault, nullptr, nullptr, nullptr, nullptr, finemote_boot_fault, finemote_boot_fault, nullptr,
     finemote_boot_fault, finemote_boot_fault}};
}

namespace {

using namespace finemote;

/// Inlined into code in flash: nothing of what is copied may be called before it is checked.
#define FINEMOTE_INLINE __attribute__((always_inline)) inline

/// Copies the code and feeds it to the checksum unit, four words a turn: at 16 MHz this is most of the start.
FINEMOTE_INLINE void copy_words() {
  const std::uint32_t* from = &_code_load;
  std::uint32_t* to = &_code_copy;
  do {
    asm volatile(
        "ldmia %0!, {r4-r7}\n\t"
        "stmia %1!, {r4-r7}\n\t"
        "str r4, [%2]\n\tstr r5, [%2]\n\tstr r6, [%2]\n\tstr r7, [%2]"
        : "+r"(from), "+r"(to)
        : "r"(stm32f4::crc::dr.address())
        : "r4", "r5", "r6", "r7", "memory");
  } while (to != &_code_copy_end);
}

/// The same of the copy, which stays as it is.
FINEMOTE_INLINE void sum_copy() {
  const std::uint32_t* copied = &_code_copy;
  do {
    asm volatile(
        "ldmia %0!, {r4-r7}\n\t"
        "str r4, [%1]\n\tstr r5, [%1]\n\tstr r6, [%1]\n\tstr r7, [%1]"
        : "+r"(copied)
        : "r"(stm32f4::crc::dr.address())
        : "r4", "r5", "r6", "r7", "memory");
  } while (copied != &_code_copy_end);
}

/// Copies the code. @return  whether the sum of the copy is that of the original, as the checksum unit counts: RM0090 4
FINEMOTE_INLINE bool copy_code() {
  stm32f4::crc::cr.write(stm32f4::crc::kReset);
  copy_words();
  const std::uint32_t sum = stm32f4::crc::dr.read();
  stm32f4::crc::cr.write(stm32f4::crc::kReset);
  sum_copy();
  return stm32f4::crc::dr.read() == sum;
}

/// For the start that follows: it counts the fault, sets the safe outputs and releases nothing.
FINEMOTE_INLINE void note_bad_copy() {
  cortex_m4::last_fault.fault = CoreFault::code_copy;
  cortex_m4::last_fault.magic = cortex_m4::kFaultMagic;
}

}  // namespace

/// Where every reset begins, and a boot loader ends: with a stack that the copy does not overwrite.
extern "C" FINEMOTE_BOOT __attribute__((naked)) void finemote_boot() {
  asm volatile(
      "ldr r0, =_stack_top\n\t"
      "msr msp, r0\n\t"
      "movs r0, #0\n\t"
      "msr control, r0\n\t"
      "isb\n\t"
      "b finemote_boot_copy");
}

/// The flash's vectors count until the copy is right; it is made again until it is. Nothing interrupts meanwhile that
/// has no vector there.
extern "C" FINEMOTE_BOOT __attribute__((flatten, noinline)) void finemote_boot_copy() {
  cortex_m4::systick::Control::write(0);
  cortex_m4::nvic::disable_all();
  cortex_m4::mpu::Control::write(0);
  cortex_m4::scb::VectorTable::write(reinterpret_cast<std::uintptr_t>(&finemote_boot_vectors));
  stm32f4::rcc::enable(stm32f4::rcc::ahb1enr, stm32f4::rcc::kAhb1Crc);
  stm32f4::rcc::enable(stm32f4::rcc::apb2enr, stm32f4::rcc::kApb2Syscfg);
  while (!copy_code()) note_bad_copy();
  stm32f4::syscfg::memrmp.write(stm32f4::syscfg::kRamAtZero);
  static_cast<void>(stm32f4::syscfg::memrmp.read());
  cortex_m4::barrier();
  finemote_reset();
}

/// A fault before there is any code: the pins stay as the reset left them.
extern "C" FINEMOTE_BOOT void finemote_boot_fault() {
  for (;;) asm volatile("");
}

namespace finemote::cortex_m4 {

/// PM0214 4.2.9, 4.2.10: of several regions that cover an address the one with the highest number counts. Only SRAM1
/// through address 0 may be executed; SRAM1 is not written any more, at neither of its addresses. The last eighth of
/// 128 KiB is SRAM2, and at 0 nothing.
void protect_code() {
  constexpr std::uint32_t kHalfGib = 28U << 1, kRam = 16U << 1, kLastEighth = 0x80U << 8;
  mpu::set_region(0, 0x00000000, kHalfGib | mpu::kReadWrite | mpu::kExecuteNever | mpu::kNormal);
  mpu::set_region(1, 0x20000000, kHalfGib | mpu::kReadWrite | mpu::kExecuteNever | mpu::kNormal);
  mpu::set_region(2, 0x20000000, kRam | kLastEighth | mpu::kReadOnly | mpu::kExecuteNever | mpu::kNormal);
  mpu::set_region(3, 0x00000000, kRam | kLastEighth | mpu::kReadOnly | mpu::kNormal);
}

}  // namespace finemote::cortex_m4
#endif
