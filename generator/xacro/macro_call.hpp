// A call of a macro: which one it means, and what its parameters are.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "generator/xacro/context.hpp"
#include "generator/xacro/properties.hpp"
#include "generator/xacro/text_evaluator.hpp"
#include "generator/xml/node.hpp"

namespace finemote::gen::xacro {

/// The macro a call means, and what surrounds its arguments and its body.
class Callee {
 public:
  /// @param name  of a macro, or `N.m` for one of a namespace
  /// Fails at the call when there is no such macro.
  Callee(const xml::Node& call, const std::string& name, const Context& context);
  Callee(const Callee&) = delete;
  Callee& operator=(const Callee&) = delete;

  [[nodiscard]] const Macro& macro() const { return *macro_; }
  [[nodiscard]] const Context& arguments() const { return arguments_; }  ///< where arguments and blocks are evaluated
  [[nodiscard]] const Context& body() const { return body_; }            ///< what encloses the scope of the body

 private:
  void find_in_name_space(const std::string& name, const Context& context);

  std::shared_ptr<const Macro> macro_;  // a macro may be redefined while it runs
  Context arguments_;
  Context body_;
  // The names the arguments of `N.m` see: those of the namespace first.
  Scope argument_scope_{Scope::Kind::local, nullptr};
  MacroScope argument_macros_;
};

/// Gives the parameters of a call their values, in the scope of the body: the steps are called in this order.
class ParameterBinder {
 public:
  ParameterBinder(const xml::Node& call, const Callee& callee, Scope& scope, TextEvaluator& evaluator,
                  Properties& properties);

  /// The attributes of the call; fails at one that is no parameter.
  void bind_arguments();
  /// The evaluated elements inside the call go to the block parameters in order; fails when the numbers differ.
  void bind_blocks(xml::Node content);
  /// The defaults of what is open still; fails for parameters without.
  void bind_defaults();

 private:
  using Open = std::vector<const Parameter*>;  // that have no value yet
  [[nodiscard]] Open::iterator open_parameter(const xml::Attribute& argument);
  Value default_of(const Parameter& parameter);

  const xml::Node& call_;
  const Callee& callee_;
  Scope& scope_;
  TextEvaluator& evaluator_;
  Properties& properties_;
  Position at_;  // of the call
  Open open_;
};

}  // namespace finemote::gen::xacro
