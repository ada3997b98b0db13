// The names of a document: its outermost scopes, and those that outlive what opened them.
#pragma once

#include <deque>
#include <memory>
#include <string>

#include "generator/xacro/context.hpp"

namespace finemote::gen::xacro {

class Scopes {
 public:
  explicit Scopes(Scope& builtins) : top_(Scope::Kind::local, &builtins) {}

  /// What surrounds the root of the entry.
  [[nodiscard]] Context top() { return {&top_, &top_macros_, nullptr, false}; }

  /// New tables of properties and macros, known in the enclosing ones by the name of the namespace.
  Context open_name_space(const std::string& name, const Context& context);

  /// Ends the scope of a call, unless a namespace or a function still refers to it.
  void close(std::unique_ptr<Scope> scope, std::unique_ptr<MacroScope> macros);

 private:
  void keep(std::unique_ptr<Scope> scope, std::unique_ptr<MacroScope> macros);

  std::deque<std::unique_ptr<Scope>> kept_scopes_;
  std::deque<std::unique_ptr<MacroScope>> kept_macros_;
  Scope top_;
  MacroScope top_macros_;
};

}  // namespace finemote::gen::xacro
