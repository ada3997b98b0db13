// Functions and methods of the library: what they are called, which arguments they take, what they do.
#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <span>
#include <string_view>

#include "generator/expression/value.hpp"

namespace finemote::gen::expression {

class Parameters;
class Runtime;

/// The arguments a function takes. Parameters checks a call against it, before the function runs.
struct Signature {
  enum class Kind { named, positional, free };
  static constexpr std::size_t kMostNames = 4;
  static constexpr std::size_t kAnyNumber = std::numeric_limits<std::size_t>::max();

  Kind kind = Kind::named;
  std::array<std::string_view, kMostNames> names = {};  ///< of the parameters, which keywords may name as well
  std::size_t least = 0;                                ///< how many parameters, from the first on, must be given
  std::size_t most = 0;
  std::string_view shown = {};  ///< the name that messages use; empty for the function's own

  constexpr Signature() = default;  ///< no arguments
  /// Parameters in order, of which the first `required` must be given.
  constexpr Signature(std::initializer_list<std::string_view> parameters, std::size_t required,
                      std::string_view shown_name = {})
      : least(required), most(parameters.size()), shown(shown_name) {
    std::size_t i = 0;
    for (const std::string_view parameter : parameters) names[i++] = parameter;
  }

  /// A number of arguments without names, and no keywords.
  static constexpr Signature positional(std::size_t fewest, std::size_t most_of_all = kAnyNumber) {
    Signature signature;
    signature.kind = Kind::positional;
    signature.least = fewest;
    signature.most = most_of_all;
    return signature;
  }
  /// Anything: the function looks at its arguments itself.
  static constexpr Signature free() {
    Signature signature;
    signature.kind = Kind::free;
    return signature;
  }
};

/// A function that has a name of its own.
struct Builtin {
  std::string_view name;
  Signature takes;
  Value (*call)(Runtime& runtime, const Parameters& p);
  std::string_view deprecated_for = {};  ///< namespace that replaces this bare name; empty: not deprecated
};

/// A function that belongs to a type: `value.name(...)`.
struct Method {
  std::string_view name;
  Signature takes;
  Value (*call)(Runtime& runtime, const Value& self, const Parameters& p);
};

/// The row of a table with that name, or null.
inline const Method* find_method(std::span<const Method> table, std::string_view name) {
  for (const Method& method : table) {
    if (method.name == name) return &method;
  }
  return nullptr;
}

}  // namespace finemote::gen::expression
