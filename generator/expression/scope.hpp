// Properties: names with texts that become values when they are first asked for.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "generator/diagnostic/source.hpp"
#include "generator/expression/value.hpp"

namespace finemote::gen::expression {

struct Property {
  Value value;
  bool is_unevaluated = false;  ///< `value` is the text still to be evaluated, in the scope that holds the property
  Position at;                  ///< of its text
};

/// A name with its hash, so that a search through many scopes computes it once.
struct HashedName {
  std::string_view text;
  std::size_t hash;
  explicit HashedName(std::string_view name) : text(name), hash(std::hash<std::string_view>{}(name)) {}
  friend bool operator==(const std::string& a, const HashedName& b) { return a == b.text; }
};

/// Lets maps be searched with a view.
struct TextHash {
  using is_transparent = void;
  std::size_t operator()(std::string_view text) const { return std::hash<std::string_view>{}(text); }
  std::size_t operator()(const HashedName& name) const { return name.hash; }
};

/// One level of names. A macro call opens one, a namespace is one; the outermost holds the built-ins.
class Scope {
 public:
  enum class Kind { builtins, local, name_space };

  Scope(Kind kind, Scope* parent) : kind_(kind), parent_(parent) {}

  [[nodiscard]] Kind kind() const { return kind_; }
  [[nodiscard]] Scope* parent() const { return parent_; }  ///< null for the built-ins

  /// Where the arguments of a call into a namespace look after the namespace: the scope of the call.
  void set_fallback(Scope* fallback) { fallback_ = fallback; }

  struct Found {
    Scope* scope = nullptr;
    Property* property = nullptr;
    explicit operator bool() const { return property != nullptr; }
  };
  /// The innermost property of that name.
  [[nodiscard]] Found find(std::string_view name) { return find(HashedName(name)); }

  /// All names visible here, sorted: for suggestions.
  [[nodiscard]] std::vector<std::string> names() const;

  void set(std::string_view name, Property property);
  /// Takes the name out of this scope and all outer ones but the built-ins.
  void remove(std::string_view name);
  /// The scope that the built-ins enclose.
  [[nodiscard]] Scope& top();
  [[nodiscard]] bool is_builtin(std::string_view name);

  /// Something refers to the scope, and so to all around it, beyond its macro call.
  void keep();
  [[nodiscard]] bool is_kept() const { return is_kept_; }

  /// Names being evaluated in this scope, to find circles.
  std::vector<std::string> evaluating;

 private:
  [[nodiscard]] Found find(const HashedName& name);

  Kind kind_;
  Scope* parent_;
  Scope* fallback_ = nullptr;
  bool is_kept_ = false;
  std::unordered_map<std::string, Property, TextHash, std::equal_to<>> properties_;
};

}  // namespace finemote::gen::expression
