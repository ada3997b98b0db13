#include "generator/wcet/interval.hpp"

#include <algorithm>

namespace finemote::gen::wcet {
namespace {

constexpr std::uint64_t kModulus = std::uint64_t{1} << 32U;

/// Of results before they are cut to 32 bits, which lie in [low, high].
Interval cut(std::uint64_t low, std::uint64_t high) {
  if (low / kModulus != high / kModulus) return Interval::any();
  return {static_cast<std::uint32_t>(low), static_cast<std::uint32_t>(high)};
}

/// All bits up to the highest one that `value` has.
std::uint32_t mask_over(std::uint32_t value) {
  for (unsigned shift = 1; shift < 32; shift *= 2) value |= value >> shift;
  return value;
}

}  // namespace

Interval join(Interval a, Interval b) { return {std::min(a.low, b.low), std::max(a.high, b.high)}; }

std::optional<Interval> meet(Interval a, Interval b) {
  const Interval both{std::max(a.low, b.low), std::min(a.high, b.high)};
  return both.low > both.high ? std::nullopt : std::optional(both);
}

Interval add(Interval a, Interval b) { return cut(std::uint64_t{a.low} + b.low, std::uint64_t{a.high} + b.high); }

Interval subtract(Interval a, Interval b) { return cut(kModulus + a.low - b.high, kModulus + a.high - b.low); }

Interval multiply(Interval a, Interval b) { return cut(std::uint64_t{a.low} * b.low, std::uint64_t{a.high} * b.high); }

/// A division by zero gives 0 (ARMv7-M A7.7.196, with CCR.DIV_0_TRP clear).
Interval divide_unsigned(Interval a, Interval b) {
  const std::uint32_t low = b.low == 0 ? 0 : a.low / b.high;
  return {low, a.high / std::max(b.low, 1U)};
}

Interval bitwise_and(Interval a, Interval b) {
  if (a.is_constant() && b.is_constant()) return Interval::of(a.low & b.low);
  return {0, std::min(a.high, b.high)};
}

Interval bitwise_or(Interval a, Interval b) {
  if (a.is_constant() && b.is_constant()) return Interval::of(a.low | b.low);
  return {std::max(a.low, b.low), mask_over(a.high | b.high)};
}

Interval exclusive_or(Interval a, Interval b) {
  if (a.is_constant() && b.is_constant()) return Interval::of(a.low ^ b.low);
  return {0, mask_over(a.high | b.high)};
}

Interval complement(Interval a) { return {~a.high, ~a.low}; }

Interval shift_left(Interval a, unsigned bits) {
  return cut(std::uint64_t{a.low} << bits, std::uint64_t{a.high} << bits);
}

Interval shift_right(Interval a, unsigned bits) { return {a.low >> bits, a.high >> bits}; }

Interval shift_right_signed(Interval a, unsigned bits) {
  const bool is_one_sign = (a.low >> 31U) == (a.high >> 31U);
  if (!is_one_sign) return Interval::any();
  const auto shifted = [bits](std::uint32_t value) {
    return static_cast<std::uint32_t>(static_cast<std::int32_t>(value) >> bits);
  };
  return {shifted(a.low), shifted(a.high)};
}

}  // namespace finemote::gen::wcet
