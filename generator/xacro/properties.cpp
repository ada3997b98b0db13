#include "generator/xacro/properties.hpp"

#include "generator/xacro/block.hpp"
#include "generator/xacro/tag.hpp"

namespace finemote::gen::xacro {
namespace {

void check_name(const std::string& name, const Position& at) {
  if (!expression::is_identifier(name)) {
    throw Failure{code::xacro_property,
                  "Property names must be valid python identifiers: " + name,
                  at,
                  {},
                  {"letters, digits and '_', not beginning with a digit, and no word of Python"}};
  }
  if (name.starts_with("__")) {
    throw Failure{code::xacro_property, "Property names must not start with double underscore:" + name, at};
  }
}

/// The scope around the one of the tag, for scope="parent".
Scope& parent_of(const Context& context, const std::string& name, const Position& at) {
  Scope* target = context.scope->parent();
  // A macro of a namespace writes to the scope of its caller, which encloses the namespace.
  const bool in_macro = context.scope->kind() != Scope::Kind::name_space;
  while (in_macro && target->kind() == Scope::Kind::name_space) target = target->parent();
  if (target->kind() == Scope::Kind::builtins) {
    throw Failure{code::xacro_property, name + ": no parent scope at global scope", at};
  }
  return *target;
}

}  // namespace

void Properties::define(const xml::Node& tag, const Context& context) {
  const xml::Attribute& name_attribute = required(tag, "name", context);
  check_attributes(tag, {"name", "value", "default", "remove", "scope", "lazy_eval"}, context, warnings_);
  const Position at = context.place(name_attribute.value_at);
  const std::string name = evaluator_.text_of(name_attribute.value, at, *context.scope);
  check_name(name, at);

  const bool removes = is_removal(tag, context, at);
  const bool has_default = tag.attribute("default") != nullptr;
  const int kinds = (tag.attribute("value") != nullptr ? 1 : 0) + (has_default ? 1 : 0) + (removes ? 1 : 0);
  if (kinds > 1) {
    throw Failure{code::xacro_property,
                  "Property attributes default, value, and remove are mutually exclusive: " + name, at};
  }
  const bool is_visible = static_cast<bool>(context.scope->find(name));
  if (removes && is_visible) {
    if (context.scope->is_builtin(name)) {
      warnings_.add(code::xacro_ignored, at, "Cannot remove global symbol: " + name);
    }
    context.scope->remove(name);
    return;
  }
  if (has_default && tag.attribute("scope") != nullptr) {
    warnings_.add(code::xacro_ignored, at, name + ": default property value can only be defined on local scope");
  }
  if (has_default && is_visible) return;
  store(tag, context, name);
}

bool Properties::is_removal(const xml::Node& tag, const Context& context, const Position& at) {
  const xml::Attribute* remove = tag.attribute("remove");
  const std::string asked = remove != nullptr && !remove->value.empty() ? remove->value : "false";
  return condition_of(evaluator_.value_of(asked, at, *context.scope), remove != nullptr ? remove->value : "None", at);
}

bool Properties::is_lazy(const xml::Node& tag, const Context& context) {
  const xml::Attribute* lazy = tag.attribute("lazy_eval");
  if (lazy == nullptr || lazy->value.empty()) return true;
  const Position at = context.place(lazy->value_at);
  return condition_of(evaluator_.value_of(lazy->value, at, *context.scope), lazy->value, at);
}

void Properties::store(const xml::Node& tag, const Context& context, const std::string& name) {
  const Position at = context.place(tag.at);
  Scope* target = context.scope;
  bool is_evaluated_later = is_lazy(tag, context);
  if (const xml::Attribute* where = tag.attribute("scope"); where != nullptr) {
    const bool is_global = where->value == "global";
    const bool is_parent = where->value == "parent";
    if (is_global) target = &context.scope->top();
    if (is_parent) target = &parent_of(context, name, at);
    if (is_global || is_parent) is_evaluated_later = false;
  }

  const xml::Attribute* value = tag.attribute("value");
  if (value == nullptr) value = tag.attribute("default");
  if (value == nullptr) {
    const std::shared_ptr<const xml::Node> kept(std::shared_ptr<const xml::Node>(), &tag);  // the document keeps it
    return set(*target, "**" + name, block_value(kept, context.via, context.is_placed), false, at);
  }
  const Position value_at = context.place(value->value_at);
  if (is_evaluated_later) return set(*target, name, value->value, true, value_at);
  set(*target, name, evaluator_.value_of(value->value, value_at, *context.scope), false, value_at);
}

void Properties::set(Scope& scope, const std::string& name, Value value, bool is_unevaluated, const Position& at) {
  if (scope.is_builtin(name)) {
    warnings_.add(code::xacro_redefined_symbol, at, "redefining global symbol: " + name);
  }
  value = expression::literal_of(std::move(value));
  const bool is_text = value.text() != nullptr;
  scope.set(name, {std::move(value), is_unevaluated && is_text, at});
}

}  // namespace finemote::gen::xacro
