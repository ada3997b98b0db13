#include "generator/expression/value.hpp"

#include "generator/expression/compare.hpp"
#include "generator/expression/runtime.hpp"

namespace finemote::gen::expression {

namespace {

struct TypeOf {
  Type operator()(const None&) const { return Type::none; }
  Type operator()(bool) const { return Type::boolean; }
  Type operator()(const Integer&) const { return Type::integer; }
  Type operator()(double) const { return Type::real; }
  Type operator()(const Value::Text&) const { return Type::text; }
  Type operator()(const std::shared_ptr<List>&) const { return Type::list; }
  Type operator()(const std::shared_ptr<const Tuple>&) const { return Type::tuple; }
  Type operator()(const std::shared_ptr<Dict>&) const { return Type::dict; }
  Type operator()(const std::shared_ptr<Set>& s) const { return s->is_frozen ? Type::frozen_set : Type::set; }
  Type operator()(const std::shared_ptr<const Range>&) const { return Type::range; }
  Type operator()(const std::shared_ptr<const Slice>&) const { return Type::slice; }
  Type operator()(const std::shared_ptr<Iterator>& i) const { return i->type; }
  Type operator()(const std::shared_ptr<const DictView>& v) const { return v->type; }
  Type operator()(const std::shared_ptr<const Lambda>&) const { return Type::function; }
  Type operator()(const std::shared_ptr<const BoundMethod>&) const { return Type::method; }
  Type operator()(const Builtin*) const { return Type::builtin; }
  Type operator()(Type) const { return Type::type; }
  Type operator()(NamespaceRef) const { return Type::name_space; }
  Type operator()(const std::shared_ptr<const Opaque>&) const { return Type::opaque; }
};

}  // namespace

Type Value::type() const { return std::visit(TypeOf{}, storage_); }

std::string_view type_name(Type type) {
  switch (type) {
    case Type::none:
      return "NoneType";
    case Type::boolean:
      return "bool";
    case Type::integer:
      return "int";
    case Type::real:
      return "float";
    case Type::text:
      return "str";
    case Type::list:
      return "list";
    case Type::tuple:
      return "tuple";
    case Type::dict:
      return "dict";
    case Type::set:
      return "set";
    case Type::frozen_set:
      return "frozenset";
    case Type::range:
      return "range";
    case Type::slice:
      return "slice";
    case Type::map:
      return "map";
    case Type::zip:
      return "zip";
    case Type::filter:
      return "filter";
    case Type::enumerate:
      return "enumerate";
    case Type::reversed:
      return "reversed";
    case Type::generator:
      return "generator";
    case Type::dict_keys:
      return "dict_keys";
    case Type::dict_values:
      return "dict_values";
    case Type::dict_items:
      return "dict_items";
    case Type::function:
      return "function";
    case Type::builtin:
      return "builtin_function_or_method";
    case Type::method:
      return "builtin_function_or_method";
    case Type::type:
      return "type";
    case Type::name_space:
      return "NameSpace";
    case Type::opaque:
      return "Element";
  }
  return "object";
}

std::string_view type_name(const Value& value) { return type_name(value.type()); }

Value make_list(Values items) {
  auto list = std::make_shared<List>();
  *list->items = std::move(items);
  return list;
}

Value make_tuple(Values items) { return std::make_shared<const Tuple>(Tuple{std::move(items)}); }

Value make_dict(std::shared_ptr<Table> table) {
  auto dict = std::make_shared<Dict>();
  dict->table = std::move(table);
  return dict;
}

Value make_iterator(Type type, Values items) { return std::make_shared<Iterator>(Iterator{type, std::move(items), 0}); }

bool is_true(const Value& value) {
  switch (value.type()) {
    case Type::none:
      return false;
    case Type::boolean:
      return *value.as<bool>();
    case Type::integer:
      return !value.as<Integer>()->is_zero();
    case Type::real:
      return *value.as<double>() != 0.0;
    case Type::text:
      return !value.text()->empty();
    case Type::list:
      return !value.object<List>()->items->empty();
    case Type::tuple:
      return !value.object<const Tuple>()->items.empty();
    case Type::dict:
      return !value.object<Dict>()->table->entries().empty();
    case Type::set:
    case Type::frozen_set:
      return !value.object<Set>()->table.entries().empty();
    case Type::range:
      return value.object<const Range>()->size() > 0;
    case Type::dict_keys:
    case Type::dict_values:
    case Type::dict_items:
      return !value.object<const DictView>()->dict->table->entries().empty();
    default:
      return true;
  }
}

const double* as_real(const Value& value) { return value.as<double>(); }

std::optional<Integer> as_integer(const Value& value) {
  if (const auto* b = value.as<bool>()) return Integer(*b ? 1 : 0);
  if (const auto* i = value.as<Integer>()) return *i;
  return std::nullopt;
}

Value dotted(const Value& item) {
  if (const auto* list = item.object<List>()) {
    auto copy = std::make_shared<List>(*list);
    copy->is_dotted = true;
    return copy;
  }
  if (const auto* dict = item.object<Dict>()) {
    auto copy = std::make_shared<Dict>(*dict);
    copy->is_dotted = true;
    return copy;
  }
  return item;
}

Values& List::to_change(Runtime& runtime) {
  if (items.use_count() > 1) {
    runtime.budget.spend(items->size());
    items = std::make_shared<Values>(*items);
  }
  return *items;
}

Table& Dict::to_change(Runtime& runtime) {
  if (table.use_count() > 1) {
    runtime.budget.spend(table->entries().size());
    table = std::make_shared<Table>(*table);
  }
  return *table;
}

std::int64_t Range::size() const {
  if (step > 0) return start < stop ? (stop - start - 1) / step + 1 : 0;
  return start > stop ? (start - stop - 1) / -step + 1 : 0;
}

std::size_t Table::index_of(Runtime& runtime, const Value& key, std::size_t hash) const {
  for (auto [at, end] = index_.equal_range(hash); at != end; ++at) {
    if (equal(runtime, entries_[at->second].first, key)) return at->second;
  }
  return kNotFound;
}

const Value* Table::find(Runtime& runtime, const Value& key) const {
  const std::size_t at = index_of(runtime, key, hash_of(runtime, key));
  return at == kNotFound ? nullptr : &entries_[at].second;
}

void Table::set(Runtime& runtime, Value key, Value value) {
  const std::size_t hash = hash_of(runtime, key);
  const std::size_t at = index_of(runtime, key, hash);
  if (at != kNotFound) {
    entries_[at].second = std::move(value);
    return;
  }
  index_.emplace(hash, entries_.size());
  entries_.emplace_back(std::move(key), std::move(value));
}

bool Table::erase(Runtime& runtime, const Value& key) {
  const std::size_t at = index_of(runtime, key, hash_of(runtime, key));
  if (at == kNotFound) return false;
  runtime.budget.spend(entries_.size());
  entries_.erase(entries_.begin() + static_cast<std::ptrdiff_t>(at));
  for (auto entry = index_.begin(); entry != index_.end();) {
    if (entry->second == at) {
      entry = index_.erase(entry);
    } else {
      if (entry->second > at) --entry->second;
      ++entry;
    }
  }
  return true;
}

void Table::clear() {
  entries_.clear();
  index_.clear();
}

}  // namespace finemote::gen::expression
