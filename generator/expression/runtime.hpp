// What a running expression works with: its budget and the world it may ask.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "generator/diagnostic/source.hpp"
#include "generator/expression/budget.hpp"
#include "generator/expression/value.hpp"

namespace finemote::gen::expression {

/// The names of the document around an expression.
class Names {
 public:
  virtual ~Names() = default;
  /// Value of a property or built-in visible in `scope`, evaluated now if it was not; nothing when undefined.
  virtual std::optional<Value> look_up(Scope& scope, const std::string& name) = 0;
};

enum class MessageKind { message, warning, error };

/// What the functions of the `xacro.` namespace ask for. An expression reaches nothing else outside of itself.
class Services {
 public:
  virtual ~Services() = default;
  /// The text of a YAML file; null when it is empty, fails when it cannot be read.
  virtual const SourceFile* open_yaml(const std::string& file) = 0;
  /// The path relative to the file being processed; absolute paths unchanged.
  virtual std::string absolute_name(const std::string& file) = 0;
  /// Value of a command line or xacro:arg argument, or null.
  virtual const std::string* argument(const std::string& name) = 0;
  virtual void say(MessageKind kind, const std::string& text, bool with_location) = 0;
  /// Name of a deprecated global function that was called, and the namespace it is in now.
  virtual void deprecated(std::string_view name, std::string_view name_space) = 0;
};

class Runtime {
 public:
  Runtime(Names& n, Services& s, Scope& b) : names(n), services(s), builtins(b) {}
  Names& names;
  Services& services;
  Scope& builtins;  ///< of the library
  Budget budget;
  std::size_t depth = 0;  ///< of the recursion over expressions and values
};

}  // namespace finemote::gen::expression
