// Types that are called: int(), list(), dict() ...
#include <fmt/format.h>

#include <algorithm>

#include "generator/expression/budget.hpp"
#include "generator/expression/builtins.hpp"
#include "generator/expression/evaluate.hpp"
#include "generator/expression/iterate.hpp"
#include "generator/expression/number.hpp"
#include "generator/expression/parameters.hpp"
#include "generator/expression/print.hpp"
#include "generator/expression/runtime.hpp"

namespace finemote::gen::expression {
namespace {

/// int(text, base): base 0 goes by the prefix.
Value integer_from_text(Runtime& runtime, const Value& value, std::int64_t base) {
  std::string_view text = stripped(*value.text());
  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.remove_prefix(1);
  const auto has_prefix = [&](char letter) { return text.size() > 2 && text[0] == '0' && (text[1] | 0x20) == letter; };
  for (const auto& [letter, meant] : {std::pair('x', 16), std::pair('o', 8), std::pair('b', 2)}) {
    if ((base == meant || base == 0) && has_prefix(letter)) {
      text.remove_prefix(2);
      base = meant;
      break;
    }
  }
  const auto digits = without_underscores(text);
  const auto i = digits ? parse_digits(*digits, base == 0 ? 10 : static_cast<unsigned>(base)) : std::nullopt;
  if (!i) fail_eval(fmt::format("invalid literal for int() with base {}: {}", base, to_source(runtime, value)));
  return negative ? -*i : *i;
}

Value make_integer(Runtime& runtime, const Parameters& p) {
  if (p[0] == nullptr) return 0;
  const std::int64_t base = p.integer(1, 10);
  if (base != 0 && (base < 2 || base > 36)) fail_eval("int() base must be >= 2 and <= 36, or 0");
  if (p.at(0).text() != nullptr) return integer_from_text(runtime, p.at(0), base);
  if (p[1] != nullptr) fail_eval("int() can't convert non-string with explicit base");
  if (const auto i = as_integer(p.at(0))) return *i;
  if (const double* d = as_real(p.at(0))) return integer_of(*d);
  fail_eval(fmt::format("int() argument must be a string, a bytes-like object or a real number, not '{}'",
                        type_name(p.at(0))));
}

Value make_real(Runtime& runtime, const Parameters& p) {
  if (p[0] == nullptr) return 0.0;
  if (const auto* text = p.at(0).text()) {
    const auto value = parse_real(*text);
    if (!value) fail_eval("could not convert string to float: " + to_source(runtime, p.at(0)));
    return *value;
  }
  if (const auto i = as_integer(p.at(0))) return i->to_double();
  if (const double* d = as_real(p.at(0))) return *d;
  fail_eval(fmt::format("float() argument must be a string or a real number, not '{}'", type_name(p.at(0))));
}

Value make_text(Runtime& runtime, const Parameters& p) {
  return p[0] != nullptr ? to_text(runtime, p.at(0)) : std::string();
}

Value make_boolean(Runtime& /*runtime*/, const Parameters& p) { return p[0] != nullptr && is_true(p.at(0)); }

Values optional_items(Runtime& runtime, const Parameters& p) {
  return p[0] != nullptr ? items_of(runtime, p.at(0)) : Values();
}

Value list_of(Runtime& runtime, const Parameters& p) { return make_list(optional_items(runtime, p)); }
Value tuple_of(Runtime& runtime, const Parameters& p) { return make_tuple(optional_items(runtime, p)); }
Value dict_of(Runtime& runtime, const Parameters& p) { return make_dict(table_of(runtime, p.all(), p.function())); }

template <bool IsFrozen>
Value make_set(Runtime& runtime, const Parameters& p) {
  auto set = std::make_shared<Set>();
  set->is_frozen = IsFrozen;
  for (Value& item : optional_items(runtime, p)) set->table.set(runtime, std::move(item), {});
  return set;
}

std::int64_t range_bound(const Value& value) {
  const auto i = as_integer(value);
  if (!i) fail_eval(fmt::format("'{}' object cannot be interpreted as an integer", type_name(value)));
  constexpr std::int64_t far = std::int64_t{1} << 60;
  if (!i->is_small() || i->small() > far || i->small() < -far) fail_limit("the range is too large");
  return i->small();
}

Value make_range(Runtime& /*runtime*/, const Parameters& p) {
  const Values& given = p.positional();
  Range range;
  if (given.size() == 1) {
    range.stop = range_bound(given[0]);
  } else {
    range.start = range_bound(given[0]);
    range.stop = range_bound(given[1]);
  }
  if (given.size() == 3) range.step = range_bound(given[2]);
  if (range.step == 0) fail_eval("range() arg 3 must not be zero");
  return std::make_shared<const Range>(range);
}

Value make_slice(Runtime& /*runtime*/, const Parameters& p) {
  Values bounds(3);
  if (p[1] == nullptr) {
    bounds[1] = p.at(0);
  } else {
    for (std::size_t i = 0; i < 3; ++i) bounds[i] = p[i] != nullptr ? p.at(i) : Value();
  }
  return std::make_shared<const Slice>(Slice{std::make_shared<const Values>(std::move(bounds))});
}

/// The items of every argument from `first` on, cut to the shortest.
std::vector<Values> columns_of(Runtime& runtime, const Values& arguments, std::size_t first) {
  std::vector<Values> columns;
  std::size_t shortest = static_cast<std::size_t>(-1);
  for (std::size_t i = first; i < arguments.size(); ++i) {
    columns.push_back(items_of(runtime, arguments[i]));
    shortest = std::min(shortest, columns.back().size());
  }
  for (Values& column : columns) column.resize(shortest);
  return columns;
}

Values row_of(const std::vector<Values>& columns, std::size_t i) {
  Values row;
  for (const Values& column : columns) row.push_back(column[i]);
  return row;
}

Value make_map(Runtime& runtime, const Parameters& p) {
  if (p.positional().size() < 2) fail_eval("map() must have at least two arguments.");
  const auto columns = columns_of(runtime, p.positional(), 1);
  Values results;
  for (std::size_t i = 0; i < columns[0].size(); ++i) {
    CallArguments row{row_of(columns, i), {}};
    results.push_back(call_value(runtime, p.positional()[0], row));
  }
  return make_iterator(Type::map, std::move(results));
}

Value make_zip(Runtime& runtime, const Parameters& p) {
  for (const auto& [name, value] : p.all().named) {
    if (name != "strict") fail_eval(fmt::format("zip() got an unexpected keyword argument '{}'", name));
  }
  if (p.positional().empty()) return make_iterator(Type::zip, {});
  const auto columns = columns_of(runtime, p.positional(), 0);
  Values rows;
  runtime.budget.spend(columns.size() * columns[0].size());
  for (std::size_t i = 0; i < columns[0].size(); ++i) rows.push_back(make_tuple(row_of(columns, i)));
  return make_iterator(Type::zip, std::move(rows));
}

Value make_filter(Runtime& runtime, const Parameters& p) {
  Values kept;
  for (Value& item : items_of(runtime, p.at(1))) {
    CallArguments one{{item}, {}};
    const bool wanted = is_true(p.at(0).is_none() ? item : call_value(runtime, p.at(0), one));
    if (wanted) kept.push_back(std::move(item));
  }
  return make_iterator(Type::filter, std::move(kept));
}

Value make_enumerate(Runtime& runtime, const Parameters& p) {
  std::int64_t number = p.integer(1, 0);
  Values pairs;
  for (Value& item : items_of(runtime, p.at(0))) pairs.push_back(make_tuple({number++, std::move(item)}));
  return make_iterator(Type::enumerate, std::move(pairs));
}

Value make_reversed(Runtime& runtime, const Parameters& p) {
  const bool is_unordered = p.at(0).object<Set>() != nullptr || p.at(0).object<Iterator>() != nullptr;
  if (is_unordered) fail_eval(fmt::format("'{}' object is not reversible", type_name(p.at(0))));
  Values items = items_of(runtime, p.at(0));
  std::reverse(items.begin(), items.end());
  return make_iterator(Type::reversed, std::move(items));
}

void add_pairs(Runtime& runtime, Table& table, const Value& pairs) {
  std::size_t i = 0;
  for (const Value& pair : items_of(runtime, pairs)) {
    if (pair.text() == nullptr && pair.object<List>() == nullptr && pair.object<const Tuple>() == nullptr) {
      fail_eval(fmt::format("cannot convert dictionary update sequence element #{} to a sequence", i));
    }
    Values parts = items_of(runtime, pair);
    if (parts.size() != 2) {
      fail_eval(fmt::format("dictionary update sequence element #{} has length {}; 2 is required", i, parts.size()));
    }
    table.set(runtime, std::move(parts[0]), std::move(parts[1]));
    ++i;
  }
}

struct Constructor {
  Type type;
  Builtin function;
};

constexpr Signature kItems({"iterable"}, 0);

constexpr Constructor kConstructors[] = {{Type::integer, {"int", {{"x", "base"}, 0}, make_integer}},
                                         {Type::real, {"float", {{"x"}, 0}, make_real}},
                                         {Type::text, {"str", {{"object"}, 0}, make_text}},
                                         {Type::boolean, {"bool", {{"x"}, 0}, make_boolean}},
                                         {Type::list, {"list", kItems, list_of}},
                                         {Type::tuple, {"tuple", kItems, tuple_of}},
                                         {Type::dict, {"dict", Signature::free(), dict_of}},
                                         {Type::set, {"set", kItems, make_set<false>}},
                                         {Type::frozen_set, {"frozenset", kItems, make_set<true>}},
                                         {Type::range, {"range", Signature::positional(1, 3), make_range}},
                                         {Type::slice, {"slice", {{"start", "stop", "step"}, 1}, make_slice}},
                                         {Type::map, {"map", Signature::positional(0), make_map}},
                                         {Type::zip, {"zip", Signature::free(), make_zip}},
                                         {Type::filter, {"filter", {{"function", "iterable"}, 2}, make_filter}},
                                         {Type::enumerate, {"enumerate", {{"iterable", "start"}, 1}, make_enumerate}},
                                         {Type::reversed, {"reversed", {{"sequence"}, 1}, make_reversed}}};

}  // namespace

std::shared_ptr<Table> table_of(Runtime& runtime, const CallArguments& arguments, std::string_view function) {
  if (arguments.positional.size() > 1) {
    fail_eval(fmt::format("{} expected at most 1 argument, got {}", function, arguments.positional.size()));
  }
  auto table = std::make_shared<Table>();
  if (!arguments.positional.empty()) {
    const Value& source = arguments.positional[0];
    if (const auto* dict = source.object<Dict>()) {
      runtime.budget.spend(dict->table->entries().size());
      *table = *dict->table;
    } else {
      add_pairs(runtime, *table, source);
    }
  }
  for (auto& [name, value] : arguments.named) table->set(runtime, Value(name), value);
  return table;
}

Value construct(Runtime& runtime, Type type, CallArguments& arguments) {
  for (const auto& [made, function] : kConstructors) {
    if (made == type) return function.call(runtime, Parameters(arguments, function.name, function.takes));
  }
  fail_eval(fmt::format("cannot create '{}' instances", type_name(type)));
}

}  // namespace finemote::gen::expression
