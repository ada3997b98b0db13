// Bit fields, saturation and long multiplication.
#include "emulator/core/interpreter.hpp"

namespace finemote::emulator {

void Interpreter::bit_field(const Operation& o) {
  std::uint32_t& d = registers.r[o.d];
  const std::uint32_t n = registers.r[o.n];
  if (o.kind == Opcode::bfi) {
    if (o.imm < o.amount) return;
    const std::uint32_t mask = ((2U << (o.imm - o.amount)) - 1) << o.amount, source = o.n == 15 ? 0 : n;
    d = (d & ~mask) | (source << o.amount & mask);
    return;
  }
  const unsigned left = o.amount + o.imm > 32 ? 0 : 32 - o.amount - o.imm, right = 32 - o.imm;
  d = o.kind == Opcode::ubfx ? n << left >> right
                             : static_cast<std::uint32_t>(static_cast<std::int32_t>(n << left) >> right);
}

void Interpreter::saturate(const Operation& o) {
  std::uint32_t carry = 0;
  const auto value = static_cast<std::int32_t>(shifted(o, carry));
  const std::int64_t high =
                         o.kind == Opcode::ssat ? (std::int64_t{1} << (o.imm - 1)) - 1 : (std::int64_t{1} << o.imm) - 1,
                     low = o.kind == Opcode::ssat ? -high - 1 : 0;
  const std::int64_t kept = value < low ? low : value > high ? high : value;
  if (kept != value) registers.q = 1;
  registers.r[o.d] = static_cast<std::uint32_t>(kept);
}

void Interpreter::multiply_long(const Operation& o) {
  const std::uint32_t n = registers.r[o.n], m = registers.r[o.m];
  std::uint32_t &low = registers.r[o.d], &high = registers.r[o.a];
  const bool is_signed = o.kind == Opcode::smull || o.kind == Opcode::smlal;
  std::uint64_t result =
      is_signed ? static_cast<std::uint64_t>(std::int64_t{static_cast<std::int32_t>(n)} * static_cast<std::int32_t>(m))
                : std::uint64_t{n} * m;
  if (o.kind == Opcode::smlal || o.kind == Opcode::umlal) result += std::uint64_t{high} << 32 | low;
  if (o.kind == Opcode::umaal) result += std::uint64_t{high} + low;
  low = static_cast<std::uint32_t>(result);
  high = static_cast<std::uint32_t>(result >> 32);
}

}  // namespace finemote::emulator
