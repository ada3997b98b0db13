// The scope that encloses all others: the built-ins, and the namespaces `python`, `math` and `xacro`.
#pragma once

#include "generator/expression/builtins.hpp"
#include "generator/expression/scope.hpp"

namespace finemote::gen::expression {

class Library {
 public:
  Library();
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;

  [[nodiscard]] Scope& scope() { return builtins_; }

 private:
  void add_name_space(const char* name, Scope& scope, Symbols symbols);

  Scope python_{Scope::Kind::name_space, nullptr};
  Scope math_{Scope::Kind::name_space, nullptr};
  Scope xacro_{Scope::Kind::name_space, nullptr};
  Scope builtins_{Scope::Kind::builtins, nullptr};
};

/// Adds what $(eval) sees besides the arguments: `math`, some types, true and false.
void add_eval_symbols(Scope& scope);

}  // namespace finemote::gen::expression
