#include "generator/expression/integer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>
#include <limits>
#include <vector>

#include "generator/expression/big_integer.hpp"
#include "generator/expression/failure.hpp"

namespace finemote::gen::expression {
namespace {

std::size_t bits_of(const BigInteger& value) {
  return value == 0 ? 0 : boost::multiprecision::msb(value < 0 ? BigInteger(-value) : value) + 1;
}

void check_bits(std::size_t bits) {
  if (bits > kMaxIntegerBits) fail_limit(fmt::format("the integer is too large: more than {} bits", kMaxIntegerBits));
}

/// The value of `top` (its 64 highest bits, the lowest one set when anything follows) times 2^exponent.
double scale(std::uint64_t top, long exponent) {
  return std::ldexp(static_cast<double>(top), static_cast<int>(std::clamp(exponent, -5000L, 5000L)));
}

/// |value| * 2^exponent, correctly rounded; `rest` says that the exact value is a little larger.
double rounded(const BigInteger& value, bool rest, long exponent) {
  const std::size_t bits = bits_of(value);
  if (bits <= 64) {
    const auto top = value.convert_to<std::uint64_t>();
    return scale(top, exponent);
  }
  const std::size_t drop = bits - 64;
  const BigInteger high = value >> drop;
  auto top = high.convert_to<std::uint64_t>();
  if (rest || (high << drop) != value) top |= 1;
  return scale(top, exponent + static_cast<long>(drop));
}

/// x * x for multi-limb numbers in the loop of power().
BigInteger multiply_checked(const BigInteger& a, const BigInteger& b) {
  check_bits(bits_of(a) + bits_of(b) > 1 ? bits_of(a) + bits_of(b) - 1 : 0);
  return a * b;
}

std::size_t small_shift(const Integer& bits) {
  if (!bits.is_small()) check_bits(std::numeric_limits<std::size_t>::max());
  return static_cast<std::size_t>(bits.small());
}

}  // namespace

BigInteger big_of(const Integer& i) { return i.is_small() ? BigInteger(i.small()) : i.big()->value; }

Integer integer_from(BigInteger value) {
  constexpr auto lowest = std::numeric_limits<std::int64_t>::min();
  constexpr auto highest = std::numeric_limits<std::int64_t>::max();
  if (value >= lowest && value <= highest) return value.convert_to<std::int64_t>();
  return Integer(std::make_shared<const BigHolder>(BigHolder{std::move(value)}));
}

std::size_t bit_length(const Integer& value) {
  if (!value.is_small()) return bits_of(value.big()->value);
  const auto magnitude =
      value.small() < 0 ? 0 - static_cast<std::uint64_t>(value.small()) : static_cast<std::uint64_t>(value.small());
  return static_cast<std::size_t>(std::bit_width(magnitude));
}

bool Integer::is_negative() const { return big_ ? big_->value < 0 : small_ < 0; }

double Integer::to_double() const {
  if (is_small()) return static_cast<double>(small_);
  const bool negative = big_->value < 0;
  const double magnitude = rounded(negative ? BigInteger(-big_->value) : big_->value, false, 0);
  if (std::isinf(magnitude)) fail_eval("int too large to convert to float");
  return negative ? -magnitude : magnitude;
}

std::string Integer::to_string() const {
  if (is_small()) return std::to_string(small_);
  constexpr double kBitsPerDigit = 3.3219280948873623;
  const auto too_long = [] {
    fail_eval(fmt::format("Exceeds the limit ({} digits) for integer string conversion", kMaxIntegerDigits));
  };
  if (static_cast<double>(bits_of(big_->value)) > (static_cast<double>(kMaxIntegerDigits) + 2) * kBitsPerDigit)
    too_long();
  std::string text = big_->value.str();
  if (text.size() - (text[0] == '-') > kMaxIntegerDigits) too_long();
  return text;
}

std::string Integer::to_string(unsigned base) const {
  const unsigned bits = base == 2 ? 1 : base == 8 ? 3 : 4;
  std::vector<unsigned char> digits;
  boost::multiprecision::export_bits(big_of(*this), std::back_inserter(digits), bits);  // of the magnitude
  std::string text = is_negative() ? "-" : "";
  for (const unsigned char digit : digits) text += "0123456789abcdef"[digit];
  return text;
}

bool operator==(const Integer& a, const Integer& b) {
  if (a.is_small() && b.is_small()) return a.small_ == b.small_;
  return a.is_small() == b.is_small() && a.big_->value == b.big_->value;
}

std::strong_ordering operator<=>(const Integer& a, const Integer& b) {
  if (a.is_small() && b.is_small()) return a.small_ <=> b.small_;
  const BigInteger x = big_of(a);
  const BigInteger y = big_of(b);
  if (x == y) return std::strong_ordering::equal;
  return x < y ? std::strong_ordering::less : std::strong_ordering::greater;
}

Integer operator+(const Integer& a, const Integer& b) {
  std::int64_t sum = 0;
  if (a.is_small() && b.is_small() && !__builtin_add_overflow(a.small(), b.small(), &sum)) return sum;
  check_bits(std::max(bit_length(a), bit_length(b)) + 1);
  return integer_from(BigInteger(big_of(a) + big_of(b)));
}

Integer operator-(const Integer& a, const Integer& b) {
  std::int64_t difference = 0;
  if (a.is_small() && b.is_small() && !__builtin_sub_overflow(a.small(), b.small(), &difference)) return difference;
  check_bits(std::max(bit_length(a), bit_length(b)) + 1);
  return integer_from(BigInteger(big_of(a) - big_of(b)));
}

Integer operator*(const Integer& a, const Integer& b) {
  std::int64_t product = 0;
  if (a.is_small() && b.is_small() && !__builtin_mul_overflow(a.small(), b.small(), &product)) return product;
  return integer_from(multiply_checked(big_of(a), big_of(b)));
}

Integer operator-(const Integer& a) { return Integer(0) - a; }

namespace {

/// Bit operations of negative numbers are those of two's complement with endless sign bits.
template <typename Operation>
Integer bitwise(const Integer& a, const Integer& b, Operation operation) {
  const std::size_t bits = std::max(bit_length(a), bit_length(b)) + 1;
  const BigInteger modulus = BigInteger(1) << bits;
  const auto wrap = [&](const Integer& x) { return x.is_negative() ? BigInteger(big_of(x) + modulus) : big_of(x); };
  BigInteger result = operation(wrap(a), wrap(b));
  if (result >= (modulus >> 1)) result -= modulus;
  return integer_from(std::move(result));
}

}  // namespace

Integer operator&(const Integer& a, const Integer& b) {
  if (a.is_small() && b.is_small()) return a.small() & b.small();
  return bitwise(a, b, [](const BigInteger& x, const BigInteger& y) { return BigInteger(x & y); });
}

Integer operator|(const Integer& a, const Integer& b) {
  if (a.is_small() && b.is_small()) return a.small() | b.small();
  return bitwise(a, b, [](const BigInteger& x, const BigInteger& y) { return BigInteger(x | y); });
}

Integer operator^(const Integer& a, const Integer& b) {
  if (a.is_small() && b.is_small()) return a.small() ^ b.small();
  return bitwise(a, b, [](const BigInteger& x, const BigInteger& y) { return BigInteger(x ^ y); });
}

Integer floor_divide(const Integer& a, const Integer& b) {
  constexpr auto lowest = std::numeric_limits<std::int64_t>::min();
  if (a.is_small() && b.is_small() && !(a.small() == lowest && b.small() == -1)) {
    const std::int64_t quotient = a.small() / b.small();
    const bool inexact = a.small() % b.small() != 0;
    return quotient - (inexact && (a.small() < 0) != (b.small() < 0) ? 1 : 0);
  }
  BigInteger quotient;
  BigInteger rest;
  boost::multiprecision::divide_qr(big_of(a), big_of(b), quotient, rest);
  if (rest != 0 && (rest < 0) != b.is_negative()) quotient -= 1;
  return integer_from(std::move(quotient));
}

Integer floor_modulo(const Integer& a, const Integer& b) { return a - floor_divide(a, b) * b; }

double true_divide(const Integer& a, const Integer& b) {
  constexpr std::int64_t exact = std::int64_t{1} << 53;
  const auto fits = [](const Integer& x) { return x.is_small() && x.small() >= -exact && x.small() <= exact; };
  if (fits(a) && fits(b)) return static_cast<double>(a.small()) / static_cast<double>(b.small());
  if (a.is_zero()) return 0.0;
  const BigInteger x = a.is_negative() ? BigInteger(-big_of(a)) : big_of(a);
  const BigInteger y = b.is_negative() ? BigInteger(-big_of(b)) : big_of(b);
  const long lead = static_cast<long>(bits_of(x)) - static_cast<long>(bits_of(y));
  const long shift = 66 - lead;  // the quotient gets at least 66 bits
  const BigInteger dividend = shift > 0 ? BigInteger(x << static_cast<std::size_t>(shift)) : x;
  const BigInteger divisor = shift < 0 ? BigInteger(y << static_cast<std::size_t>(-shift)) : y;
  BigInteger quotient;
  BigInteger rest;
  boost::multiprecision::divide_qr(dividend, divisor, quotient, rest);
  const double magnitude = rounded(quotient, rest != 0, -shift);
  if (std::isinf(magnitude)) fail_eval("integer division result too large for a float");
  return a.is_negative() != b.is_negative() ? -magnitude : magnitude;
}

Integer power(const Integer& base, const Integer& exponent) {
  const bool trivial = base.is_small() && base.small() >= -1 && base.small() <= 1;
  if (trivial) {
    if (exponent.is_zero() || base.small() == 1) return 1;
    if (base.small() == 0) return 0;
    return floor_modulo(exponent, 2).is_zero() ? 1 : -1;
  }
  if (!exponent.is_small() || exponent.small() > static_cast<std::int64_t>(kMaxIntegerBits)) {
    check_bits(std::numeric_limits<std::size_t>::max());
  }
  auto left = static_cast<std::uint64_t>(exponent.small());
  check_bits((bit_length(base) - 1) * left);
  BigInteger result = 1;
  for (BigInteger square = big_of(base); left > 0; left >>= 1) {
    if ((left & 1) != 0) result = multiply_checked(result, square);
    if (left > 1) square = multiply_checked(square, square);
  }
  return integer_from(std::move(result));
}

Integer shift_left(const Integer& a, const Integer& bits) {
  if (a.is_zero()) return 0;
  const std::size_t count = small_shift(bits);
  check_bits(count);
  check_bits(bit_length(a) + count);
  return integer_from(BigInteger(big_of(a) << count));
}

Integer shift_right(const Integer& a, const Integer& bits) {
  if (!bits.is_small() || static_cast<std::size_t>(bits.small()) > kMaxIntegerBits) return a.is_negative() ? -1 : 0;
  const auto count = static_cast<std::size_t>(bits.small());
  if (!a.is_negative()) return integer_from(BigInteger(big_of(a) >> count));
  return integer_from(BigInteger(-((-big_of(a) - 1) >> count) - 1));
}

Integer integer_of(double value) {
  if (std::isnan(value)) fail_eval("cannot convert float NaN to integer");
  if (std::isinf(value)) fail_eval("cannot convert float infinity to integer");
  const double whole = std::trunc(value);
  if (std::abs(whole) < 9.0e18) return static_cast<std::int64_t>(whole);
  int exponent = 0;
  const double fraction = std::frexp(whole, &exponent);
  const auto mantissa = static_cast<std::int64_t>(std::ldexp(fraction, 53));
  return integer_from(BigInteger(BigInteger(mantissa) * (BigInteger(1) << static_cast<unsigned>(exponent - 53))));
}

namespace {

/// Python's bound for decimal texts; a bound of ours for binary, octal and hexadecimal ones.
void check_digit_count(std::size_t digits, unsigned base) {
  const bool is_power_of_two = (base & (base - 1)) == 0;
  if (is_power_of_two && digits > 20'000) fail_limit("the integer has too many digits");
  if (is_power_of_two || digits <= kMaxIntegerDigits) return;
  fail_eval(fmt::format("Exceeds the limit ({} digits) for integer string conversion: value has {} digits",
                        kMaxIntegerDigits, digits));
}

}  // namespace

std::optional<Integer> parse_digits(std::string_view digits, unsigned base) {
  if (digits.empty()) return std::nullopt;
  const auto value_of = [](char c) -> unsigned {
    if (c >= '0' && c <= '9') return static_cast<unsigned>(c - '0');
    if (c >= 'a' && c <= 'z') return static_cast<unsigned>(c - 'a') + 10;
    if (c >= 'A' && c <= 'Z') return static_cast<unsigned>(c - 'A') + 10;
    return 99;
  };
  if (!std::all_of(digits.begin(), digits.end(), [&](char c) { return value_of(c) < base; })) return std::nullopt;
  check_digit_count(digits.size(), base);
  std::int64_t small = 0;  // of the digits since the last that went to `big`
  std::int64_t scale = 1;
  std::optional<BigInteger> big;
  for (const char c : digits) {
    if (scale > std::numeric_limits<std::int64_t>::max() / 64) {
      big = big ? BigInteger(*big * scale + small) : BigInteger(small);
      small = 0, scale = 1;
    }
    small = small * base + value_of(c);
    scale *= base;
  }
  return big ? integer_from(BigInteger(*big * scale + small)) : Integer(small);
}

}  // namespace finemote::gen::expression
