#include "emulator/core/instruction.hpp"

#include <bit>

namespace finemote::emulator {
namespace {

using Info = InstructionInfo;

unsigned count(unsigned bits) { return static_cast<unsigned>(std::popcount(bits)); }

Info info(unsigned cycles, unsigned flags, unsigned bytes) {
  return Info{static_cast<std::uint8_t>(cycles), static_cast<std::uint8_t>(flags), static_cast<std::uint8_t>(bytes)};
}

/// ARMv7-M Architecture Reference Manual A5.2.
Info decode16(unsigned op) {
  if ((op & 0xFE00) == 0xB400) return info(1 + count(op & 0x1FF), Info::kMovesStack, 2);  // PUSH
  if ((op & 0xFE00) == 0xBC00) return info(1 + count(op & 0x1FF), 0, 2);                  // POP
  if ((op & 0xFF80) == 0xB080) return info(1, Info::kMovesStack, 2);                      // SUB SP
  if ((op & 0xF000) == 0xC000) return info(1 + count(op & 0xFF), 0, 2);                   // LDM, STM
  if ((op & 0xFF87) == 0x4685) return info(1, Info::kMovesStack, 2);                      // MOV SP, Rm
  const bool load_store = (op & 0xF000) == 0x5000 || (op & 0xE000) == 0x6000 || (op & 0xF000) == 0x8000 ||
                          (op & 0xF000) == 0x9000 || (op & 0xF800) == 0x4800;
  if ((op & 0xFFE8) == 0xB660) return info(2, 0, 2);  // CPS
  return info(load_store ? 2 : 1, 0, 2);
}

/// Floating point, A6.4 to A6.6; the caller has seen a coprocessor 10 or 11 instruction.
Info decode_fp(unsigned first, unsigned second) {
  const unsigned fp = Info::kFloatingPoint;
  if ((first & 0xFE00) == 0xEC00 && (first & 0xFFE0) != 0xEC40) {  // loads and stores
    const bool single = (first & 0x0120) == 0x0100;                // VLDR, VSTR: P = 1, W = 0
    const bool push = (first & 0xFFBF) == 0xED2D;                  // VPUSH: VSTMDB SP!
    if (single) return info((second & 0x0100) != 0 ? 3 : 2, fp, 4);
    return info(1 + (second & 0xFF), fp | (push ? Info::kMovesStack : 0U), 4);
  }
  if ((first & 0xFF00) == 0xEE00 && (second & 0x0010) == 0) {  // data processing, table A6-2
    const unsigned operation = (first >> 4) & 0xB;
    if (operation == 0x8) return info(14, fp, 4);                                                   // VDIV
    if (operation == 0xB && (first & 0xF) == 1 && (second & 0xC0) == 0xC0) return info(14, fp, 4);  // VSQRT
    const bool accumulate = operation <= 1 || operation == 0x9 || operation == 0xA;                 // VMLA and family
    return info(accumulate ? 3 : 1, fp, 4);
  }
  const bool status = (first & 0xFFEF) == 0xEEE1 && (second & 0x0FFF) == 0x0A10;  // VMRS, VMSR
  return info(status ? 1 : 2, fp, 4);                                             // VMOV from or to core registers
}

/// ARMv7-M Architecture Reference Manual A5.3.
Info decode32(unsigned first, unsigned second) {
  if ((first & 0xEE00) == 0xEC00 || (first & 0xEF00) == 0xEE00) {
    const unsigned coprocessor = (second >> 8) & 0xF;
    if (coprocessor == 10 || coprocessor == 11) return decode_fp(first, second);
  }
  if ((first & 0xFE40) == 0xE800) {  // LDM, STM, PUSH.W, POP.W
    const bool push = first == 0xE92D;
    return info(1 + count(second), push ? Info::kMovesStack : 0U, 4);
  }
  if ((first & 0xFE40) == 0xE840) {  // LDRD, STRD, exclusives, TBB
    if ((first & 0xFFF0) == 0xE8D0 && (second & 0xFFE0) == 0xF000) return info(3, 0, 4);
    const bool exclusive = (first & 0xFF60) == 0xE840;
    return info(exclusive ? 2 : 3, 0, 4);
  }
  if ((first & 0xFE00) == 0xF800) {                                    // loads and stores of one item
    const bool push = first == 0xF84D && (second & 0x0F00) == 0x0D00;  // STR Rt, [SP, #-4]!
    return info(2, push ? Info::kMovesStack : 0U, 4);
  }
  if ((first & 0xFFD0) == 0xFB90) return info(12, 0, 4);                                     // SDIV, UDIV: 2 to 12
  if ((first & 0xFFE0) == 0xF380 && (second & 0xD000) == 0x8000) return info(2, 0, 4);       // MSR
  if ((first & 0xFFE0) == 0xF3E0 && (second & 0xD000) == 0x8000) return info(2, 0, 4);       // MRS
  if (first == 0xF3BF && (second & 0xFFF0) == 0x8F60) return info(1 + kRefillCycles, 0, 4);  // ISB fetches anew
  const bool sub_sp = (first & 0xFBEF) == 0xF1AD || (first & 0xFBFF) == 0xF2AD;              // SUB.W SP, SP, #
  if (sub_sp && (second & 0x0F00) == 0x0D00) return info(1, Info::kMovesStack, 4);
  return info(1, 0, 4);
}

}  // namespace

InstructionInfo decode(std::uint16_t first, std::uint16_t second) {
  return first >= 0xE800 ? decode32(first, second) : decode16(first);
}

}  // namespace finemote::emulator
