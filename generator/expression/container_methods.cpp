// The methods of list, tuple, dict and set.

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

Value append(Runtime& runtime, const Value& self, const Parameters& p) {
  check_no_cycle(runtime, self, p.at(0));
  check_size(list_of(self).items->size() + 1);
  list_of(self).to_change(runtime).push_back(p.at(0));
  return {};
}

Value extend(Runtime& runtime, const Value& self, const Parameters& p) {
  const Values more = items_of(runtime, p.at(0));
  for (const Value& item : more) check_no_cycle(runtime, self, item);
  check_size(list_of(self).items->size() + more.size());
  Values& items = list_of(self).to_change(runtime);
  items.insert(items.end(), more.begin(), more.end());
  return {};
}

Value insert(Runtime& runtime, const Value& self, const Parameters& p) {
  check_no_cycle(runtime, self, p.at(1));
  Values& items = list_of(self).to_change(runtime);
  const auto size = static_cast<std::int64_t>(items.size());
  check_size(items.size() + 1);
  runtime.budget.spend(items.size());
  const std::int64_t at = p.integer(0, 0);
  items.insert(items.begin() + std::clamp<std::int64_t>(at < 0 ? at + size : at, 0, size), p.at(1));
  return {};
}

Value pop(Runtime& runtime, const Value& self, const Parameters& p) {
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

Value remove(Runtime& runtime, const Value& self, const Parameters& p) {
  Values& items = list_of(self).to_change(runtime);
  const std::size_t at = place_of(runtime, items, p.at(0));
  if (at == items.size()) fail_eval("list.remove(x): x not in list");
  runtime.budget.spend(items.size() / 16);
  items.erase(items.begin() + static_cast<std::ptrdiff_t>(at));
  return {};
}

Value reverse(Runtime& runtime, const Value& self, const Parameters& /*none*/) {
  runtime.budget.spend(list_of(self).items->size() / 8);
  Values& items = list_of(self).to_change(runtime);
  std::reverse(items.begin(), items.end());
  return {};
}

Value sort(Runtime& runtime, const Value& self, const Parameters& p) {
  list_of(self).to_change(runtime) = sorted_items(runtime, *list_of(self).items, p.all(), p.function());
  return {};
}

Value clear_list(Runtime& runtime, const Value& self, const Parameters& /*none*/) {
  list_of(self).to_change(runtime).clear();
  return {};
}

Value copy_list(Runtime& runtime, const Value& self, const Parameters& /*none*/) {
  runtime.budget.spend(list_of(self).items->size());
  return make_list(*list_of(self).items);
}

// ---- list and tuple ----

const Values& sequence_of(const Value& self) {
  const auto* list = self.object<List>();
  return list != nullptr ? *list->items : self.object<const Tuple>()->items;
}

Value index_in(Runtime& runtime, const Value& self, const Parameters& p) {
  const Values& items = sequence_of(self);
  const std::size_t at = place_of(runtime, items, p.at(0));
  if (at == items.size()) {
    fail_eval(self.object<List>() != nullptr ? to_source(runtime, p.at(0)) + " is not in list"
                                             : "tuple.index(x): x not in tuple");
  }
  return static_cast<std::int64_t>(at);
}

Value count_in(Runtime& runtime, const Value& self, const Parameters& p) {
  const Values& items = sequence_of(self);
  return static_cast<std::int64_t>(
      std::count_if(items.begin(), items.end(), [&](const Value& v) { return equal(runtime, v, p.at(0)); }));
}

// ---- dict ----

Dict& dict_of(const Value& self) { return *self.object<Dict>(); }

Value get(Runtime& runtime, const Value& self, const Parameters& p) {
  const Value* item = dict_of(self).table->find(runtime, p.at(0));
  if (item != nullptr) return *item;
  return p[1] != nullptr ? p.at(1) : Value();
}

template <Type ViewType>
Value view(Runtime& /*runtime*/, const Value& self, const Parameters& /*none*/) {
  const auto* dict = self.as<std::shared_ptr<Dict>>();
  return std::make_shared<const DictView>(DictView{ViewType, *dict});
}

Value pop_key(Runtime& runtime, const Value& self, const Parameters& p) {
  const Value* item = dict_of(self).table->find(runtime, p.at(0));
  if (item == nullptr && p[1] == nullptr) fail_eval(to_source(runtime, p.at(0)));
  Value taken = item != nullptr ? *item : p.at(1);
  dict_of(self).to_change(runtime).erase(runtime, p.at(0));
  return taken;
}

Value popitem(Runtime& runtime, const Value& self, const Parameters& /*none*/) {
  if (dict_of(self).table->entries().empty()) fail_eval("'popitem(): dictionary is empty'");
  const auto last = dict_of(self).table->entries().back();
  dict_of(self).to_change(runtime).erase(runtime, last.first);
  return make_tuple({last.first, last.second});
}

Value setdefault(Runtime& runtime, const Value& self, const Parameters& p) {
  if (const Value* item = dict_of(self).table->find(runtime, p.at(0))) return *item;
  Value value = p[1] != nullptr ? p.at(1) : Value();
  check_no_cycle(runtime, self, value);
  dict_of(self).to_change(runtime).set(runtime, p.at(0), value);
  return value;
}

Value update(Runtime& runtime, const Value& self, const Parameters& p) {
  const auto more = table_of(runtime, p.all(), p.function());
  for (const auto& entry : more->entries()) check_no_cycle(runtime, self, entry.second);
  for (const auto& [key, value] : more->entries()) dict_of(self).to_change(runtime).set(runtime, key, value);
  return {};
}

Value clear_dict(Runtime& runtime, const Value& self, const Parameters& /*none*/) {
  dict_of(self).to_change(runtime).clear();
  return {};
}

Value copy_dict(Runtime& runtime, const Value& self, const Parameters& /*none*/) {
  runtime.budget.spend(dict_of(self).table->entries().size());
  return make_dict(std::make_shared<Table>(*dict_of(self).table));
}

// ---- set ----

Set& set_of(const Value& self) { return *self.object<Set>(); }

Value add(Runtime& runtime, const Value& self, const Parameters& p) {
  set_of(self).table.set(runtime, p.at(0), {});
  return {};
}

Value discard(Runtime& runtime, const Value& self, const Parameters& p) {
  set_of(self).table.erase(runtime, p.at(0));
  return {};
}

Value remove_item(Runtime& runtime, const Value& self, const Parameters& p) {
  if (!set_of(self).table.erase(runtime, p.at(0))) fail_eval(to_source(runtime, p.at(0)));
  return {};
}

Value pop_any(Runtime& runtime, const Value& self, const Parameters& /*none*/) {
  if (set_of(self).table.entries().empty()) fail_eval("'pop from an empty set'");
  Value taken = set_of(self).table.entries().front().first;
  set_of(self).table.erase(runtime, taken);
  return taken;
}

std::shared_ptr<Set> copy_of(Runtime& runtime, const Value& self) {
  runtime.budget.spend(set_of(self).table.entries().size());
  return std::make_shared<Set>(set_of(self));
}

Value copy_set(Runtime& runtime, const Value& self, const Parameters& /*none*/) { return copy_of(runtime, self); }

/// The items of all arguments, as a set.
Set gathered(Runtime& runtime, const Values& arguments) {
  Set all;
  for (const Value& argument : arguments) {
    for (Value& item : items_of(runtime, argument)) all.table.set(runtime, std::move(item), {});
  }
  return all;
}

Value set_union(Runtime& runtime, const Value& self, const Parameters& p) {
  auto result = copy_of(runtime, self);
  const Set more = gathered(runtime, p.positional());
  for (const auto& entry : more.table.entries()) result->table.set(runtime, entry.first, {});
  return result;
}

Value add_all(Runtime& runtime, const Value& self, const Parameters& p) {
  const Set more = gathered(runtime, p.positional());
  for (const auto& entry : more.table.entries()) set_of(self).table.set(runtime, entry.first, {});
  return {};
}

Value difference(Runtime& runtime, const Value& self, const Parameters& p) {
  auto result = copy_of(runtime, self);
  const Set other = gathered(runtime, p.positional());
  for (const auto& entry : other.table.entries()) result->table.erase(runtime, entry.first);
  return result;
}

Value intersection(Runtime& runtime, const Value& self, const Parameters& p) {
  auto result = copy_of(runtime, self);
  for (const Value& argument : p.positional()) {
    const Set other = gathered(runtime, {argument});
    const Table before = result->table;
    for (const auto& entry : before.entries()) {
      if (other.table.find(runtime, entry.first) == nullptr) result->table.erase(runtime, entry.first);
    }
  }
  return result;
}

Value symmetric_difference(Runtime& runtime, const Value& self, const Parameters& p) {
  auto result = copy_of(runtime, self);
  const Set other = gathered(runtime, p.positional());
  for (const auto& entry : other.table.entries()) {
    if (!result->table.erase(runtime, entry.first)) result->table.set(runtime, entry.first, {});
  }
  return result;
}

bool all_in(Runtime& runtime, const Table& items, const Table& others) {
  return std::all_of(items.entries().begin(), items.entries().end(),
                     [&](const auto& entry) { return others.find(runtime, entry.first) != nullptr; });
}

Value issubset(Runtime& runtime, const Value& self, const Parameters& p) {
  return all_in(runtime, set_of(self).table, gathered(runtime, p.positional()).table);
}

Value issuperset(Runtime& runtime, const Value& self, const Parameters& p) {
  return all_in(runtime, gathered(runtime, p.positional()).table, set_of(self).table);
}

Value isdisjoint(Runtime& runtime, const Value& self, const Parameters& p) {
  const Set other = gathered(runtime, p.positional());
  const auto& entries = other.table.entries();
  return std::none_of(entries.begin(), entries.end(),
                      [&](const auto& entry) { return set_of(self).table.find(runtime, entry.first) != nullptr; });
}

constexpr Method kListMethods[] = {{"append", {{"object"}, 1}, append},
                                   {"clear", {}, clear_list},
                                   {"copy", {}, copy_list},
                                   {"count", {{"value"}, 1}, count_in},
                                   {"extend", {{"iterable"}, 1}, extend},
                                   {"index", {{"value"}, 1}, index_in},
                                   {"insert", {{"index", "object"}, 2}, insert},
                                   {"pop", {{"index"}, 0}, pop},
                                   {"remove", {{"value"}, 1}, remove},
                                   {"reverse", {}, reverse},
                                   {"sort", Signature::free(), sort}};
constexpr Method kTupleMethods[] = {{"count", {{"value"}, 1}, count_in}, {"index", {{"value"}, 1}, index_in}};
constexpr Method kDictMethods[] = {{"clear", {}, clear_dict},
                                   {"copy", {}, copy_dict},
                                   {"get", {{"key", "default"}, 1}, get},
                                   {"items", {}, view<Type::dict_items>},
                                   {"keys", {}, view<Type::dict_keys>},
                                   {"pop", {{"key", "default"}, 1}, pop_key},
                                   {"popitem", {}, popitem},
                                   {"setdefault", {{"key", "default"}, 1}, setdefault},
                                   {"update", Signature::free(), update},
                                   {"values", {}, view<Type::dict_values>}};
/// Those of frozenset first.
constexpr Method kSetMethods[] = {{"copy", {}, copy_set},
                                  {"difference", Signature::positional(0), difference},
                                  {"intersection", Signature::free(), intersection},
                                  {"isdisjoint", Signature::positional(0), isdisjoint},
                                  {"issubset", Signature::positional(0), issubset},
                                  {"issuperset", Signature::positional(0), issuperset},
                                  {"symmetric_difference", Signature::positional(0), symmetric_difference},
                                  {"union", Signature::positional(0), set_union},
                                  {"add", {{"elem"}, 1}, add},
                                  {"discard", {{"elem"}, 1}, discard},
                                  {"pop", {}, pop_any},
                                  {"remove", {{"elem"}, 1}, remove_item},
                                  {"update", Signature::positional(0), add_all}};
constexpr std::size_t kFrozenSetMethods = 8;

}  // namespace

const Method* find_list_method(std::string_view name) { return find_method(kListMethods, name); }
const Method* find_tuple_method(std::string_view name) { return find_method(kTupleMethods, name); }
const Method* find_dict_method(std::string_view name) { return find_method(kDictMethods, name); }
const Method* find_set_method(std::string_view name, bool is_frozen) {
  const std::span<const Method> all(kSetMethods);
  return find_method(is_frozen ? all.first(kFrozenSetMethods) : all, name);
}

}  // namespace finemote::gen::expression
