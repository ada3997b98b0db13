// Lengths, costs and flags of instructions: ARMv7-M Architecture Reference Manual A5, Cortex-M4 TRM table 3-1.
#include "emulator/core/instruction.hpp"
#include "catch.hpp"

using namespace finemote::emulator;

TEST_CASE("instructions are told apart") {
  struct Case {
    const char* text;
    unsigned first, second, cycles, flags, bytes;
  };
  using I = InstructionInfo;
  const Case cases[] = {
      {"nop", 0xBF00, 0, 1, 0, 2},
      {"wfi", 0xBF30, 0, 1, 0, 2},
      {"it eq", 0xBF08, 0, 1, 0, 2},
      {"push {r4, lr}", 0xB510, 0, 3, I::kMovesStack, 2},
      {"pop {r4, pc}", 0xBD10, 0, 3, 0, 2},
      {"sub sp, #16", 0xB084, 0, 1, I::kMovesStack, 2},
      {"cpsie i", 0xB662, 0, 2, 0, 2},
      {"cpsid i", 0xB672, 0, 2, 0, 2},
      {"adds r0, r1", 0x1840, 0, 1, 0, 2},
      {"ldr r0, [r1]", 0x6808, 0, 2, 0, 2},
      {"ldr r0, [pc, #4]", 0x4801, 0, 2, 0, 2},
      {"str r0, [sp, #4]", 0x9001, 0, 2, 0, 2},
      {"ldm r0!, {r1, r2}", 0xC806, 0, 3, 0, 2},
      {"push.w {r4-r8, lr}", 0xE92D, 0x41F0, 7, I::kMovesStack, 4},
      {"msr basepri, r0", 0xF380, 0x8811, 2, 0, 4},
      {"msr primask, r3", 0xF383, 0x8810, 2, 0, 4},
      {"dsb", 0xF3BF, 0x8F4F, 1, 0, 4},
      {"isb", 0xF3BF, 0x8F6F, 4, 0, 4},
      {"udiv r0, r1, r2", 0xFBB1, 0xF0F2, 12, 0, 4},
      {"mul r0, r1, r2", 0xFB01, 0xF002, 1, 0, 4},
      {"mla r0, r1, r2, r3", 0xFB01, 0x3002, 1, 0, 4},
      {"mrs r0, basepri", 0xF3EF, 0x8011, 2, 0, 4},
      {"vdiv.f32 s0, s1, s2", 0xEE80, 0x0A81, 14, I::kFloatingPoint, 4},
      {"vsqrt.f32 s0, s1", 0xEEB1, 0x0AE0, 14, I::kFloatingPoint, 4},
      {"vadd.f32 s0, s1, s2", 0xEE30, 0x0A81, 1, I::kFloatingPoint, 4},
      {"vmul.f32 s0, s1, s2", 0xEE20, 0x0A81, 1, I::kFloatingPoint, 4},
      {"vfma.f32 s0, s1, s2", 0xEEA0, 0x0A81, 3, I::kFloatingPoint, 4},
      {"vmov r0, s0", 0xEE10, 0x0A10, 2, I::kFloatingPoint, 4},
      {"vmov r0, r1, s0, s1", 0xEC51, 0x0A10, 2, I::kFloatingPoint, 4},
      {"vmrs apsr, fpscr", 0xEEF1, 0xFA10, 1, I::kFloatingPoint, 4},
      {"vldr s0, [r0]", 0xED90, 0x0A00, 2, I::kFloatingPoint, 4},
      {"vpush {s16-s17}", 0xED2D, 0x8A02, 3, I::kFloatingPoint | I::kMovesStack, 4},
      {"bl", 0xF000, 0xF800, 1, 0, 4},
  };
  for (const Case& it : cases) {
    const InstructionInfo info = decode(static_cast<std::uint16_t>(it.first), static_cast<std::uint16_t>(it.second));
    INFO(it.text);
    CHECK(unsigned{info.cycles} == it.cycles);
    CHECK(unsigned{info.flags} == it.flags);
    CHECK(unsigned{info.bytes} == it.bytes);
  }
}
