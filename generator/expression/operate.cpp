#include "generator/expression/operate.hpp"

#include <fmt/format.h>

#include <cmath>

#include "generator/expression/compare.hpp"
#include "generator/expression/cost.hpp"
#include "generator/expression/format.hpp"
#include "generator/expression/iterate.hpp"
#include "generator/expression/runtime.hpp"

namespace finemote::gen::expression {
namespace {

std::string_view spelling(Operator op) {
  switch (op) {
    case Operator::add:
      return "+";
    case Operator::subtract:
      return "-";
    case Operator::multiply:
      return "*";
    case Operator::divide:
      return "/";
    case Operator::floor_divide:
      return "//";
    case Operator::modulo:
      return "%";
    case Operator::power:
      return "** or pow()";
    case Operator::matrix_multiply:
      return "@";
    case Operator::shift_left:
      return "<<";
    case Operator::shift_right:
      return ">>";
    case Operator::bit_and:
      return "&";
    case Operator::bit_or:
      return "|";
    case Operator::bit_xor:
      return "^";
    case Operator::less:
      return "<";
    case Operator::less_equal:
      return "<=";
    case Operator::greater:
      return ">";
    case Operator::greater_equal:
      return ">=";
    default:
      return "?";
  }
}

[[noreturn]] void fail_operands(Operator op, const Value& a, const Value& b) {
  fail_eval(fmt::format("unsupported operand type(s) for {}: '{}' and '{}'", spelling(op), type_name(a), type_name(b)));
}

double as_double(const Value& value) {
  const double* d = as_real(value);
  return d != nullptr ? *d : as_integer(value)->to_double();
}

bool is_number(const Value& value) { return as_real(value) != nullptr || as_integer(value).has_value(); }

/// Python's float %: the result has the sign of the divisor.
double modulo(double a, double b) {
  double rest = std::fmod(a, b);
  if (rest == 0.0) return std::copysign(0.0, b);
  if ((rest < 0) != (b < 0)) rest += b;
  return rest;
}

double floor_quotient(double a, double b) {
  const double rest = std::fmod(a, b);
  double quotient = (a - rest) / b;
  if (rest != 0.0 && (rest < 0) != (b < 0)) quotient -= 1.0;
  if (quotient == 0.0) return std::copysign(0.0, a / b);
  const double whole = std::floor(quotient);
  return quotient - whole > 0.5 ? whole + 1.0 : whole;
}

Value real_operation(Operator op, const Value& a, const Value& b) {
  const double x = as_double(a);
  const double y = as_double(b);
  switch (op) {
    case Operator::add:
      return x + y;
    case Operator::subtract:
      return x - y;
    case Operator::multiply:
      return x * y;
    case Operator::divide:
      if (y == 0.0) fail_eval("float division by zero");
      return x / y;
    case Operator::floor_divide:
      if (y == 0.0) fail_eval("float floor division by zero");
      return floor_quotient(x, y);
    case Operator::modulo:
      if (y == 0.0) fail_eval("float modulo");
      return modulo(x, y);
    default:
      fail_operands(op, a, b);
  }
}

Integer shift_count(const Integer& bits) {
  if (bits.is_negative()) fail_eval("negative shift count");
  return bits;
}

Value integer_operation(Operator op, const Integer& a, const Integer& b, const Value& left, const Value& right) {
  switch (op) {
    case Operator::add:
      return a + b;
    case Operator::subtract:
      return a - b;
    case Operator::multiply:
      return a * b;
    case Operator::divide:
      if (b.is_zero()) fail_eval("division by zero");
      return true_divide(a, b);
    case Operator::floor_divide:
      if (b.is_zero()) fail_eval("integer division or modulo by zero");
      return floor_divide(a, b);
    case Operator::modulo:
      if (b.is_zero()) fail_eval("integer modulo by zero");
      return floor_modulo(a, b);
    case Operator::shift_left:
      return shift_left(a, shift_count(b));
    case Operator::shift_right:
      return shift_right(a, shift_count(b));
    case Operator::bit_and:
    case Operator::bit_or:
    case Operator::bit_xor:
      break;
    default:
      fail_operands(op, left, right);
  }
  Integer bits = op == Operator::bit_and ? (a & b) : op == Operator::bit_or ? (a | b) : (a ^ b);
  const bool both_bool = left.type() == Type::boolean && right.type() == Type::boolean;
  return both_bool ? Value(!bits.is_zero()) : Value(std::move(bits));
}

/// What an operation with integers beyond 64 bits, or one that can make such, takes.
std::size_t cost_of(Operator op, const Integer& a, const Integer& b) {
  switch (op) {
    case Operator::power: {
      const bool is_bounded = b.is_small() && b.small() > 0 && b.small() <= static_cast<std::int64_t>(kMaxIntegerBits);
      const std::size_t bytes = is_bounded ? bit_length(a) * static_cast<std::size_t>(b.small()) / 8 : 0;
      return cost_of_product(bytes, std::min(bytes, kMaxIntegerBits / 8));
    }
    case Operator::multiply:
      return cost_of_product(bytes_of(a), bytes_of(b)) + cost_of_block(bytes_of(a) + bytes_of(b));
    case Operator::shift_left:
      return cost_of_block(bytes_of(a)) + (b.is_small() && b.small() > 0 ? cost_of_block(b.small() / 8) : 0);
    case Operator::divide:
    case Operator::floor_divide:
    case Operator::modulo:
      return cost_of_division(a, b);
    default:
      return cost_of_block(bytes_of(a) + bytes_of(b));
  }
}

Value number_operation(Runtime& runtime, Operator op, const Value& a, const Value& b) {
  const auto i = as_integer(a);
  const auto j = as_integer(b);
  if (i && j) runtime.budget.spend(cost_of(op, *i, *j));
  if (op == Operator::power) return raise_to(a, b);
  return i && j ? integer_operation(op, *i, *j, a, b) : real_operation(op, a, b);
}

/// How often a sequence of `size` is repeated; negative counts are 0, and the result stays in bounds.
std::size_t repetitions(const Integer& count, std::size_t size, std::size_t limit) {
  if (count.is_negative() || count.is_zero() || size == 0) return 0;
  const bool fits = count.is_small() && static_cast<std::uint64_t>(count.small()) <= limit / size;
  if (!fits) fail_limit("the repetition is too long");
  return static_cast<std::size_t>(count.small());
}

Value repeat(Runtime& runtime, const Value& sequence, const Integer& count) {
  if (const auto* text = sequence.text()) {
    std::string repeated;
    const std::size_t times = repetitions(count, text->size(), kMaxText);
    runtime.budget.spend(times / 8 + cost_of_block(times * text->size()));
    repeated.reserve(times * text->size());
    for (std::size_t i = 0; i < times; ++i) repeated += *text;
    return repeated;
  }
  const auto* list = sequence.object<List>();
  const Values& items = list != nullptr ? *list->items : sequence.object<const Tuple>()->items;
  const std::size_t times = repetitions(count, items.size(), kMaxItems);
  runtime.budget.spend(times * items.size());
  Values repeated;
  repeated.reserve(times * items.size());
  for (std::size_t i = 0; i < times; ++i) repeated.insert(repeated.end(), items.begin(), items.end());
  return list != nullptr ? make_list(std::move(repeated)) : make_tuple(std::move(repeated));
}

Values joined(Runtime& runtime, const Values& a, const Values& b) {
  if (a.size() + b.size() > kMaxItems) fail_limit("the list is too long");
  runtime.budget.spend(a.size() + b.size());
  Values all = a;
  all.insert(all.end(), b.begin(), b.end());
  return all;
}

Value add_sequences(Runtime& runtime, const Value& a, const Value& b) {
  if (a.text() != nullptr) {
    if (b.text() == nullptr) {
      fail_eval(fmt::format("can only concatenate str (not \"{}\") to str", type_name(b)));
    }
    if (a.text()->size() + b.text()->size() > kMaxText) fail_limit("the text is too long");
    runtime.budget.spend(cost_of_block(a.text()->size() + b.text()->size()));
    return *a.text() + *b.text();
  }
  if (const auto* x = a.object<List>()) {
    const auto* y = b.object<List>();
    if (y == nullptr) fail_eval(fmt::format("can only concatenate list (not \"{}\") to list", type_name(b)));
    return make_list(joined(runtime, *x->items, *y->items));
  }
  if (const auto* x = a.object<const Tuple>()) {
    const auto* y = b.object<const Tuple>();
    if (y == nullptr) fail_eval(fmt::format("can only concatenate tuple (not \"{}\") to tuple", type_name(b)));
    return make_tuple(joined(runtime, x->items, y->items));
  }
  fail_operands(Operator::add, a, b);
}

bool is_sequence(const Value& value) {
  return value.text() != nullptr || value.object<List>() != nullptr || value.object<const Tuple>() != nullptr;
}

Value multiply_sequence(Runtime& runtime, const Value& a, const Value& b) {
  const Value& sequence = is_sequence(a) ? a : b;
  const Value& count = is_sequence(a) ? b : a;
  const auto times = as_integer(count);
  if (!times) {
    fail_eval(fmt::format("can't multiply sequence by non-int of type '{}'", type_name(count)));
  }
  return repeat(runtime, sequence, *times);
}

/// The items a set operation works on: sets, and the views of dicts that act like sets.
std::shared_ptr<Set> as_set(Runtime& runtime, const Value& value) {
  const bool is_view = value.type() == Type::dict_keys || value.type() == Type::dict_items;
  if (value.object<Set>() == nullptr && !is_view) return nullptr;
  auto set = std::make_shared<Set>();
  set->is_frozen = value.type() == Type::frozen_set;
  for (Value& item : items_of(runtime, value)) set->table.set(runtime, std::move(item), {});
  return set;
}

/// |, &, -, ^ of two sets; null when one is none.
std::shared_ptr<Set> set_operation(Runtime& runtime, Operator op, const Value& a, const Value& b) {
  const auto x = as_set(runtime, a);
  const auto y = as_set(runtime, b);
  if (!x || !y) return nullptr;
  auto result = std::make_shared<Set>();
  result->is_frozen = x->is_frozen;
  const auto add_if = [&](const Set& from, const Set& other, bool wanted) {
    for (const auto& entry : from.table.entries()) {
      if ((other.table.find(runtime, entry.first) != nullptr) == wanted) result->table.set(runtime, entry.first, {});
    }
  };
  switch (op) {
    case Operator::bit_and:
      add_if(*x, *y, true);
      return result;
    case Operator::subtract:
      add_if(*x, *y, false);
      return result;
    case Operator::bit_xor:
      add_if(*x, *y, false), add_if(*y, *x, false);
      return result;
    case Operator::bit_or:
      add_if(*x, *x, true), add_if(*y, *x, false);
      return result;
    default:
      return nullptr;
  }
}

/// `{..} | {..}`: the right one wins.
Value merge_dicts(Runtime& runtime, const Dict& a, const Dict& b) {
  runtime.budget.spend(a.table->entries().size());
  auto table = std::make_shared<Table>(*a.table);
  for (const auto& [key, value] : b.table->entries()) table->set(runtime, key, value);
  return make_dict(std::move(table));
}

}  // namespace

Value raise_to(const Value& base, const Value& exponent) {
  const auto i = as_integer(base);
  const auto j = as_integer(exponent);
  if (i && j && !j->is_negative()) return power(*i, *j);
  const double x = as_double(base);
  const double y = as_double(exponent);
  if (x == 0.0 && y < 0) fail_eval("0.0 cannot be raised to a negative power");
  if (x < 0 && std::isfinite(x) && std::isfinite(y) && y != std::floor(y)) {
    fail_eval("complex numbers are not supported: a negative number cannot be raised to a fractional power");
  }
  const double result = std::pow(x, y);
  if (std::isinf(result) && std::isfinite(x) && std::isfinite(y)) fail_eval("(34, 'Numerical result out of range')");
  return result;
}

Value operate(Runtime& runtime, Operator op, const Value& a, const Value& b) {
  if (is_number(a) && is_number(b)) return number_operation(runtime, op, a, b);
  if (op == Operator::modulo && a.text() != nullptr) return format_percent(runtime, *a.text(), b);
  if (op == Operator::add && is_sequence(a)) return add_sequences(runtime, a, b);
  if (op == Operator::multiply && (is_sequence(a) || is_sequence(b))) return multiply_sequence(runtime, a, b);
  if (auto set = set_operation(runtime, op, a, b)) return set;
  if (op == Operator::bit_or && a.object<Dict>() != nullptr && b.object<Dict>() != nullptr) {
    return merge_dicts(runtime, *a.object<Dict>(), *b.object<Dict>());
  }
  fail_operands(op, a, b);
}

Value operate(Runtime& runtime, Operator op, const Value& a) {
  runtime.budget.spend(cost_of_block(bytes_of(a)));
  if (op == Operator::logical_not) return !is_true(a);
  const auto i = as_integer(a);
  const double* d = as_real(a);
  if (op == Operator::negate) {
    if (i) return -*i;
    if (d != nullptr) return -*d;
    fail_eval(fmt::format("bad operand type for unary -: '{}'", type_name(a)));
  }
  if (op == Operator::plus) {
    if (i) return *i;
    if (d != nullptr) return *d;
    fail_eval(fmt::format("bad operand type for unary +: '{}'", type_name(a)));
  }
  if (!i) fail_eval(fmt::format("bad operand type for unary ~: '{}'", type_name(a)));
  return Integer(-1) - *i;
}

bool compare(Runtime& runtime, Operator op, const Value& a, const Value& b) {
  switch (op) {
    case Operator::equal:
      return equal(runtime, a, b);
    case Operator::not_equal:
      return !equal(runtime, a, b);
    case Operator::in:
      return contains(runtime, b, a);
    case Operator::not_in:
      return !contains(runtime, b, a);
    case Operator::is:
      return identical(a, b);
    case Operator::is_not:
      return !identical(a, b);
    default:
      return ordered(runtime, a, b, spelling(op));
  }
}

}  // namespace finemote::gen::expression
