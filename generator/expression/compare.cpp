#include "generator/expression/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "generator/expression/cost.hpp"
#include "generator/expression/runtime.hpp"

namespace finemote::gen::expression {
namespace {

Level deeper(Runtime& runtime) {
  return Level(runtime.depth, kMaxEvalDepth, "maximum recursion depth exceeded in comparison");
}

/// Exact comparison of an integer with a float, which is no nan.
std::partial_ordering compare_mixed(const Integer& i, double d) {
  if (std::isinf(d)) return d > 0 ? std::partial_ordering::less : std::partial_ordering::greater;
  const Integer whole = integer_of(d);
  if (i != whole) return i < whole ? std::partial_ordering::less : std::partial_ordering::greater;
  const double fraction = d - std::trunc(d);
  if (fraction == 0.0) return std::partial_ordering::equivalent;
  return fraction > 0 ? std::partial_ordering::less : std::partial_ordering::greater;
}

std::partial_ordering flip(std::partial_ordering o) {
  if (o == std::partial_ordering::less) return std::partial_ordering::greater;
  return o == std::partial_ordering::greater ? std::partial_ordering::less : o;
}

/// Numbers compare by value, whatever their types; nothing when one is no number.
std::optional<std::partial_ordering> compare_numbers(const Value& a, const Value& b) {
  const auto i = as_integer(a);
  const auto j = as_integer(b);
  if (i && j) return *i <=> *j;
  const double* x = as_real(a);
  const double* y = as_real(b);
  if (x != nullptr && y != nullptr) return *x <=> *y;
  if (i && y != nullptr) return std::isnan(*y) ? std::partial_ordering::unordered : compare_mixed(*i, *y);
  if (x != nullptr && j) return std::isnan(*x) ? std::partial_ordering::unordered : flip(compare_mixed(*j, *x));
  return std::nullopt;
}

/// Identical or equal, as the containers of Python compare their items.
bool same(Runtime& runtime, const Value& a, const Value& b) {
  runtime.budget.spend(1 + cost_of_block(bytes_of(a)));
  return identical(a, b) || equal(runtime, a, b);
}

bool equal_items(Runtime& runtime, const Values& a, const Values& b) {
  if (a.size() != b.size()) return false;
  const Level level = deeper(runtime);
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!same(runtime, a[i], b[i])) return false;
  }
  return true;
}

bool equal_dicts(Runtime& runtime, const Table& a, const Table& b) {
  if (a.entries().size() != b.entries().size()) return false;
  const Level level = deeper(runtime);
  return std::all_of(a.entries().begin(), a.entries().end(), [&](const Table::Entry& entry) {
    const Value* other = b.find(runtime, entry.first);
    return other != nullptr && equal(runtime, entry.second, *other);
  });
}

bool is_subset(Runtime& runtime, const Table& a, const Table& b) {
  return a.entries().size() <= b.entries().size() &&
         std::all_of(a.entries().begin(), a.entries().end(),
                     [&](const Table::Entry& entry) { return b.find(runtime, entry.first) != nullptr; });
}

bool equal_ranges(const Range& a, const Range& b) {
  if (a.size() != b.size() || a.size() == 0) return a.size() == b.size();
  return a.start == b.start && (a.size() == 1 || a.step == b.step);
}

template <typename T>
bool satisfies(std::string_view symbol, T order) {
  if (symbol == "<") return order < 0;
  if (symbol == "<=") return order <= 0;
  if (symbol == ">") return order > 0;
  return order >= 0;
}

[[noreturn]] void fail_order(const Value& a, const Value& b, std::string_view symbol) {
  fail_eval(fmt::format("'{}' not supported between instances of '{}' and '{}'", symbol, type_name(a), type_name(b)));
}

/// Sequences compare by their first differing items.
bool ordered_items(Runtime& runtime, const Values& a, const Values& b, std::string_view symbol) {
  const Level level = deeper(runtime);
  const std::size_t common = std::min(a.size(), b.size());
  for (std::size_t i = 0; i < common; ++i) {
    if (!same(runtime, a[i], b[i])) return ordered(runtime, a[i], b[i], symbol);
  }
  return satisfies(symbol, a.size() <=> b.size());
}

bool ordered_sets(Runtime& runtime, const Set& a, const Set& b, std::string_view symbol) {
  if (symbol[0] == '>') return ordered_sets(runtime, b, a, symbol == ">" ? "<" : "<=");
  if (symbol == "<" && a.table.entries().size() >= b.table.entries().size()) return false;
  return is_subset(runtime, a.table, b.table);
}

}  // namespace

bool identical(const Value& a, const Value& b) {
  if (a.storage().index() != b.storage().index()) return false;
  if (a.is_none()) return true;
  if (const auto* x = a.as<bool>()) return *x == *b.as<bool>();
  if (const auto* x = a.as<Integer>()) return *x == *b.as<Integer>();
  if (const auto* x = a.as<Value::Text>()) return *x == *b.as<Value::Text>() || **x == **b.as<Value::Text>();
  if (const auto* x = a.as<Type>()) return *x == *b.as<Type>();
  if (const auto* x = a.object<List>()) return x == b.object<List>();
  if (const auto* x = a.object<Dict>()) return x == b.object<Dict>();
  if (const auto* x = a.object<Set>()) return x == b.object<Set>();
  if (const auto* x = a.object<const Tuple>()) return x == b.object<const Tuple>();
  if (const auto* x = a.as<const Builtin*>()) return *x == *b.as<const Builtin*>();
  if (const auto* x = a.as<NamespaceRef>()) return x->scope == b.as<NamespaceRef>()->scope;
  return false;
}

