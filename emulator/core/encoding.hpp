// Bits of an encoding to the operands of an operation: what the decoders of 16-bit, 32-bit and floating-point
// instructions share.
#pragma once

#include "emulator/core/operation.hpp"

namespace finemote::emulator::encoding {

using Op = Operation;
using Byte = std::uint8_t;

constexpr unsigned bits(unsigned value, unsigned high, unsigned low) {
  return value >> low & ((2U << (high - low)) - 1);
}

constexpr std::uint32_t sign_extend(std::uint32_t value, unsigned width) {
  const std::uint32_t top = 1U << (width - 1);
  return (value ^ top) - top;
}

inline Op make(Opcode kind, unsigned d = 0, unsigned n = 0, unsigned m = 0, std::uint32_t imm = 0, unsigned mode = 0) {
  Op o;
  o.kind = kind;
  o.d = static_cast<Byte>(d);
  o.n = static_cast<Byte>(n);
  o.m = static_cast<Byte>(m);
  o.imm = imm;
  o.mode = static_cast<Byte>(mode);
  return o;
}

inline Op with_flags(Op o, Byte sets = Op::kOutsideIt) {
  o.sets = sets;
  return o;
}

/// DecodeImmShift, A7.4.2.
inline Op shifted(Op o, unsigned type, unsigned amount) {
  o.shift = static_cast<Shift>(type);
  o.amount = static_cast<Byte>(amount);
  if (type != 0 && amount == 0) {
    if (type == 3) {
      o.shift = Shift::rrx;
      o.amount = 1;
    } else {
      o.amount = 32;
    }
  }
  return o;
}

inline Op with_mode(Op o, unsigned mode) {
  o.mode = static_cast<Byte>(mode);
  return o;
}

inline Op with_amount(Op o, unsigned amount) {
  o.amount = static_cast<Byte>(amount);
  return o;
}

/// @param fourth  the register that is added, or a width
inline Op media(Media what, unsigned d, unsigned n, unsigned m, unsigned fourth, unsigned mode) {
  Op o = with_mode(make(Opcode::media, d, n, m, fourth), mode);
  o.a = static_cast<Byte>(what);
  return o;
}

constexpr Opcode offset(Opcode first, unsigned by) { return static_cast<Opcode>(static_cast<unsigned>(first) + by); }

inline Op extend(unsigned d, unsigned n, unsigned m, unsigned rotation, unsigned mode) {
  return with_amount(with_mode(make(Opcode::extend, d, n, m), mode), rotation);
}

}  // namespace finemote::emulator::encoding
