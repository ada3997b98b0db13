// xacro:property.
#pragma once

#include <string>

#include "generator/xacro/context.hpp"
#include "generator/xacro/text_evaluator.hpp"
#include "generator/xacro/warnings.hpp"
#include "generator/xml/node.hpp"

namespace finemote::gen::xacro {

/// Puts properties into scopes.
class Properties {
 public:
  Properties(TextEvaluator& evaluator, Warnings& warnings) : evaluator_(evaluator), warnings_(warnings) {}

  /// Does what a xacro:property says: defines or removes. The document `tag` is in outlives the scope.
  void define(const xml::Node& tag, const Context& context);

  /// Gives `scope` a property; a text that is not to be evaluated later becomes the value Python reads in it.
  void set(Scope& scope, const std::string& name, Value value, bool is_unevaluated, const Position& at);

 private:
  [[nodiscard]] bool is_removal(const xml::Node& tag, const Context& context, const Position& at);
  [[nodiscard]] bool is_lazy(const xml::Node& tag, const Context& context);
  void store(const xml::Node& tag, const Context& context, const std::string& name);

  TextEvaluator& evaluator_;
  Warnings& warnings_;
};

}  // namespace finemote::gen::xacro
