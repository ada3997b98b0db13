// 64-bit integer arithmetic that rounds as mathematics does and never wraps: bits, counts, bytes, nanoseconds.
#pragma once

#include <cstdint>
#include <numeric>
#include <stdexcept>

namespace finemote::gen {

/// A sum, product or least common multiple left the range of 64 bits. Thrown in the middle of formulas: no formula
/// needs to carry a failure through. Whoever begins a calculation catches it and says what was too large.
struct Overflow : std::overflow_error {
  using std::overflow_error::overflow_error;
};

constexpr std::int64_t add(std::int64_t a, std::int64_t b) {
  std::int64_t sum = 0;
  if (__builtin_add_overflow(a, b, &sum)) throw Overflow("a sum");
  return sum;
}

constexpr std::int64_t subtract(std::int64_t a, std::int64_t b) {
  std::int64_t difference = 0;
  if (__builtin_sub_overflow(a, b, &difference)) throw Overflow("a difference");
  return difference;
}

constexpr std::int64_t multiply(std::int64_t a, std::int64_t b) {
  std::int64_t product = 0;
  if (__builtin_mul_overflow(a, b, &product)) throw Overflow("a product");
  return product;
}

/// Floor of a/b for b > 0; rounds to minus infinity, unlike `/`.
constexpr std::int64_t floor_div(std::int64_t a, std::int64_t b) { return a / b - (a % b < 0 ? 1 : 0); }

/// Ceiling of a/b for b > 0.
constexpr std::int64_t ceil_div(std::int64_t a, std::int64_t b) { return a / b + (a % b > 0 ? 1 : 0); }

/// Largest multiple of b that is at most a, for b > 0.
constexpr std::int64_t round_down(std::int64_t a, std::int64_t b) { return multiply(floor_div(a, b), b); }

/// Smallest multiple of b that is at least a, for b > 0.
constexpr std::int64_t round_up(std::int64_t a, std::int64_t b) { return multiply(ceil_div(a, b), b); }

/// Least common multiple of positive numbers.
constexpr std::int64_t lcm(std::int64_t a, std::int64_t b) {
  std::int64_t result = 0;
  if (__builtin_mul_overflow(a / std::gcd(a, b), b, &result))
    throw Overflow("the least common multiple of the periods");
  return result;
}

}  // namespace finemote::gen
