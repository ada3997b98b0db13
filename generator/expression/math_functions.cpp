// Python's math module.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "generator/expression/builtins.hpp"
#include "generator/expression/cost.hpp"
#include "generator/expression/iterate.hpp"
#include "generator/expression/operate.hpp"
#include "generator/expression/parameters.hpp"
#include "generator/expression/runtime.hpp"

namespace finemote::gen::expression {
namespace {

double real_of(const Value& value) {
  if (const double* d = as_real(value)) return *d;
  if (const auto i = as_integer(value)) return i->to_double();
  fail_eval(fmt::format("must be real number, not {}", type_name(value)));
}

Integer integer_argument(const Value& value) {
  const auto i = as_integer(value);
  if (!i) fail_eval(fmt::format("'{}' object cannot be interpreted as an integer", type_name(value)));
  return *i;
}

/// Python's errors for results that are none: nan from a number is outside the domain, infinity outside the range.
double checked(double result, bool all_finite, bool all_numbers, bool infinity_is_domain) {
  if (std::isnan(result) && all_numbers) fail_eval("math domain error");
  if (std::isinf(result) && all_finite) fail_eval(infinity_is_domain ? "math domain error" : "math range error");
  return result;
}

template <double (*Function)(double), bool InfinityIsDomain = false>
Value unary(Runtime& /*runtime*/, const Parameters& p) {
  const double x = real_of(p.at(0));
  return checked(Function(x), std::isfinite(x), !std::isnan(x), InfinityIsDomain);
}

template <double (*Function)(double, double), bool InfinityIsDomain = false>
Value binary(Runtime& /*runtime*/, const Parameters& p) {
  const double x = real_of(p.at(0));
  const double y = real_of(p.at(1));
  return checked(Function(x, y), std::isfinite(x) && std::isfinite(y), !std::isnan(x) && !std::isnan(y),
                 InfinityIsDomain);
}

double power_of(double x, double y) {
  if (x == 0.0 && y < 0) fail_eval("math domain error");
  return std::pow(x, y);
}

double degrees_of(double x) { return x * (180.0 / std::numbers::pi); }
double radians_of(double x) { return x * (std::numbers::pi / 180.0); }

/// pole of gamma at zero and the negative integers
double gamma_of(double x) {
  if (x == -std::numeric_limits<double>::infinity() || (x <= 0 && x == std::floor(x))) fail_eval("math domain error");
  return std::tgamma(x);
}

double log_gamma(double x) {
  if (std::isfinite(x) && x <= 0 && x == std::floor(x)) fail_eval("math domain error");
  int sign = 0;
  return ::lgamma_r(x, &sign);  // std::lgamma writes a global variable
}

double logarithm(const Value& value, double (*function)(double)) {
  const auto i = as_integer(value);
  const double x = i && !i->is_small() && !i->is_negative() ? 0.0 : real_of(value);
  if (i && !i->is_small() && !i->is_negative()) {  // beyond the range of double
    const std::size_t bits = i->to_string(16).size() * 4;
    const auto drop = static_cast<std::int64_t>(bits > 64 ? bits - 64 : 0);
    return function(shift_right(*i, drop).to_double()) + static_cast<double>(drop) * function(2.0);
  }
  if (x <= 0) fail_eval("math domain error");
  return function(x);
}

Value log(Runtime& /*runtime*/, const Parameters& p) {
  const double numerator = logarithm(p.at(0), std::log);
  if (p[1] == nullptr) return numerator;
  const double denominator = logarithm(p.at(1), std::log);
  if (denominator == 0.0) fail_eval("float division by zero");
  return numerator / denominator;
}

Value log2(Runtime& /*runtime*/, const Parameters& p) { return logarithm(p.at(0), std::log2); }

Value log10(Runtime& /*runtime*/, const Parameters& p) { return logarithm(p.at(0), std::log10); }

template <double (*Function)(double)>
Value to_whole(Runtime& /*runtime*/, const Parameters& p) {
  if (const auto i = as_integer(p.at(0))) return *i;
  return integer_of(Function(real_of(p.at(0))));
}

template <bool (*Test)(double)>
Value test(Runtime& /*runtime*/, const Parameters& p) {
  return Test(real_of(p.at(0)));
}

bool is_nan(double x) { return std::isnan(x); }
bool is_infinite(double x) { return std::isinf(x); }
bool is_finite(double x) { return std::isfinite(x); }

Value isclose(Runtime& /*runtime*/, const Parameters& p) {
  const double a = real_of(p.at(0));
  const double b = real_of(p.at(1));
  const double relative = p[2] != nullptr ? real_of(p.at(2)) : 1e-9;
  const double absolute = p[3] != nullptr ? real_of(p.at(3)) : 0.0;
  if (relative < 0 || absolute < 0) fail_eval("tolerances must be non-negative");
  if (a == b) return true;
  if (std::isinf(a) || std::isinf(b)) return false;
  const double difference = std::abs(a - b);
  return difference <= std::abs(relative * b) || difference <= std::abs(relative * a) || difference <= absolute;
}

Value modf(Runtime& /*runtime*/, const Parameters& p) {
  double whole = 0;
  const double fraction = std::modf(real_of(p.at(0)), &whole);
  return make_tuple({fraction, whole});
}

Value frexp(Runtime& /*runtime*/, const Parameters& p) {
  const double x = real_of(p.at(0));
  int exponent = 0;
  const double mantissa = std::isfinite(x) ? std::frexp(x, &exponent) : x;
  return make_tuple({mantissa, exponent});
}

Value ldexp(Runtime& /*runtime*/, const Parameters& p) {
  const double x = real_of(p.at(0));
  const Integer i = integer_argument(p.at(1));
  const std::int64_t exponent = std::clamp<std::int64_t>(p.integer(1, 0), -100'000, 100'000);
  return checked(std::ldexp(x, static_cast<int>(exponent)), std::isfinite(x), true, false);
}

/// sqrt of the sum of squares; the wider type keeps the last digit right.
double norm(const std::vector<double>& coordinates) {
  long double sum = 0;
  for (const double c : coordinates) {
    if (std::isinf(c)) return std::numeric_limits<double>::infinity();
    sum += static_cast<long double>(c) * static_cast<long double>(c);
  }
  return static_cast<double>(std::sqrt(sum));
}

Value hypot(Runtime& /*runtime*/, const Parameters& p) {
  std::vector<double> coordinates;
  for (const Value& v : p.positional()) coordinates.push_back(real_of(v));
  return norm(coordinates);
}

Value dist(Runtime& runtime, const Parameters& p) {
  const Values a = items_of(runtime, p.at(0));
  const Values b = items_of(runtime, p.at(1));
  if (a.size() != b.size()) fail_eval("both points must have the same number of dimensions");
  std::vector<double> differences;
  for (std::size_t i = 0; i < a.size(); ++i) differences.push_back(real_of(a[i]) - real_of(b[i]));
  return norm(differences);
}

/// Sum without loss: partial sums that do not overlap (Shewchuk, 1997).
Value fsum(Runtime& runtime, const Parameters& p) {
  std::vector<double> partials;
  for (const Value& item : items_of(runtime, p.at(0))) {
    double x = real_of(item);
    std::size_t kept = 0;
    runtime.budget.spend(partials.size());
    for (double y : partials) {
      if (std::abs(x) < std::abs(y)) std::swap(x, y);
      const double high = x + y;
      const double low = y - (high - x);
      if (low != 0.0) partials[kept++] = low;
      x = high;
    }
    partials.resize(kept);
    partials.push_back(x);
  }
  long double total = 0;
  for (const double partial : partials) total += static_cast<long double>(partial);
  return static_cast<double>(total);
}

Value prod(Runtime& runtime, const Parameters& p) {
  Value product = p[1] != nullptr ? p.at(1) : Value(1);
  for (const Value& item : items_of(runtime, p.at(0))) product = operate(runtime, Operator::multiply, product, item);
  return product;
}

Integer common_divisor(Runtime& runtime, Integer a, Integer b) {
  while (!b.is_zero()) {
    runtime.budget.spend(1 + cost_of_division(a, b));
    Integer rest = floor_modulo(a, b);
    a = std::move(b);
    b = std::move(rest);
  }
  return a.is_negative() ? -a : a;
}

Value gcd(Runtime& runtime, const Parameters& p) {
  Integer divisor = 0;
  for (const Value& v : p.positional()) divisor = common_divisor(runtime, divisor, integer_argument(v));
  return divisor;
}

Value lcm(Runtime& runtime, const Parameters& p) {
  Integer multiple = 1;
  for (const Value& v : p.positional()) {
    const Integer i = integer_argument(v);
    if (i.is_zero()) return 0;
    runtime.budget.spend(2 * cost_of_product(bytes_of(multiple), bytes_of(i)));
    multiple = floor_divide(multiple * i, common_divisor(runtime, multiple, i));
  }
  return multiple.is_negative() ? -multiple : multiple;
}

constexpr std::int64_t kMostFactors = 20'000;

/// from * (from + 1) ... to
Integer product_of_range(Runtime& runtime, std::int64_t from, std::int64_t to) {
  if (to - from > kMostFactors) fail_limit("the integer is too large");
  Integer product = 1;
  for (std::int64_t i = from; i <= to; ++i) {
    runtime.budget.spend(1 + cost_of_block(bytes_of(product)));
    product = product * i;
  }
  return product;
}

std::int64_t count_argument(const Parameters& p, std::size_t i, const char* message) {
  const std::int64_t count = p.integer(i, 0);
  static_cast<void>(integer_argument(p.at(i)));
  if (count < 0) fail_eval(message);
  return count;
}

Value factorial(Runtime& runtime, const Parameters& p) {
  return product_of_range(runtime, 1, count_argument(p, 0, "factorial() not defined for negative values"));
}

Value perm(Runtime& runtime, const Parameters& p) {
  const std::int64_t n = count_argument(p, 0, "n must be a non-negative integer");
  const std::int64_t k =
      p[1] != nullptr && !p.at(1).is_none() ? count_argument(p, 1, "k must be a non-negative integer") : n;
  return k > n ? Integer(0) : product_of_range(runtime, n - k + 1, n);
}

Value comb(Runtime& runtime, const Parameters& p) {
  const std::int64_t n = count_argument(p, 0, "n must be a non-negative integer");
  const std::int64_t k = count_argument(p, 1, "k must be a non-negative integer");
  if (k > n) return 0;
  const std::int64_t fewer = std::min(k, n - k);
  const Integer product = product_of_range(runtime, n - fewer + 1, n);
  const Integer divisor = product_of_range(runtime, 1, fewer);
  runtime.budget.spend(cost_of_division(product, divisor));
  return floor_divide(product, divisor);
}

/// The largest integer whose square is not larger: Newton's method from above.
Value isqrt(Runtime& runtime, const Parameters& p) {
  const Integer n = integer_argument(p.at(0));
  if (n.is_negative()) fail_eval("isqrt() argument must be nonnegative");
  if (n.is_zero()) return 0;
  Integer x = shift_left(1, static_cast<std::int64_t>(n.to_string(16).size() * 2));
  for (;;) {
    runtime.budget.spend(1 + cost_of_division(n, x));
    Integer next = shift_right(x + floor_divide(n, x), 1);
    if (next >= x) return x;
    x = std::move(next);
  }
}

double ulp_of(double x) {
  if (!std::isfinite(x)) return std::abs(x);
  const double magnitude = std::abs(x);
  return std::nextafter(magnitude, std::numeric_limits<double>::infinity()) - magnitude;
}

double cube_root(double x) { return std::cbrt(x); }

/// Messages do not tell which of the plain functions was called.
constexpr Signature kOne({"x"}, 1, "math function");
constexpr Signature kTwo({"x", "y"}, 2, "math function");

constexpr Builtin kMath[] = {{"acos", kOne, unary<std::acos>},
                             {"acosh", kOne, unary<std::acosh>},
                             {"asin", kOne, unary<std::asin>},
                             {"asinh", kOne, unary<std::asinh>},
                             {"atan", kOne, unary<std::atan>},
                             {"atan2", kTwo, binary<std::atan2>},
                             {"atanh", kOne, unary<std::atanh, true>},
                             {"cbrt", kOne, unary<cube_root>},
                             {"ceil", kOne, to_whole<std::ceil>},
                             {"comb", {{"n", "k"}, 2}, comb},
                             {"copysign", kTwo, binary<std::copysign>},
                             {"cos", kOne, unary<std::cos>},
                             {"cosh", kOne, unary<std::cosh>},
                             {"degrees", kOne, unary<degrees_of>},
                             {"dist", {{"p", "q"}, 2}, dist},
                             {"erf", kOne, unary<std::erf>},
                             {"erfc", kOne, unary<std::erfc>},
                             {"exp", kOne, unary<std::exp>},
                             {"exp2", kOne, unary<std::exp2>},
                             {"expm1", kOne, unary<std::expm1>},
                             {"fabs", kOne, unary<std::fabs>},
                             {"factorial", {{"x"}, 1}, factorial},
                             {"floor", kOne, to_whole<std::floor>},
                             {"fmod", kTwo, binary<std::fmod>},
                             {"frexp", {{"x"}, 1}, frexp},
                             {"fsum", {{"seq"}, 1}, fsum},
                             {"gamma", kOne, unary<gamma_of>},
                             {"gcd", Signature::positional(0), gcd},
                             {"hypot", Signature::positional(0), hypot},
                             {"isclose", {{"a", "b", "rel_tol", "abs_tol"}, 2}, isclose},
                             {"isfinite", kOne, test<is_finite>},
                             {"isinf", kOne, test<is_infinite>},
                             {"isnan", kOne, test<is_nan>},
                             {"isqrt", {{"n"}, 1}, isqrt},
                             {"lcm", Signature::positional(0), lcm},
                             {"ldexp", {{"x", "i"}, 2}, ldexp},
                             {"lgamma", kOne, unary<log_gamma>},
                             {"log", {{"x", "base"}, 1}, log},
                             {"log10", {{"x"}, 1}, log10},
                             {"log1p", kOne, unary<std::log1p, true>},
                             {"log2", {{"x"}, 1}, log2},
                             {"modf", {{"x"}, 1}, modf},
                             {"nextafter", kTwo, binary<std::nextafter>},
                             {"perm", {{"n", "k"}, 1}, perm},
                             {"pow", kTwo, binary<power_of>},
                             {"prod", {{"iterable", "start"}, 1}, prod},
                             {"radians", kOne, unary<radians_of>},
                             {"remainder", kTwo, binary<std::remainder>},
                             {"sin", kOne, unary<std::sin>},
                             {"sinh", kOne, unary<std::sinh>},
                             {"sqrt", kOne, unary<std::sqrt>},
                             {"tan", kOne, unary<std::tan>},
                             {"tanh", kOne, unary<std::tanh>},
                             {"trunc", kOne, to_whole<std::trunc>},
                             {"ulp", kOne, unary<ulp_of>}};

}  // namespace

Symbols math_symbols() {
  Symbols symbols = {{"pi", std::numbers::pi},
                     {"e", std::numbers::e},
                     {"tau", 2 * std::numbers::pi},
                     {"inf", std::numeric_limits<double>::infinity()},
                     {"nan", std::numeric_limits<double>::quiet_NaN()}};
  for (const Builtin& function : kMath) symbols.emplace_back(std::string(function.name), &function);
  return symbols;
}

}  // namespace finemote::gen::expression
