// What a running expression works with: its budget and the world it may ask.
#pragma once

#include <string>

#include "generator/expression/budget.hpp"
#include "generator/expression/value.hpp"

namespace finemote::gen::expression {

enum class MessageKind { message, warning, error };

/// The expansion as an expression sees it. An expression reaches nothing else.
class Host {
 public:
  virtual ~Host() = default;
  virtual Value load_yaml(const std::string& file) = 0;
  /// The path relative to the file being processed; absolute paths unchanged.
  virtual std::string absolute_name(const std::string& file) = 0;
  /// Value of a command line or xacro:arg argument, or null.
  virtual const std::string* argument(const std::string& name) = 0;
  virtual void say(MessageKind kind, const std::string& text, bool with_location) = 0;
  /// Name of a deprecated global function that was called, and the namespace it is in now.
  virtual void deprecated(std::string_view name, std::string_view name_space) = 0;
  /// Value of a property or built-in visible in `scope`, evaluated now if it was not; nothing when undefined.
  virtual std::optional<Value> look_up(Scope& scope, const std::string& name) = 0;
  /// Keeps the scope alive although its macro call ends: a lambda refers to it.
  virtual void keep(Scope& scope) = 0;
};

class Runtime {
 public:
  explicit Runtime(Host& h) : host(h) {}
  Host& host;
  Budget budget;
  std::size_t depth = 0;  ///< of the recursion over expressions and values
};

}  // namespace finemote::gen::expression
