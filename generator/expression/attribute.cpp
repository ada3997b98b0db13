#include "generator/expression/attribute.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "generator/expression/compare.hpp"
#include "generator/expression/function.hpp"
#include "generator/expression/runtime.hpp"
#include "generator/expression/scope.hpp"
#include "generator/expression/str_methods.hpp"
#include "generator/expression/subscript.hpp"

namespace finemote::gen::expression {
namespace {

constexpr Method kIndices{"indices", {{"len"}, 1}, slice_indices};

const Method* method_of(const Value& value, std::string_view name) {
  switch (value.type()) {
    case Type::text:
      return find_str_method(name);
    case Type::list:
      return find_list_method(name);
    case Type::tuple:
      return find_tuple_method(name);
    case Type::dict:
      return find_dict_method(name);
    case Type::set:
    case Type::frozen_set:
      return find_set_method(name, value.type() == Type::frozen_set);
    case Type::boolean:
    case Type::integer:
      return find_number_method(name, false);
    case Type::real:
      return find_number_method(name, true);
    case Type::slice:
      return name == kIndices.name ? &kIndices : nullptr;
    default:
      return nullptr;
  }
}

Value namespace_attribute(Runtime& runtime, Scope& scope, const std::string& name) {
  auto value = runtime.names.look_up(scope, name);
  if (!value) fail_name(name, scope.names());
  return std::move(*value);
}

Value dotted_key(Runtime& runtime, const Dict& dict, const std::string& name) {
  const Value* item = dict.table->find(runtime, Value(name));
  if (item == nullptr) fail_eval(fmt::format("The yaml dictionary has no key '{}'", name));
  return dotted(*item);
}

Value is_integer(Runtime& /*runtime*/, const Value& self, const Parameters& /*none*/) {
  const double d = *as_real(self);
  return std::isfinite(d) && d == std::trunc(d);
}

Value bit_length(Runtime& /*runtime*/, const Value& self, const Parameters& /*none*/) {
  return static_cast<std::int64_t>(expression::bit_length(*as_integer(self)));
}

/// `start`, `stop` and `step` of a slice or range.
std::optional<Value> bound_of(const Value& value, std::string_view name) {
  constexpr std::string_view names[] = {"start", "stop", "step"};
  const auto* found = std::find(std::begin(names), std::end(names), name);
  if (found == std::end(names)) return std::nullopt;
  const auto place = static_cast<std::size_t>(found - std::begin(names));
  if (const auto* slice = value.object<const Slice>()) return (*slice->bounds)[place];
  const auto* range = value.object<const Range>();
  if (range == nullptr) return std::nullopt;
  const std::int64_t bounds[] = {range->start, range->stop, range->step};
  return Value(bounds[place]);
}

constexpr Method kIsInteger{"is_integer", {}, is_integer};
constexpr Method kBitLength{"bit_length", {}, bit_length};

/// Walks the containers inside a value, looking for one.
bool holds(Runtime& runtime, const Value& value, const Value& wanted) {
  const Level level(runtime.depth, kMaxEvalDepth, "the list is nested too deeply");
  runtime.budget.spend(1);
  if (identical(value, wanted) && value.text() == nullptr) return true;
  const auto any = [&](const Values& items) {
    return std::any_of(items.begin(), items.end(), [&](const Value& v) { return holds(runtime, v, wanted); });
  };
  if (const auto* list = value.object<List>()) return any(*list->items);
  if (const auto* tuple = value.object<const Tuple>()) return any(tuple->items);
  if (const auto* iterator = value.object<Iterator>()) return any(iterator->items);
  if (const auto* view = value.object<const DictView>()) return holds(runtime, Value(view->dict), wanted);
  if (const auto* method = value.object<const BoundMethod>()) return holds(runtime, *method->self, wanted);
  if (const auto* dict = value.object<Dict>()) {
    const auto& entries = dict->table->entries();
    return std::any_of(entries.begin(), entries.end(), [&](const auto& e) {
      return holds(runtime, e.first, wanted) || holds(runtime, e.second, wanted);
    });
  }
  return false;
}

}  // namespace

const Method* find_number_method(std::string_view name, bool is_real) {
  if (is_real && name == kIsInteger.name) return &kIsInteger;
  if (!is_real && name == kBitLength.name) return &kBitLength;
  return nullptr;
}

void check_no_cycle(Runtime& runtime, const Value& container, const Value& item) {
  const bool is_flat = item.text() != nullptr || as_integer(item) || as_real(item) != nullptr || item.is_none();
  if (is_flat) return;
  const bool is_function = item.object<const Lambda>() != nullptr;
  if (is_function) fail_eval("a function cannot be kept in a list or dictionary");
  if (holds(runtime, item, container)) fail_eval("a list or dictionary cannot contain itself");
}

Value attribute_of(Runtime& runtime, const Value& value, const std::string& name) {
  runtime.budget.spend(1);
  if (const auto* ns = value.as<NamespaceRef>()) return namespace_attribute(runtime, *ns->scope, name);
  if (const Method* method = method_of(value, name)) {
    return std::make_shared<const BoundMethod>(BoundMethod{std::make_shared<const Value>(value), method});
  }
  if (const auto* dict = value.object<Dict>(); dict != nullptr && dict->is_dotted) {
    return dotted_key(runtime, *dict, name);
  }
  if (name == "real" && as_integer(value)) return *as_integer(value);
  if (name == "real" && as_real(value) != nullptr) return value;
  if (auto bound = bound_of(value, name)) return std::move(*bound);
  if (const auto* type = value.as<Type>()) {
    fail_eval(fmt::format("type object '{}' has no attribute '{}'", type_name(*type), name));
  }
  fail_eval(fmt::format("'{}' object has no attribute '{}'", type_name(value), name));
}

}  // namespace finemote::gen::expression