bool equal(Runtime& runtime, const Value& a, const Value& b) {
  runtime.budget.spend(1 + cost_of_block(bytes_of(a)));
  if (const auto numbers = compare_numbers(a, b)) return *numbers == 0;
  if (a.text() != nullptr && b.text() != nullptr) return *a.text() == *b.text();
  if (const auto* x = a.object<List>(), *y = b.object<List>(); x != nullptr && y != nullptr) {
    return equal_items(runtime, *x->items, *y->items);
  }
  if (const auto* x = a.object<const Tuple>(), *y = b.object<const Tuple>(); x != nullptr && y != nullptr) {
    return equal_items(runtime, x->items, y->items);
  }
  if (const auto* x = a.object<Dict>(), *y = b.object<Dict>(); x != nullptr && y != nullptr) {
    return equal_dicts(runtime, *x->table, *y->table);
  }
  if (const auto* x = a.object<Set>(), *y = b.object<Set>(); x != nullptr && y != nullptr) {
    return x->table.entries().size() == y->table.entries().size() && is_subset(runtime, x->table, y->table);
  }
  if (const auto* x = a.object<const Range>(), *y = b.object<const Range>(); x != nullptr && y != nullptr) {
    return equal_ranges(*x, *y);
  }
  return identical(a, b);
}

bool ordered(Runtime& runtime, const Value& a, const Value& b, std::string_view symbol) {
  runtime.budget.spend(1 + cost_of_block(bytes_of(a)));
  if (const auto numbers = compare_numbers(a, b)) return satisfies(symbol, *numbers);
  if (a.text() != nullptr && b.text() != nullptr) return satisfies(symbol, a.text()->compare(*b.text()) <=> 0);
  if (const auto* x = a.object<List>(), *y = b.object<List>(); x != nullptr && y != nullptr) {
    return ordered_items(runtime, *x->items, *y->items, symbol);
  }
  if (const auto* x = a.object<const Tuple>(), *y = b.object<const Tuple>(); x != nullptr && y != nullptr) {
    return ordered_items(runtime, x->items, y->items, symbol);
  }
  if (const auto* x = a.object<Set>(), *y = b.object<Set>(); x != nullptr && y != nullptr) {
    return ordered_sets(runtime, *x, *y, symbol);
  }
  fail_order(a, b, symbol);
}

namespace {

std::size_t combine(std::size_t seed, std::size_t hash) { return (seed ^ hash) * 0x9E3779B97F4A7C15ULL + 0x7F4A7C15; }

std::size_t hash_integer(const Integer& i) {
  if (i.is_small()) return std::hash<std::int64_t>{}(i.small());
  return std::hash<std::string>{}(i.to_string(16));
}

std::size_t hash_real(double d) {
  if (std::isfinite(d) && d == std::trunc(d)) return hash_integer(integer_of(d));
  return std::hash<double>{}(d);
}

std::size_t hash_tuple(Runtime& runtime, const Tuple& tuple) {
  const Level level = deeper(runtime);
  std::size_t hash = tuple.items.size();
  for (const Value& item : tuple.items) hash = combine(hash, hash_of(runtime, item));
  return hash;
}

}  // namespace

std::size_t hash_of(Runtime& runtime, const Value& value) {
  runtime.budget.spend(1 + cost_of_bytes(bytes_of(value)));
  if (const auto i = as_integer(value)) return hash_integer(*i);
  switch (value.type()) {
    case Type::none:
      return 0x4E6F6E65;
    case Type::real:
      return hash_real(*value.as<double>());
    case Type::text:
      return std::hash<std::string>{}(*value.text());
    case Type::tuple:
      return hash_tuple(runtime, *value.object<const Tuple>());
    case Type::type:
      return static_cast<std::size_t>(*value.as<Type>()) + 1000;
    case Type::builtin:
      return std::hash<const void*>{}(*value.as<const Builtin*>());
    case Type::frozen_set: {
      std::size_t hash = 0;
      for (const auto& entry : value.object<Set>()->table.entries()) hash += combine(7, hash_of(runtime, entry.first));
      return hash;
    }
    default:
      fail_eval(fmt::format("unhashable type: '{}'", type_name(value)));
  }
}

void sort_values(Runtime& runtime, Values& items, bool reverse) {
  // A comparison that fails leaves the algorithm by an exception; nan breaks no invariant that merging needs.
  const auto less = [&](const Value& a, const Value& b) {
    return reverse ? ordered(runtime, b, a, "<") : ordered(runtime, a, b, "<");
  };
  std::stable_sort(items.begin(), items.end(), less);
}

}  // namespace finemote::gen::expression
