// Python's integers: without bound, small ones without cost.
#pragma once

#include <compare>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace finemote::gen::expression {

struct BigHolder;

inline constexpr std::size_t kMaxIntegerBits = std::size_t{1} << 20;  ///< beyond it operations fail
inline constexpr std::size_t kMaxIntegerDigits = 4300;                ///< longest decimal text, as in Python

class Integer {
 public:
  Integer(std::int64_t value = 0) : small_(value) {}  // NOLINT: an int is an Integer
  /// For values beyond 64 bits alone; big_integer.hpp makes either kind.
  explicit Integer(std::shared_ptr<const BigHolder> big) : big_(std::move(big)) {}

  [[nodiscard]] bool is_small() const { return big_ == nullptr; }
  [[nodiscard]] std::int64_t small() const { return small_; }        ///< only if is_small()
  [[nodiscard]] const BigHolder* big() const { return big_.get(); }  ///< null if is_small()
  [[nodiscard]] bool is_zero() const { return is_small() && small_ == 0; }
  [[nodiscard]] bool is_negative() const;

  /// Nearest double, ties to even; fails for magnitudes beyond it.
  [[nodiscard]] double to_double() const;
  /// Decimal text; fails beyond kMaxIntegerDigits.
  [[nodiscard]] std::string to_string() const;
  /// Digits in base 2, 8 or 16, lower case, with '-' but without prefix.
  [[nodiscard]] std::string to_string(unsigned base) const;

  friend bool operator==(const Integer& a, const Integer& b);
  friend std::strong_ordering operator<=>(const Integer& a, const Integer& b);

 private:
  std::int64_t small_ = 0;
  std::shared_ptr<const BigHolder> big_;  // set only when the value does not fit small_
};

Integer operator+(const Integer& a, const Integer& b);
Integer operator-(const Integer& a, const Integer& b);
Integer operator*(const Integer& a, const Integer& b);
Integer operator-(const Integer& a);
Integer operator&(const Integer& a, const Integer& b);
Integer operator|(const Integer& a, const Integer& b);
Integer operator^(const Integer& a, const Integer& b);

/// Bits of the magnitude; 0 for 0.
std::size_t bit_length(const Integer& value);

Integer floor_divide(const Integer& a, const Integer& b);     ///< rounds down; b is not zero
Integer floor_modulo(const Integer& a, const Integer& b);     ///< sign of b; b is not zero
double true_divide(const Integer& a, const Integer& b);       ///< correctly rounded; b is not zero
Integer power(const Integer& base, const Integer& exponent);  ///< exponent is not negative
Integer shift_left(const Integer& a, const Integer& bits);    ///< bits is not negative
Integer shift_right(const Integer& a, const Integer& bits);   ///< rounds down; bits is not negative

/// Truncated towards zero; fails for inf and nan.
Integer integer_of(double value);

/// Digits of `base` (2 to 36), without sign, prefix or blanks; nothing when there is another character.
std::optional<Integer> parse_digits(std::string_view digits, unsigned base);

}  // namespace finemote::gen::expression
