// What an expression can be: the values of the part of Python that xacro exposes.
//
// Lists, dicts and sets are shared by reference, as in Python: a macro may pop from its caller's list. No value can
// contain itself (the methods that add refuse it), so shared ownership frees everything.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

#include "generator/expression/integer.hpp"

namespace finemote::gen::expression {

class Value;
class Scope;
class Runtime;
struct Expression;
struct Locals;

using Values = std::vector<Value>;

struct None {};

/// What a document keeps among its names for itself, derived from this: expressions hand it on and never look inside.
struct Opaque {
  Opaque() = default;
  Opaque(const Opaque&) = delete;
  Opaque& operator=(const Opaque&) = delete;
  virtual ~Opaque() = default;
};

/// The arguments of one call.
struct CallArguments {
  Values positional;
  std::vector<std::pair<std::string, Value>> named;
};

struct Builtin;
struct Method;
struct List;
struct Tuple;
struct Dict;
struct Set;
struct Range;
struct Slice;
struct Iterator;
struct DictView;
struct Lambda;
struct BoundMethod;

/// The types isinstance() and type() know, most of them callable.
enum class Type {
  none,
  boolean,
  integer,
  real,
  text,
  list,
  tuple,
  dict,
  set,
  frozen_set,
  range,
  slice,
  map,
  zip,
  filter,
  enumerate,
  reversed,
  generator,
  dict_keys,
  dict_values,
  dict_items,
  function,
  builtin,
  method,
  type,
  name_space,
  opaque
};

struct NamespaceRef {
  Scope* scope;
};

class Value {
 public:
  using Text = std::shared_ptr<const std::string>;
  using Storage = std::variant<None, bool, Integer, double, Text, std::shared_ptr<List>, std::shared_ptr<const Tuple>,
                               std::shared_ptr<Dict>, std::shared_ptr<Set>, std::shared_ptr<const Range>,
                               std::shared_ptr<const Slice>, std::shared_ptr<Iterator>, std::shared_ptr<const DictView>,
                               std::shared_ptr<const Lambda>, std::shared_ptr<const BoundMethod>, const Builtin*, Type,
                               NamespaceRef, std::shared_ptr<const Opaque>>;

  Value() = default;
  Value(bool b) : storage_(b) {}                   // NOLINT: values convert, that is their use
  Value(int i) : storage_(Integer(i)) {}           // NOLINT
  Value(std::int64_t i) : storage_(Integer(i)) {}  // NOLINT
  Value(Integer i) : storage_(std::move(i)) {}     // NOLINT
  Value(double d) : storage_(d) {}                 // NOLINT
  Value(std::string s) : storage_(std::make_shared<const std::string>(std::move(s))) {}  // NOLINT
  Value(std::string_view s) : Value(std::string(s)) {}                                   // NOLINT
  Value(const char* s) : Value(std::string(s)) {}                                        // NOLINT
  Value(Type t) : storage_(t) {}                                                         // NOLINT
  Value(const Builtin* f) : storage_(f) {}                                               // NOLINT
  Value(NamespaceRef n) : storage_(n) {}                                                 // NOLINT
  template <typename T>
  Value(std::shared_ptr<T> object) : storage_(std::move(object)) {}  // NOLINT

  [[nodiscard]] const Storage& storage() const { return storage_; }
  template <typename T>
  [[nodiscard]] const T* as() const {
    return std::get_if<T>(&storage_);
  }
  template <typename T>
  [[nodiscard]] T* object() const {  ///< the shared object, or null
    const auto* held = std::get_if<std::shared_ptr<T>>(&storage_);
    return held != nullptr ? held->get() : nullptr;
  }

  [[nodiscard]] bool is_none() const { return as<None>() != nullptr; }
  [[nodiscard]] const std::string* text() const {
    const auto* held = as<Text>();
    return held != nullptr ? held->get() : nullptr;
  }
  [[nodiscard]] Type type() const;

 private:
  Storage storage_;
};

/// `is_dotted` marks what came from YAML or dotify(): items are reached by attributes as well, at any depth.
/// Reaching an item of a dotted container gives a container of its own over the same items, which are copied when one
/// side changes.
struct List {
  std::shared_ptr<Values> items = std::make_shared<Values>();
  bool is_dotted = false;

  [[nodiscard]] Values& to_change(Runtime& runtime);
};

struct Tuple {
  Values items;
};

/// Keys and values in order of insertion; keys are hashable values.
class Table {
 public:
  using Entry = std::pair<Value, Value>;
  [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }
  [[nodiscard]] const Value* find(Runtime& runtime, const Value& key) const;
  void set(Runtime& runtime, Value key, Value value);  ///< an existing key keeps its place
  bool erase(Runtime& runtime, const Value& key);
  void clear();

 private:
  static constexpr std::size_t kNotFound = static_cast<std::size_t>(-1);
  [[nodiscard]] std::size_t index_of(Runtime& runtime, const Value& key, std::size_t hash) const;
  std::vector<Entry> entries_;
  std::unordered_multimap<std::size_t, std::size_t> index_;  // hash of the key to place
};

struct Dict {
  std::shared_ptr<Table> table = std::make_shared<Table>();
  bool is_dotted = false;

  [[nodiscard]] Table& to_change(Runtime& runtime);
};

struct Set {
  Table table;  ///< values unused
  bool is_frozen = false;
};

struct Range {
  std::int64_t start = 0;
  std::int64_t stop = 0;
  std::int64_t step = 1;
  [[nodiscard]] std::int64_t size() const;
  [[nodiscard]] std::int64_t at(std::int64_t i) const { return start + i * step; }
};

struct Slice {
  std::shared_ptr<const Values> bounds;  ///< start, stop, step; None where left out
};

/// What map, zip, generators and the like give: items that are consumed once. They are made when it is created.
struct Iterator {
  Type type = Type::generator;
  Values items;
  std::size_t next = 0;
};

struct DictView {
  Type type = Type::dict_keys;
  std::shared_ptr<Dict> dict;
};

/// `lambda`: an expression with its parameters and the names around it.
struct Lambda {
  const Expression* code = nullptr;
  Values defaults;  ///< of the last parameters
  std::shared_ptr<Locals> locals;
  Scope* scope = nullptr;
};

struct BoundMethod {
  std::shared_ptr<const Value> self;
  const Method* method = nullptr;
};

/// Python's name of a value's type: "int".
std::string_view type_name(Type type);
std::string_view type_name(const Value& value);

Value make_list(Values items);
Value make_tuple(Values items);
Value make_dict(std::shared_ptr<Table> table);
Value make_iterator(Type type, Values items);

/// Python's bool(value).
bool is_true(const Value& value);

/// The number an int, bool or float is, or null.
const double* as_real(const Value& value);
/// The integer an int or bool is, or nothing.
std::optional<Integer> as_integer(const Value& value);

/// An item of a dotted container as its reader gets it: dotted as well.
Value dotted(const Value& item);

}  // namespace finemote::gen::expression
