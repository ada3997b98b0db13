// The vector table: core exceptions, then `finemote_line_N` for every interrupt line N of the STM32F405/407.
#include <cstdint>

#include "runtime/chips/cortex_m4/registers.hpp"

extern "C" {
extern std::uint32_t _stack_top;  // sections.ld
[[noreturn]] void finemote_reset();
void finemote_release();
void finemote_fault_entry();

// clang-format off
#define FINEMOTE_LINES(X) \
  X(0) X(1) X(2) X(3) X(4) X(5) X(6) X(7) X(8) X(9) X(10) X(11) X(12) X(13) X(14) X(15) X(16) X(17) X(18) X(19) \
  X(20) X(21) X(22) X(23) X(24) X(25) X(26) X(27) X(28) X(29) X(30) X(31) X(32) X(33) X(34) X(35) X(36) X(37) X(38) \
  X(39) X(40) X(41) X(42) X(43) X(44) X(45) X(46) X(47) X(48) X(49) X(50) X(51) X(52) X(53) X(54) X(55) X(56) X(57) \
  X(58) X(59) X(60) X(61) X(62) X(63) X(64) X(65) X(66) X(67) X(68) X(69) X(70) X(71) X(72) X(73) X(74) X(75) X(76) \
  X(77) X(78) X(79) X(80) X(81)
// clang-format on

// A line that no bus and no bucket claims ends in the unexpected-interrupt fault.
#define FINEMOTE_DECLARE(n) __attribute__((weak, nothrow, alias("finemote_unexpected_line"))) void finemote_line_##n();
void finemote_unexpected_line();
__attribute__((naked)) void finemote_unexpected_line() { asm volatile("b finemote_fault_entry"); }
FINEMOTE_LINES(FINEMOTE_DECLARE)
#undef FINEMOTE_DECLARE

struct VectorTable {
  std::uint32_t* stack;
  void (*core[15])();                                  // exception numbers 1..15
  void (*lines[finemote::cortex_m4::nvic::kLines])();  // exception numbers 16..97
};

#define FINEMOTE_ENTRY(n) finemote_line_##n,
extern const VectorTable finemote_vectors;
__attribute__((section(".vectors"), used)) const VectorTable finemote_vectors{
    &_stack_top,
    {finemote_reset, finemote_fault_entry, finemote_fault_entry, finemote_fault_entry, finemote_fault_entry,
     finemote_fault_entry, nullptr, nullptr, nullptr, nullptr, finemote_fault_entry, finemote_fault_entry, nullptr,
     finemote_fault_entry, finemote_release},
    {FINEMOTE_LINES(FINEMOTE_ENTRY)}};
#undef FINEMOTE_ENTRY
}
