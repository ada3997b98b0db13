#include "generator/expression/subscript.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/expression/cost.hpp"
#include "generator/expression/parameters.hpp"
#include "generator/expression/print.hpp"
#include "generator/expression/runtime.hpp"
#include "generator/expression/utf8.hpp"

namespace finemote::gen::expression {
namespace {

constexpr std::int64_t kFar = std::int64_t{1} << 60;

/// A slice bound as a number near enough to any size.
std::int64_t bound(const Value& value, std::int64_t otherwise) {
  if (value.is_none()) return otherwise;
  const auto i = as_integer(value);
  if (!i) fail_eval("slice indices must be integers or None or have an __index__ method");
  if (!i->is_small()) return i->is_negative() ? -kFar : kFar;
  return std::clamp(i->small(), -kFar, kFar);
}

std::int64_t clamp_bound(std::int64_t place, std::int64_t size, std::int64_t lowest, std::int64_t highest) {
  if (place < 0) place += size;
  return std::clamp(place, lowest, highest);
}

Values picked(Runtime& runtime, const Values& items, const Slice& slice) {
  const std::vector<std::size_t> places = slice_places(slice, items.size());
  runtime.budget.spend(places.size());
  Values taken;
  for (const std::size_t at : places) taken.push_back(items[at]);
  return taken;
}

Integer index_of(const Value& key, std::string_view kind) {
  const auto i = as_integer(key);
  if (i) return *i;
  if (kind == "string") fail_eval(fmt::format("string indices must be integers, not '{}'", type_name(key)));
  fail_eval(fmt::format("{} indices must be integers or slices, not {}", kind, type_name(key)));
}

Value text_item(const std::string& text, const Value& key) {
  const auto* slice = key.object<const Slice>();
  const auto characters = split_characters(text);
  if (slice == nullptr) {
    return characters[checked_index(index_of(key, "string"), characters.size(), "string index out of range")];
  }
  std::string taken;
  for (const std::size_t at : slice_places(*slice, characters.size())) taken += characters[at];
  return taken;
}

Value list_item(Runtime& runtime, const List& list, const Value& key) {
  if (const auto* slice = key.object<const Slice>()) {
    Value taken = make_list(picked(runtime, *list.items, *slice));
    return list.is_dotted ? dotted(taken) : taken;
  }
  const std::size_t at = checked_index(index_of(key, "list"), list.items->size(), "list index out of range");
  const Value& item = (*list.items)[at];
  return list.is_dotted ? dotted(item) : item;
}

Value tuple_item(Runtime& runtime, const Tuple& tuple, const Value& key) {
  if (const auto* slice = key.object<const Slice>()) return make_tuple(picked(runtime, tuple.items, *slice));
  return tuple.items[checked_index(index_of(key, "tuple"), tuple.items.size(), "tuple index out of range")];
}

Value range_item(const Range& range, const Value& key) {
  const auto size = static_cast<std::size_t>(range.size());
  const auto* slice = key.object<const Slice>();
  if (slice == nullptr) {
    return range.at(
        static_cast<std::int64_t>(checked_index(index_of(key, "range"), size, "range object index out of range")));
  }
  const SliceWalk walk = walk_of(*slice, size);
  const auto reached = [&range](std::int64_t places, std::int64_t from) {
    std::int64_t sum = 0;
    const bool is_too_far = __builtin_mul_overflow(places, range.step, &sum) || __builtin_add_overflow(from, sum, &sum);
    if (is_too_far) fail_limit("the range reaches beyond 64 bits");
    return sum;
  };
  return std::make_shared<const Range>(
      Range{reached(walk.start, range.start), reached(walk.stop, range.start), reached(walk.step, 0)});
}

Value dict_item(Runtime& runtime, const Dict& dict, const Value& key) {
  const Value* item = dict.table->find(runtime, key);
  if (item != nullptr) return dict.is_dotted ? dotted(*item) : *item;
  if (dict.is_dotted) fail_eval(fmt::format("The yaml dictionary has no key '{}'", to_text(runtime, key)));
  fail_eval(to_source(runtime, key));
}

Value namespace_item(Runtime& runtime, const NamespaceRef& ns, const Value& key) {
  auto value = key.text() != nullptr ? runtime.names.look_up(*ns.scope, *key.text()) : std::nullopt;
  if (!value) fail_eval(to_source(runtime, key));
  return std::move(*value);
}

}  // namespace

std::size_t checked_index(const Integer& index, std::size_t size, const char* message) {
  const auto length = static_cast<std::int64_t>(size);
  std::int64_t at = index.is_small() ? index.small() : kFar;
  if (at < 0) at += length;
  if (at < 0 || at >= length) fail_eval(message);
  return static_cast<std::size_t>(at);
}

SliceWalk walk_of(const Slice& slice, std::size_t size) {
  const auto length = static_cast<std::int64_t>(size);
  const std::int64_t step = bound((*slice.bounds)[2], 1);
  if (step == 0) fail_eval("slice step cannot be zero");
  const bool forward = step > 0;
  const std::int64_t lowest = forward ? 0 : -1;
  const std::int64_t highest = forward ? length : length - 1;
  const Value& first = (*slice.bounds)[0];
  const Value& last = (*slice.bounds)[1];
  return {first.is_none() ? (forward ? lowest : highest) : clamp_bound(bound(first, 0), length, lowest, highest),
          last.is_none() ? (forward ? highest : lowest) : clamp_bound(bound(last, 0), length, lowest, highest), step};
}

std::vector<std::size_t> slice_places(const Slice& slice, std::size_t size) {
  const auto [start, stop, step] = walk_of(slice, size);
  std::vector<std::size_t> places;
  for (std::int64_t at = start; step > 0 ? at < stop : at > stop; at += step)
    places.push_back(static_cast<std::size_t>(at));
  return places;
}

Value slice_indices(Runtime& /*runtime*/, const Value& self, const Parameters& p) {
  const auto length = as_integer(p.at(0));
  if (!length) fail_eval(fmt::format("'{}' object cannot be interpreted as an integer", type_name(p.at(0))));
  if (length->is_negative()) fail_eval("length should not be negative");
  if (!length->is_small() || length->small() > kFar) fail_limit("the length is too large");
  const auto& slice = *self.object<const Slice>();
  const SliceWalk walk = walk_of(slice, static_cast<std::size_t>(length->small()));
  const auto step = as_integer((*slice.bounds)[2]);
  return make_tuple({walk.start, walk.stop, step ? *step : Integer(walk.step)});
}

Value subscript(Runtime& runtime, const Value& container, const Value& key) {
  runtime.budget.spend(1 + cost_of_bytes(bytes_of(container)));
  if (container.text() != nullptr) return text_item(*container.text(), key);
  if (const auto* list = container.object<List>()) return list_item(runtime, *list, key);
  if (const auto* tuple = container.object<const Tuple>()) return tuple_item(runtime, *tuple, key);
  if (const auto* dict = container.object<Dict>()) return dict_item(runtime, *dict, key);
  if (const auto* range = container.object<const Range>()) return range_item(*range, key);
  if (const auto* ns = container.as<NamespaceRef>()) return namespace_item(runtime, *ns, key);
  fail_eval(fmt::format("'{}' object is not subscriptable", type_name(container)));
}

}  // namespace finemote::gen::expression
