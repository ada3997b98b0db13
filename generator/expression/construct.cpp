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

Value make_integer(Runtime& runtime, CallArguments& arguments) {
  const Parameters p(arguments, "int", {"x", "base"}, 0);
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

Value make_real(Runtime& runtime, CallArguments& arguments) {
  const Parameters p(arguments, "float", {"x"}, 0);
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

Value make_text(Runtime& runtime, CallArguments& arguments) {
  const Parameters p(arguments, "str", {"object"}, 0);
  return p[0] != nullptr ? to_text(runtime, p.at(0)) : std::string();
}

Value make_boolean(CallArguments& arguments) {
  const Parameters p(arguments, "bool", {"x"}, 0);
  return p[0] != nullptr && is_true(p.at(0));
}

Values optional_items(Runtime& runtime, CallArguments& arguments, std::string_view function) {
  const Parameters p(arguments, function, {"iterable"}, 0);
  return p[0] != nullptr ? items_of(runtime, p.at(0)) : Values();
}

Value make_set(Runtime& runtime, CallArguments& arguments, bool is_frozen) {
  auto set = std::make_shared<Set>();
  set->is_frozen = is_frozen;
  for (Value& item : optional_items(runtime, arguments, is_frozen ? "frozenset" : "set")) {
    set->table.set(runtime, std::move(item), {});
  }
  return set;
}

std::int64_t range_bound(const Value& value) {
  const auto i = as_integer(value);
  if (!i) fail_eval(fmt::format("'{}' object cannot be interpreted as an integer", type_name(value)));
  constexpr std::int64_t far = std::int64_t{1} << 60;
  if (!i->is_small() || i->small() > far || i->small() < -far) fail_limit("the range is too large");
  return i->small();
}

Value make_range(CallArguments& arguments) {
  check_no_keywords(arguments, "range");
  const Values& given = arguments.positional;
  if (given.empty()) fail_eval("range expected at least 1 argument, got 0");
  if (given.size() > 3) fail_eval(fmt::format("range expected at most 3 arguments, got {}", given.size()));
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

Value make_slice(CallArguments& arguments) {
  const Parameters p(arguments, "slice", {"start", "stop", "step"}, 1);
  Values bounds(3);
  if (p[1] == nullptr) {
    bounds[1] = p.at(0);
  } else {
    for (std::size_t i = 0; i < 3; ++i) bounds[i] = p[i] != nullptr ? p.at(i) : Value();
  }
  return std::make_shared<const Slice>(Slice{std::make_shared<const Values>(std::move(bounds))});
}

/// The items of every argument from `first` on, cut to the shortest.
std::vector<Values> columns_of(Runtime& runtime, const CallArguments& arguments, std::size_t first) {
  std::vector<Values> columns;
  std::size_t shortest = static_cast<std::size_t>(-1);
  for (std::size_t i = first; i < arguments.positional.size(); ++i) {
    columns.push_back(items_of(runtime, arguments.positional[i]));
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

Value make_map(Runtime& runtime, CallArguments& arguments) {
  check_no_keywords(arguments, "map");
  if (arguments.positional.size() < 2) fail_eval("map() must have at least two arguments.");
  const auto columns = columns_of(runtime, arguments, 1);
  Values results;
  for (std::size_t i = 0; i < columns[0].size(); ++i) {
    CallArguments row{row_of(columns, i), {}};
    results.push_back(call_value(runtime, arguments.positional[0], row));
  }
  return make_iterator(Type::map, std::move(results));
}

Value make_zip(Runtime& runtime, CallArguments& arguments) {
  for (const auto& [name, value] : arguments.named) {
    if (name != "strict") fail_eval(fmt::format("zip() got an unexpected keyword argument '{}'", name));
  }
  if (arguments.positional.empty()) return make_iterator(Type::zip, {});
  const auto columns = columns_of(runtime, arguments, 0);
  Values rows;
  runtime.budget.spend(columns.size() * columns[0].size());
  for (std::size_t i = 0; i < columns[0].size(); ++i) rows.push_back(make_tuple(row_of(columns, i)));
  return make_iterator(Type::zip, std::move(rows));
}

Value make_filter(Runtime& runtime, CallArguments& arguments) {
  const Parameters p(arguments, "filter", {"function", "iterable"}, 2);
  Values kept;
  for (Value& item : items_of(runtime, p.at(1))) {
    CallArguments one{{item}, {}};
    const bool wanted = is_true(p.at(0).is_none() ? item : call_value(runtime, p.at(0), one));
    if (wanted) kept.push_back(std::move(item));
  }
  return make_iterator(Type::filter, std::move(kept));
}

Value make_enumerate(Runtime& runtime, CallArguments& arguments) {
  const Parameters p(arguments, "enumerate", {"iterable", "start"}, 1);
  std::int64_t number = p.integer(1, 0);
  Values pairs;
  for (Value& item : items_of(runtime, p.at(0))) pairs.push_back(make_tuple({number++, std::move(item)}));
  return make_iterator(Type::enumerate, std::move(pairs));
}

Value make_reversed(Runtime& runtime, CallArguments& arguments) {
  const Parameters p(arguments, "reversed", {"sequence"}, 1);
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

}  // namespace

std::shared_ptr<Table> table_of(Runtime& runtime, CallArguments& arguments, std::string_view function) {
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
  switch (type) {
    case Type::integer:
      return make_integer(runtime, arguments);
    case Type::real:
      return make_real(runtime, arguments);
    case Type::text:
      return make_text(runtime, arguments);
    case Type::boolean:
      return make_boolean(arguments);
    case Type::list:
      return make_list(optional_items(runtime, arguments, "list"));
    case Type::tuple:
      return make_tuple(optional_items(runtime, arguments, "tuple"));
    case Type::dict:
      return make_dict(table_of(runtime, arguments, "dict"));
    case Type::set:
      return make_set(runtime, arguments, false);
    case Type::frozen_set:
      return make_set(runtime, arguments, true);
    case Type::range:
      return make_range(arguments);
    case Type::slice:
      return make_slice(arguments);
    case Type::map:
      return make_map(runtime, arguments);
    case Type::zip:
      return make_zip(runtime, arguments);
    case Type::filter:
      return make_filter(runtime, arguments);
    case Type::enumerate:
      return make_enumerate(runtime, arguments);
    case Type::reversed:
      return make_reversed(runtime, arguments);
    default:
      fail_eval(fmt::format("cannot create '{}' instances", type_name(type)));
  }
}

}  // namespace finemote::gen::expression
