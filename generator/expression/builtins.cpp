#include "generator/expression/builtins.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "generator/expression/compare.hpp"
#include "generator/expression/cost.hpp"
#include "generator/expression/evaluate.hpp"
#include "generator/expression/iterate.hpp"
#include "generator/expression/operate.hpp"
#include "generator/expression/parameters.hpp"
#include "generator/expression/print.hpp"
#include "generator/expression/real_format.hpp"
#include "generator/expression/runtime.hpp"
#include "generator/expression/utf8.hpp"

namespace finemote::gen::expression {
namespace {

Value len(Runtime& /*runtime*/, const Parameters& p) { return static_cast<std::int64_t>(size_of(p.at(0))); }

/// Takes the keyword `name` out of the arguments; nothing when it is not there.
std::optional<Value> take_keyword(CallArguments& arguments, std::string_view name) {
  const auto found = std::find_if(arguments.named.begin(), arguments.named.end(),
                                  [&](const auto& argument) { return argument.first == name; });
  if (found == arguments.named.end()) return std::nullopt;
  Value value = std::move(found->second);
  arguments.named.erase(found);
  return value;
}

Value key_of(Runtime& runtime, const std::optional<Value>& key, const Value& item) {
  if (!key || key->is_none()) return item;
  CallArguments one{{item}, {}};
  return call_value(runtime, *key, one);
}

/// min() and max(): of several arguments or of the items of one.
Value extreme(Runtime& runtime, const Parameters& p, std::string_view better) {
  CallArguments& arguments = p.all();
  const auto key = take_keyword(arguments, "key");
  const auto otherwise = take_keyword(arguments, "default");
  check_no_keywords(arguments, p.function());
  if (arguments.positional.empty()) fail_eval(fmt::format("{} expected at least 1 argument, got 0", p.function()));
  const bool is_one = arguments.positional.size() == 1;
  const Values items = is_one ? items_of(runtime, arguments.positional[0]) : arguments.positional;
  if (items.empty()) {
    if (otherwise) return *otherwise;
    fail_eval(fmt::format("{}() arg is an empty sequence", p.function()));
  }
  Value best = items[0];
  Value best_key = key_of(runtime, key, best);
  for (std::size_t i = 1; i < items.size(); ++i) {
    Value item_key = key_of(runtime, key, items[i]);
    if (!ordered(runtime, item_key, best_key, better)) continue;
    best = items[i];
    best_key = std::move(item_key);
  }
  return best;
}

Value min(Runtime& runtime, const Parameters& p) { return extreme(runtime, p, "<"); }
Value max(Runtime& runtime, const Parameters& p) { return extreme(runtime, p, ">"); }

/// To a multiple of 10^places, ties to even.
Integer round_integer(Runtime& runtime, const Integer& i, std::int64_t places) {
  if (places > 4000) return 0;
  const Integer unit = power(10, places);
  runtime.budget.spend(cost_of_product(bytes_of(unit), bytes_of(unit)) + 2 * cost_of_division(i, unit));
  const Integer below = floor_divide(i, unit);
  const Integer rest = i - below * unit;
  const Integer twice = rest + rest;
  const bool up = twice > unit || (twice == unit && !floor_modulo(below, 2).is_zero());
  return (up ? below + 1 : below) * unit;
}

Value round(Runtime& runtime, const Parameters& p) {
  const bool to_whole = p[1] == nullptr || p.at(1).is_none();
  const std::int64_t digits = p.integer(1, 0);
  if (const auto i = as_integer(p.at(0))) return digits < 0 ? round_integer(runtime, *i, -digits) : *i;
  const double* d = as_real(p.at(0));
  if (d == nullptr) fail_eval(fmt::format("type {} doesn't define __round__ method", type_name(p.at(0))));
  if (to_whole) return integer_of(std::nearbyint(*d));
  return round_to(*d, static_cast<long>(digits));
}

Value absolute(Runtime& /*runtime*/, const Parameters& p) {
  if (const auto i = as_integer(p.at(0))) return i->is_negative() ? -*i : *i;
  if (const double* d = as_real(p.at(0))) return std::abs(*d);
  fail_eval(fmt::format("bad operand type for abs(): '{}'", type_name(p.at(0))));
}

Value all(Runtime& runtime, const Parameters& p) {
  const Values items = items_of(runtime, p.at(0));
  return std::all_of(items.begin(), items.end(), is_true);
}

Value any(Runtime& runtime, const Parameters& p) {
  const Values items = items_of(runtime, p.at(0));
  return std::any_of(items.begin(), items.end(), is_true);
}

Value divmod(Runtime& runtime, const Parameters& p) {
  return make_tuple({operate(runtime, Operator::floor_divide, p.at(0), p.at(1)),
                     operate(runtime, Operator::modulo, p.at(0), p.at(1))});
}

Value hash(Runtime& runtime, const Parameters& p) {
  if (const auto i = as_integer(p.at(0)); i && i->is_small()) return *i;
  return static_cast<std::int64_t>(hash_of(runtime, p.at(0)) >> 3);
}

/// True when a value of type `type` counts as one of `wanted`: bool is an int.
bool is_subtype(Type type, Type wanted) { return type == wanted || (type == Type::boolean && wanted == Type::integer); }

/// The types that isinstance() and issubclass() test for: one or a tuple.
bool matches_type(const Value& wanted, Type type, std::string_view function) {
  if (const auto* one = wanted.as<Type>()) return is_subtype(type, *one);
  if (const auto* several = wanted.object<const Tuple>()) {
    return std::any_of(several->items.begin(), several->items.end(),
                       [&](const Value& v) { return matches_type(v, type, function); });
  }
  fail_eval(fmt::format("{}() arg 2 must be a type, a tuple of types, or a union", function));
}

Value isinstance(Runtime& /*runtime*/, const Parameters& p) {
  return matches_type(p.at(1), p.at(0).type(), "isinstance");
}

Value issubclass(Runtime& /*runtime*/, const Parameters& p) {
  const auto* type = p.at(0).as<Type>();
  if (type == nullptr) fail_eval("issubclass() arg 1 must be a class");
  return matches_type(p.at(1), *type, "issubclass");
}

Value ord(Runtime& /*runtime*/, const Parameters& p) {
  const auto* text = p.at(0).text();
  if (text == nullptr) {
    fail_eval(fmt::format("ord() expected string of length 1, but {} found", type_name(p.at(0))));
  }
  const std::size_t length = count_characters(*text);
  if (length != 1) fail_eval(fmt::format("ord() expected a character, but string of length {} found", length));
  return static_cast<std::int64_t>(code_point(*text));
}

Value repr(Runtime& runtime, const Parameters& p) { return to_source(runtime, p.at(0)); }

Value sorted(Runtime& runtime, const Parameters& p) {
  CallArguments& arguments = p.all();
  if (arguments.positional.size() != 1) {
    fail_eval(fmt::format("sorted expected 1 argument, got {}", arguments.positional.size()));
  }
  Values items = items_of(runtime, arguments.positional[0]);
  arguments.positional.clear();
  return make_list(sorted_items(runtime, std::move(items), arguments, p.function()));
}

Value sum(Runtime& runtime, const Parameters& p) {
  Value total = p[1] != nullptr ? p.at(1) : Value(0);
  if (total.text() != nullptr) fail_eval("sum() can't sum strings [use ''.join(seq) instead]");
  for (const Value& item : items_of(runtime, p.at(0))) total = operate(runtime, Operator::add, total, item);
  return total;
}

Value type_of(Runtime& /*runtime*/, const Parameters& p) { return p.at(0).type(); }

Value complex(Runtime& /*runtime*/, const Parameters& /*any*/) { fail_eval("complex numbers are not supported"); }

Value range(Runtime& runtime, const Parameters& p) { return construct(runtime, Type::range, p.all()); }

constexpr Builtin kLen{"len", {{"obj"}, 1}, len};
constexpr Builtin kMin{"min", Signature::free(), min};
constexpr Builtin kMax{"max", Signature::free(), max};
constexpr Builtin kRound{"round", {{"number", "ndigits"}, 1}, round};
constexpr Builtin kOldSorted{"sorted", Signature::free(), sorted, "python"};
constexpr Builtin kOldRange{"range", Signature::free(), range, "python"};

constexpr Builtin kPython[] = {{"abs", {{"x"}, 1}, absolute},
                               {"all", {{"iterable"}, 1}, all},
                               {"any", {{"iterable"}, 1}, any},
                               {"complex", Signature::free(), complex},
                               {"divmod", {{"x", "y"}, 2}, divmod},
                               {"hash", {{"obj"}, 1}, hash},
                               {"isinstance", {{"obj", "class_or_tuple"}, 2}, isinstance},
                               {"issubclass", {{"cls", "class_or_tuple"}, 2}, issubclass},
                               {"ord", {{"c"}, 1}, ord},
                               {"repr", {{"obj"}, 1}, repr},
                               {"sorted", Signature::free(), sorted},
                               {"sum", {{"iterable", "start"}, 1}, sum},
                               {"type", {{"object"}, 1}, type_of}};

/// Names both spaces have.
Symbols common_symbols() {
  return {{"list", Type::list},  {"dict", Type::dict},   {"map", Type::map}, {"str", Type::text},
          {"float", Type::real}, {"int", Type::integer}, {"len", &kLen},     {"min", &kMin},
          {"max", &kMax},        {"round", &kRound},     {"True", true},     {"False", false}};
}

}  // namespace

Values sorted_items(Runtime& runtime, Values items, CallArguments& arguments, std::string_view function) {
  const auto key = take_keyword(arguments, "key");
  const auto reverse = take_keyword(arguments, "reverse");
  if (!arguments.positional.empty()) fail_eval(fmt::format("{}() takes no positional arguments", function));
  if (!arguments.named.empty()) {
    fail_eval(fmt::format("'{}' is an invalid keyword argument for {}()", arguments.named[0].first, function));
  }
  const bool descending = reverse && is_true(*reverse);
  if (!key || key->is_none()) {
    sort_values(runtime, items, descending);
    return items;
  }
  struct Keyed {
    Value key;
    Value item;
  };
  std::vector<Keyed> keyed;
  for (Value& item : items) keyed.push_back({key_of(runtime, key, item), item});
  std::stable_sort(keyed.begin(), keyed.end(), [&](const Keyed& a, const Keyed& b) {
    return descending ? ordered(runtime, b.key, a.key, "<") : ordered(runtime, a.key, b.key, "<");
  });
  Values sorted;
  for (Keyed& k : keyed) sorted.push_back(std::move(k.item));
  return sorted;
}

Symbols python_symbols() {
  Symbols symbols = common_symbols();
  for (const Builtin& function : kPython) symbols.emplace_back(std::string(function.name), &function);
  for (const Type type : {Type::range, Type::enumerate, Type::filter, Type::frozen_set, Type::reversed, Type::slice,
                          Type::set, Type::tuple, Type::zip}) {
    symbols.emplace_back(std::string(type_name(type)), type);
  }
  return symbols;
}

Symbols global_symbols() {
  Symbols symbols = common_symbols();
  symbols.emplace_back("sorted", &kOldSorted);
  symbols.emplace_back("range", &kOldRange);
  for (auto& symbol : deprecated_xacro_symbols()) symbols.push_back(std::move(symbol));
  for (auto& symbol : math_symbols()) symbols.push_back(std::move(symbol));
  return symbols;
}

}  // namespace finemote::gen::expression
