// The DSP extension: ARMv7-M Architecture Reference Manual A4.4.3 to A4.4.6 and A7.7.
#include <algorithm>

#include "emulator/core/interpreter.hpp"

namespace finemote::emulator {
namespace {

std::int32_t half(std::uint32_t value, unsigned which) {
  return static_cast<std::int16_t>(which != 0 ? value >> 16 : value);
}

std::int64_t as_signed(std::uint32_t value) { return static_cast<std::int32_t>(value); }

std::int64_t saturated(std::int64_t value, unsigned width) {
  const std::int64_t high = (std::int64_t{1} << (width - 1)) - 1;
  return std::clamp(value, -high - 1, high);
}

}  // namespace

/// A5.3.13 and A5.3.14: sums and differences of two halfwords or four bytes, plain, saturated or halved.
void Interpreter::parallel_add(const Operation& o) {
  const unsigned what = o.mode >> 4, how = o.mode & 3;
  const bool is_unsigned = (o.mode & 4) != 0, bytes = (what & 3) == 0;
  const unsigned width = bytes ? 8 : 16, lanes = 32 / width;
  const std::uint32_t n = registers.r[o.n], m = registers.r[o.m], mask = (1U << width) - 1;
  std::uint32_t result = 0, ge = 0;
  for (unsigned lane = 0; lane < lanes; ++lane) {
    const bool exchanged = what == 2 || what == 6;  // ASX, SAX
    const unsigned at = lane * width, other = exchanged ? width - at : at;
    const auto part = [&](std::uint32_t value, unsigned from) {
      const std::uint32_t x = value >> from & mask, top = 1U << (width - 1);
      return is_unsigned ? static_cast<std::int32_t>(x)
                         : static_cast<std::int32_t>(x ^ top) - static_cast<std::int32_t>(top);
    };
    // 0 ADD8, 1 ADD16, 2 ASX, 4 SUB8, 5 SUB16, 6 SAX.
    const bool subtracts = exchanged ? (what == 2) == (lane == 0) : what >= 4;
    const std::int32_t x = part(n, at), y = part(m, other), value = subtracts ? x - y : x + y;
    std::int32_t kept = value;
    if (how == 1) {
      const std::int32_t high = is_unsigned ? static_cast<std::int32_t>(mask) : static_cast<std::int32_t>(mask >> 1),
                         low = is_unsigned ? 0 : -high - 1;
      kept = std::clamp(value, low, high);
    } else if (how == 2) {
      kept = value >> 1;
    }
    const bool flag = is_unsigned && !subtracts ? value > static_cast<std::int32_t>(mask) : value >= 0;
    if (flag) ge |= (bytes ? 1U : 3U) << (bytes ? lane : 2 * lane);
    result |= (static_cast<std::uint32_t>(kept) & mask) << at;
  }
  if (how == 0) registers.ge = ge;
  registers.r[o.d] = result;
}

void Interpreter::media(const Operation& o) {
  Registers& g = registers;
  const std::uint32_t n = g.r[o.n], m = g.r[o.m];
  // Multiplications keep their fourth register in `imm`: `a` says which instruction it is.
  std::uint32_t& d = g.r[o.d];
  const auto accumulate = [&](std::int64_t product) {
    const std::int64_t sum = product + (o.imm == 15 ? 0 : as_signed(g.r[o.imm]));
    if (sum != static_cast<std::int32_t>(sum)) g.q = 1;
    d = static_cast<std::uint32_t>(sum);
  };
  const auto accumulate_long = [&](std::int64_t product) {
    std::uint32_t& high = g.r[o.imm];
    const std::uint64_t sum = (std::uint64_t{high} << 32 | d) + static_cast<std::uint64_t>(product);
    d = static_cast<std::uint32_t>(sum);
    high = static_cast<std::uint32_t>(sum >> 32);
  };
  const auto two_products = [&] {
    const unsigned x = o.mode & 1;
    const std::int64_t low = std::int64_t{half(n, 0)} * half(m, x), high = std::int64_t{half(n, 1)} * half(m, x ^ 1);
    return (o.mode & 2) != 0 ? low - high : low + high;
  };
  switch (static_cast<Media>(o.a)) {
    case Media::parallel_add:
      return parallel_add(o);
    case Media::sel: {
      std::uint32_t mask = 0;
      for (unsigned i = 0; i < 4; ++i) mask |= (g.ge >> i & 1) != 0 ? 0xFFU << (8 * i) : 0;
      d = (n & mask) | (m & ~mask);
      return;
    }
    case Media::pkh: {
      std::uint32_t carry = 0;
      const std::uint32_t second = shifted(o, carry);
      d = o.mode != 0 ? (n & 0xFFFF0000U) | (second & 0xFFFF) : (n & 0xFFFF) | (second & 0xFFFF0000U);
      return;
    }
    case Media::qadd: {
      std::int64_t x = as_signed(n);
      if ((o.mode & 1) != 0) x = saturated(2 * x, 32);
      if ((o.mode & 1) != 0 && x != 2 * as_signed(n)) g.q = 1;
      const std::int64_t value = (o.mode & 2) != 0 ? as_signed(m) - x : as_signed(m) + x;
      const std::int64_t kept = saturated(value, 32);
      if (kept != value) g.q = 1;
      d = static_cast<std::uint32_t>(kept);
      return;
    }
    case Media::smlaxy:
      return accumulate(std::int64_t{half(n, o.mode & 2)} * half(m, o.mode & 1));
    case Media::smlaw:
      return accumulate((as_signed(n) * half(m, o.mode)) >> 16);
    case Media::smlad:
      return accumulate(two_products());
    case Media::smmla: {
      const std::uint64_t product = static_cast<std::uint64_t>(as_signed(n) * as_signed(m));
      std::uint64_t sum = o.imm == 15 ? 0 : std::uint64_t{g.r[o.imm]} << 32;
      sum = (o.mode & 2) != 0 ? sum - product : sum + product;
      if ((o.mode & 1) != 0) sum += 0x80000000U;
      d = static_cast<std::uint32_t>(sum >> 32);
      return;
    }
    case Media::smlalxy:
      return accumulate_long(std::int64_t{half(n, o.mode & 2)} * half(m, o.mode & 1));
    case Media::smlald:
      return accumulate_long(two_products());
    case Media::usad8: {
      std::uint32_t sum = o.imm == 15 ? 0 : g.r[o.imm];
      for (unsigned at = 0; at < 32; at += 8) {
        const std::uint32_t x = n >> at & 0xFF, y = m >> at & 0xFF;
        sum += x > y ? x - y : y - x;
      }
      d = sum;
      return;
    }
    case Media::ssat16:
    case Media::usat16: {
      std::uint32_t result = 0;
      for (unsigned i = 0; i < 2; ++i) {
        const std::int32_t value = half(n, i),
                           high = static_cast<Media>(o.a) == Media::ssat16 ? (1 << (o.imm - 1)) - 1 : (1 << o.imm) - 1,
                           low = static_cast<Media>(o.a) == Media::ssat16 ? -high - 1 : 0;
        const std::int32_t kept = std::clamp(value, low, high);
        if (kept != value) g.q = 1;
        result |= (static_cast<std::uint32_t>(kept) & 0xFFFF) << (16 * i);
      }
      d = result;
      return;
    }
  }
}

}  // namespace finemote::emulator
