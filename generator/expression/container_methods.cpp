// The methods of list, tuple, dict and set.
#include <fmt/format.h>

#include <algorithm>

#include "generator/expression/attribute.hpp"
#include "generator/expression/builtins.hpp"
#include "generator/expression/compare.hpp"
#include "generator/expression/evaluate.hpp"
#include "generator/expression/iterate.hpp"
#include "generator/expression/parameters.hpp"
#include "generator/expression/print.hpp"
#include "generator/expression/runtime.hpp"
#include "generator/expression/subscript.hpp"

namespace finemote::gen::expression {
namespace {

// ---- list ----

List& list_of(const Value& self) { return *self.object<List>(); }

void check_size(std::size_t size) {
  if (size > kMaxItems) fail_limit("the list is too long");
}

Value append(Runtime& runtime, const Value& self, CallArguments& arguments) {
  const Parameters p(arguments, "append", {"object"}, 1);
  check_no_cycle(runtime, self, p.at(0));
  check_size(list_of(self).items->size() + 1);
  list_of(self).to_change(runtime).push_back(p.at(0));
  return {};
}

Value extend(Runtime& runtime, const Value& self, CallArguments& arguments) {
  const Parameters p(arguments, "extend", {"iterable"}, 1);
  const Values more = items_of(runtime, p.at(0));
  for (const Value& item : more) check_no_cycle(runtime, self, item);
  check_size(list_of(self).items->size() + more.size());
  Values& items = list_of(self).to_change(runtime);
  items.insert(items.end(), more.begin(), more.end());
  return {};
}

Value insert(Runtime& runtime, const Value& self, CallArguments& arguments) {
  const Parameters p(arguments, "insert", {"index", "object"}, 2);
  check_no_cycle(runtime, self, p.at(1));
  Values& items = list_of(self).to_change(runtime);
  const auto size = static_cast<std::int64_t>(items.size());
  check_size(items.size() + 1);
  runtime.budget.spend(items.size());
  const std::int64_t at = p.integer(0, 0);
  items.insert(items.begin() + std::clamp<std::int64_t>(at < 0 ? at + size : at, 0, size), p.at(1));
  return {};
}

Value pop(Runtime& runtime, const Value& self, CallArguments& arguments) {
  const Parameters p(arguments, "pop", {"index"}, 0);
  if (list_of(self).items->empty()) fail_eval("pop from empty list");
  Values& items = list_of(self).to_change(runtime);
  runtime.budget.spend(items.size() / 16);
  const std::size_t at = checked_index(p.integer(0, -1), items.size(), "pop index out of range");
  Value taken = items[at];
  items.erase(items.begin() + static_cast<std::ptrdiff_t>(at));
  return taken;
}

/// Place of an item, or the size.
std::size_t place_of(Runtime& runtime, const Values& items, const Value& wanted) {
  const auto found =
      std::find_if(items.begin(), items.end(), [&](const Value& v) { return equal(runtime, v, wanted); });
  return static_cast<std::size_t>(found - items.begin());
}

Value remove(Runtime& runtime, const Value& self, CallArguments& arguments) {
  const Parameters p(arguments, "remove", {"value"}, 1);
  Values& items = list_of(self).to_change(runtime);
  const std::size_t at = place_of(runtime, items, p.at(0));
  if (at == items.size()) fail_eval("list.remove(x): x not in list");
  runtime.budget.spend(items.size() / 16);
  items.erase(items.begin() + static_cast<std::ptrdiff_t>(at));
  return {};
}

Value reverse(Runtime& runtime, const Value& self, CallArguments& arguments) {
  const Parameters none(arguments, "reverse", {}, 0);
  runtime.budget.spend(list_of(self).items->size() / 8);
  Values& items = list_of(self).to_change(runtime);
  std::reverse(items.begin(), items.end());
  return {};
}

Value sort(Runtime& runtime, const Value& self, CallArguments& arguments) {
  list_of(self).to_change(runtime) = sorted_items(runtime, *list_of(self).items, arguments, "sort");
  return {};
}

Value clear_list(Runtime& runtime, const Value& self, CallArguments& arguments) {
  const Parameters none(arguments, "clear", {}, 0);
  list_of(self).to_change(runtime).clear();
  return {};
}

Value copy_list(Runtime& runtime, const Value& self, CallArguments& arguments) {
  const Parameters none(arguments, "copy", {}, 0);
  runtime.budget.spend(list_of(self).items->size());
  return make_list(*list_of(self).items);
}

// ---- list and tuple ----

const Values& sequence_of(const Value& self) {
  const auto* list = self.object<List>();
  return list != nullptr ? *list->items : self.object<const Tuple>()->items;
}

Value index(Runtime& runtime, const Value& self, CallArguments& arguments) {
  const Parameters p(arguments, "index", {"value"}, 1);
  const Values& items = sequence_of(self);
  const std::size_t at = place_of(runtime, items, p.at(0));
  if (at == items.size()) {
    fail_eval(self.object<List>() != nullptr ? to_source(runtime, p.at(0)) + " is not in list"
                                             : "tuple.index(x): x not in tuple");
  }
  return static_cast<std::int64_t>(at);
}

Value count(Runtime& runtime, const Value& self, CallArguments& arguments) {
  const Parameters p(arguments, "count", {"value"}, 1);
  const Values& items = sequence_of(self);
  return static_cast<std::int64_t>(
      std::count_if(items.begin(), items.end(), [&](const Value& v) { return equal(runtime, v, p.at(0)); }));
}

// ---- dict ----

Dict& dict_of(const Value& self) { return *self.object<Dict>(); }

Value get(Runtime& runtime, const Value& self, CallArguments& arguments) {
  const Parameters p(arguments, "get", {"key", "default"}, 1);
  const Value* item = dict_of(self).table->find(runtime, p.at(0));
  if (item != nullptr) return *item;
  return p[1] != nullptr ? p.at(1) : Value();
}

Value view(const Value& self, CallArguments& arguments, Type type, std::string_view name) {
  const Parameters none(arguments, name, {}, 0);
  const auto* dict = self.as<std::shared_ptr<Dict>>();
  return std::make_shared<const DictView>(DictView{type, *dict});
}

Value keys(Runtime& /*r*/, const Value& self, CallArguments& a) { return view(self, a, Type::dict_keys, "keys"); }
Value values(Runtime& /*r*/, const Value& self, CallArguments& a) { return view(self, a, Type::dict_values, "values"); }
Value items(Runtime& /*r*/, const Value& self, CallArguments& a) { return view(self, a, Type::dict_items, "items"); }

Value pop_key(Runtime& runtime, const Value& self, CallArguments& arguments) {
  const Parameters p(arguments, "pop", {"key", "default"}, 1);
  const Value* item = dict_of(self).table->find(runtime, p.at(0));
  if (item == nullptr && p[1] == nullptr) fail_eval(to_source(runtime, p.at(0)));
  Value taken = item != nullptr ? *item : p.at(1);
  dict_of(self).to_change(runtime).erase(runtime, p.at(0));
  return taken;
}

Value popitem(Runtime& runtime, const Value& self, CallArguments& arguments) {
  const Parameters none(arguments, "popitem", {}, 0);
  if (dict_of(self).table->entries().empty()) fail_eval("'popitem(): dictionary is empty'");
  const auto last = dict_of(self).table->entries().back();
  dict_of(self).to_change(runtime).erase(runtime, last.first);
  return make_tuple({last.first, last.second});
}

Value setdefault(Runtime& runtime, const Value& self, CallArguments& arguments) {
  const Parameters p(arguments, "setdefault", {"key", "default"}, 1);
  if (const Value* item = dict_of(self).table->find(runtime, p.at(0))) return *item;
  Value value = p[1] != nullptr ? p.at(1) : Value();
  check_no_cycle(runtime, self, value);
  dict_of(self).to_change(runtime).set(runtime, p.at(0), value);
  return value;
}

Value update(Runtime& runtime, const Value& self, CallArguments& arguments) {
  const auto more = table_of(runtime, arguments, "update");
  for (const auto& entry : more->entries()) check_no_cycle(runtime, self, entry.second);
  for (const auto& [key, value] : more->entries()) dict_of(self).to_change(runtime).set(runtime, key, value);
  return {};
}

Value clear_dict(Runtime& runtime, const Value& self, CallArguments& arguments) {
  const Parameters none(arguments, "clear", {}, 0);
  dict_of(self).to_change(runtime).clear();
  return {};
}

Value copy_dict(Runtime& runtime, const Value& self, CallArguments& arguments) {
  const Parameters none(arguments, "copy", {}, 0);
  runtime.budget.spend(dict_of(self).table->entries().size());
  return make_dict(std::make_shared<Table>(*dict_of(self).table));
}

// ---- set ----

Set& set_of(const Value& self) { return *self.object<Set>(); }

Value add(Runtime& runtime, const Value& self, CallArguments& arguments) {
  const Parameters p(arguments, "add", {"elem"}, 1);
  set_of(self).table.set(runtime, p.at(0), {});
  return {};
}

Value discard(Runtime& runtime, const Value& self, CallArguments& arguments) {
  const Parameters p(arguments, "discard", {"elem"}, 1);
  set_of(self).table.erase(runtime, p.at(0));
  return {};
}

Value remove_item(Runtime& runtime, const Value& self, CallArguments& arguments) {
  const Parameters p(arguments, "remove", {"elem"}, 1);
  if (!set_of(self).table.erase(runtime, p.at(0))) fail_eval(to_source(runtime, p.at(0)));
  return {};
}

Value pop_any(Runtime& runtime, const Value& self, CallArguments& arguments) {
  const Parameters none(arguments, "pop", {}, 0);
  if (set_of(self).table.entries().empty()) fail_eval("'pop from an empty set'");
  Value taken = set_of(self).table.entries().front().first;
  set_of(self).table.erase(runtime, taken);
  return taken;
}

std::shared_ptr<Set> copy_of(Runtime& runtime, const Value& self) {
  runtime.budget.spend(set_of(self).table.entries().size());
  return std::make_shared<Set>(set_of(self));
}

Value copy_set(Runtime& runtime, const Value& self, CallArguments& arguments) {
  const Parameters none(arguments, "copy", {}, 0);
  return copy_of(runtime, self);
}

/// The items of all arguments, as a set.
Set gathered(Runtime& runtime, const CallArguments& arguments, std::string_view name) {
  check_no_keywords(arguments, name);
  Set all;
  for (const Value& argument : arguments.positional) {
    for (Value& item : items_of(runtime, argument)) all.table.set(runtime, std::move(item), {});
  }
  return all;
}

Value set_union(Runtime& runtime, const Value& self, CallArguments& arguments) {
  auto result = copy_of(runtime, self);
  const Set more = gathered(runtime, arguments, "union");
  for (const auto& entry : more.table.entries()) result->table.set(runtime, entry.first, {});
  return result;
}

Value add_all(Runtime& runtime, const Value& self, CallArguments& arguments) {
  const Set more = gathered(runtime, arguments, "update");
  for (const auto& entry : more.table.entries()) set_of(self).table.set(runtime, entry.first, {});
  return {};
}

Value difference(Runtime& runtime, const Value& self, CallArguments& arguments) {
  auto result = copy_of(runtime, self);
  const Set other = gathered(runtime, arguments, "difference");
  for (const auto& entry : other.table.entries()) result->table.erase(runtime, entry.first);
  return result;
}

Value intersection(Runtime& runtime, const Value& self, CallArguments& arguments) {
  auto result = copy_of(runtime, self);
  for (const Value& argument : arguments.positional) {
    CallArguments one{{argument}, {}};
    const Set other = gathered(runtime, one, "intersection");
    const Table before = result->table;
    for (const auto& entry : before.entries()) {
      if (other.table.find(runtime, entry.first) == nullptr) result->table.erase(runtime, entry.first);
    }
  }
  return result;
}

Value symmetric_difference(Runtime& runtime, const Value& self, CallArguments& arguments) {
  auto result = copy_of(runtime, self);
  const Set other = gathered(runtime, arguments, "symmetric_difference");
  for (const auto& entry : other.table.entries()) {
    if (!result->table.erase(runtime, entry.first)) result->table.set(runtime, entry.first, {});
  }
  return result;
}

bool all_in(Runtime& runtime, const Table& items, const Table& others) {
  return std::all_of(items.entries().begin(), items.entries().end(),
                     [&](const auto& entry) { return others.find(runtime, entry.first) != nullptr; });
}

Value issubset(Runtime& runtime, const Value& self, CallArguments& arguments) {
  return all_in(runtime, set_of(self).table, gathered(runtime, arguments, "issubset").table);
}

Value issuperset(Runtime& runtime, const Value& self, CallArguments& arguments) {
  return all_in(runtime, gathered(runtime, arguments, "issuperset").table, set_of(self).table);
}

Value isdisjoint(Runtime& runtime, const Value& self, CallArguments& arguments) {
  const Set other = gathered(runtime, arguments, "isdisjoint");
  const auto& entries = other.table.entries();
  return std::none_of(entries.begin(), entries.end(),
                      [&](const auto& entry) { return set_of(self).table.find(runtime, entry.first) != nullptr; });
}

constexpr Method kListMethods[] = {{"append", append}, {"clear", clear_list}, {"copy", copy_list}, {"count", count},
                                   {"extend", extend}, {"index", index},      {"insert", insert},  {"pop", pop},
                                   {"remove", remove}, {"reverse", reverse},  {"sort", sort}};
constexpr Method kTupleMethods[] = {{"count", count}, {"index", index}};
constexpr Method kDictMethods[] = {
    {"clear", clear_dict}, {"copy", copy_dict}, {"get", get},         {"items", items},
    {"keys", keys},        {"pop", pop_key},    {"popitem", popitem}, {"setdefault", setdefault},
    {"update", update},    {"values", values}};
/// Those of frozenset first.
constexpr Method kSetMethods[] = {{"copy", copy_set},
                                  {"difference", difference},
                                  {"intersection", intersection},
                                  {"isdisjoint", isdisjoint},
                                  {"issubset", issubset},
                                  {"issuperset", issuperset},
                                  {"symmetric_difference", symmetric_difference},
                                  {"union", set_union},
                                  {"add", add},
                                  {"discard", discard},
                                  {"pop", pop_any},
                                  {"remove", remove_item},
                                  {"update", add_all}};
constexpr std::size_t kFrozenSetMethods = 8;

const Method* find_in(const Method* begin, const Method* end, std::string_view name) {
  const auto* found = std::find_if(begin, end, [&](const Method& m) { return m.name == name; });
  return found != end ? found : nullptr;
}

}  // namespace

const Method* find_list_method(std::string_view name) {
  return find_in(std::begin(kListMethods), std::end(kListMethods), name);
}
const Method* find_tuple_method(std::string_view name) {
  return find_in(std::begin(kTupleMethods), std::end(kTupleMethods), name);
}
const Method* find_dict_method(std::string_view name) {
  return find_in(std::begin(kDictMethods), std::end(kDictMethods), name);
}
const Method* find_set_method(std::string_view name, bool is_frozen) {
  return find_in(kSetMethods, is_frozen ? kSetMethods + kFrozenSetMethods : std::end(kSetMethods), name);
}

}  // namespace finemote::gen::expression
