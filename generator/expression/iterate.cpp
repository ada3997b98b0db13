#include "generator/expression/iterate.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/expression/compare.hpp"
#include "generator/expression/cost.hpp"
#include "generator/expression/runtime.hpp"
#include "generator/expression/utf8.hpp"

namespace finemote::gen::expression {
namespace {

Values characters_of(const std::string& text) {
  Values items;
  for (const std::string_view c : split_characters(text)) items.emplace_back(c);
  return items;
}

Values keys_of(const Table& table) {
  Values keys;
  for (const auto& entry : table.entries()) keys.push_back(entry.first);
  return keys;
}

Values view_items(const DictView& view) {
  Values items;
  for (const auto& [key, value] : view.dict->table->entries()) {
    if (view.type == Type::dict_keys) items.push_back(key);
    if (view.type == Type::dict_values) items.push_back(value);
    if (view.type == Type::dict_items) items.push_back(make_tuple({key, value}));
  }
  return items;
}

Values list_items(const List& list) {
  if (!list.is_dotted) return *list.items;
  Values items;
  for (const Value& item : *list.items) items.push_back(dotted(item));
  return items;
}

Values range_items(Runtime& runtime, const Range& range) {
  if (range.size() > static_cast<std::int64_t>(kMaxItems)) fail_limit("the range has too many items");
  runtime.budget.spend(static_cast<std::size_t>(range.size()));
  Values items;
  items.reserve(static_cast<std::size_t>(range.size()));
  for (std::int64_t i = 0; i < range.size(); ++i) items.emplace_back(range.at(i));
  return items;
}

Values rest_of(Iterator& iterator) {
  Values rest(std::make_move_iterator(iterator.items.begin() + static_cast<std::ptrdiff_t>(iterator.next)),
              std::make_move_iterator(iterator.items.end()));
  iterator.next = iterator.items.size();
  return rest;
}

bool among(Runtime& runtime, const Values& items, const Value& item) {
  return std::any_of(items.begin(), items.end(), [&](const Value& i) {
    runtime.budget.spend(cost_of_block(bytes_of(i)));
    return identical(i, item) || equal(runtime, i, item);
  });
}

}  // namespace

Values items_of(Runtime& runtime, const Value& value) {
  Values items;
  switch (value.type()) {
    case Type::text:
      items = characters_of(*value.text());
      break;
    case Type::list:
      items = list_items(*value.object<List>());
      break;
    case Type::tuple:
      items = value.object<const Tuple>()->items;
      break;
    case Type::dict:
      items = keys_of(*value.object<Dict>()->table);
      break;
    case Type::set:
    case Type::frozen_set:
      items = keys_of(value.object<Set>()->table);
      break;
    case Type::range:
      return range_items(runtime, *value.object<const Range>());
    case Type::dict_keys:
    case Type::dict_values:
    case Type::dict_items:
      items = view_items(*value.object<const DictView>());
      break;
    case Type::map:
    case Type::zip:
    case Type::filter:
    case Type::enumerate:
    case Type::reversed:
    case Type::generator:
      items = rest_of(*value.object<Iterator>());
      break;
    default:
      fail_eval(fmt::format("'{}' object is not iterable", type_name(value)));
  }
  runtime.budget.spend(items.size());
  return items;
}

std::size_t size_of(const Value& value) {
  switch (value.type()) {
    case Type::text:
      return count_characters(*value.text());
    case Type::list:
      return value.object<List>()->items->size();
    case Type::tuple:
      return value.object<const Tuple>()->items.size();
    case Type::dict:
      return value.object<Dict>()->table->entries().size();
    case Type::set:
    case Type::frozen_set:
      return value.object<Set>()->table.entries().size();
    case Type::range:
      return static_cast<std::size_t>(value.object<const Range>()->size());
    case Type::dict_keys:
    case Type::dict_values:
    case Type::dict_items:
      return value.object<const DictView>()->dict->table->entries().size();
    default:
      fail_eval(fmt::format("object of type '{}' has no len()", type_name(value)));
  }
}

bool contains(Runtime& runtime, const Value& container, const Value& item) {
  if (const auto* text = container.text()) {
    if (item.text() == nullptr) {
      fail_eval(fmt::format("'in <string>' requires string as left operand, not {}", type_name(item)));
    }
    runtime.budget.spend(cost_of_search(*text, *item.text()));
    return text->find(*item.text()) != std::string::npos;
  }
  if (const auto* dict = container.object<Dict>()) return dict->table->find(runtime, item) != nullptr;
  if (const auto* set = container.object<Set>()) return set->table.find(runtime, item) != nullptr;
  if (const auto* list = container.object<List>()) return among(runtime, *list->items, item);
  if (const auto* ns = container.as<NamespaceRef>()) {
    return item.text() != nullptr && runtime.names.look_up(*ns->scope, *item.text()).has_value();
  }
  const bool is_iterable = container.type() != Type::integer && container.type() != Type::real &&
                           container.type() != Type::boolean && !container.is_none();
  if (!is_iterable) fail_eval(fmt::format("argument of type '{}' is not iterable", type_name(container)));
  return among(runtime, items_of(runtime, container), item);
}

}  // namespace finemote::gen::expression
