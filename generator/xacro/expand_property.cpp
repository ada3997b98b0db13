// xacro:property.
#include <fmt/format.h>

#include "generator/xacro/expander.hpp"

namespace finemote::gen::xacro {

void Expander::check_property_name(const std::string& name, const Position& at) const {
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

void Expander::define_property(const Node& source, const Context& context, Sink& out, bool has_next) {
  const auto mark = mark_.remove_comments(out, has_next);
  mark_.set(out, mark);
  const xml::Attribute& name_attribute = required(source, "name", context);
  check_attributes(source, {"name", "value", "default", "remove", "scope", "lazy_eval"}, context);
  const Position at = place(name_attribute.value_at, context);
  const std::string name = text_of(name_attribute.value, at, *context.scope);
  check_property_name(name, at);

  const xml::Attribute* remove = source.attribute("remove");
  const std::string asked = remove != nullptr && !remove->value.empty() ? remove->value : "false";
  const bool is_removal =
      boolean_of(value_of(asked, at, *context.scope), remove != nullptr ? remove->value : "None", at);
  const xml::Attribute* fallback = source.attribute("default");
  const int kinds =
      (source.attribute("value") != nullptr ? 1 : 0) + (fallback != nullptr ? 1 : 0) + (is_removal ? 1 : 0);
  if (kinds > 1) {
    throw Failure{code::xacro_property,
                  "Property attributes default, value, and remove are mutually exclusive: " + name, at};
  }
  const bool is_visible = static_cast<bool>(context.scope->find(name));
  if (is_removal && is_visible) {
    if (context.scope->is_builtin(name)) warn(code::xacro_ignored, at, "Cannot remove global symbol: " + name);
    context.scope->remove(name);
    return;
  }
  if (fallback != nullptr && source.attribute("scope") != nullptr) {
    warn(code::xacro_ignored, at, name + ": default property value can only be defined on local scope");
  }
  if (fallback != nullptr && is_visible) return;
  store_property(source, context, name);
}

void Expander::store_property(const Node& source, const Context& context, const std::string& name) {
  Scope* target = context.scope;
  const xml::Attribute* lazy = source.attribute("lazy_eval");
  const Position at = place(source.at, context);
  bool is_lazy = true;
  if (lazy != nullptr && !lazy->value.empty()) {
    const Position lazy_at = place(lazy->value_at, context);
    is_lazy = boolean_of(value_of(lazy->value, lazy_at, *context.scope), lazy->value, lazy_at);
  }
  const xml::Attribute* where = source.attribute("scope");
  if (where != nullptr && where->value == "global") {
    target = &context.scope->top();
    is_lazy = false;
  } else if (where != nullptr && where->value == "parent") {
    target = context.scope->parent();
    is_lazy = false;
    // A macro of a namespace writes to the scope of its caller, which encloses the namespace.
    const bool in_macro = context.scope->kind() != Scope::Kind::name_space;
    while (in_macro && target->kind() == Scope::Kind::name_space) target = target->parent();
    if (target->kind() == Scope::Kind::builtins) {
      throw Failure{code::xacro_property, name + ": no parent scope at global scope", at};
    }
  }

  const xml::Attribute* value = source.attribute("value");
  if (value == nullptr) value = source.attribute("default");
  if (value == nullptr) {
    const std::shared_ptr<const Node> kept(std::shared_ptr<const Node>(), &source);  // the document outlives all blocks
    return set_property(*target, "**" + name, block_value(kept, context.via, context.is_placed), false, at);
  }
  const Position value_at = place(value->value_at, context);
  if (is_lazy) return set_property(*target, name, value->value, true, value_at);
  set_property(*target, name, value_of(value->value, value_at, *context.scope), false, value_at);
}

void Expander::set_property(Scope& scope, const std::string& name, Value value, bool is_unevaluated, Position at) {
  if (scope.is_builtin(name)) warn(code::xacro_redefined_symbol, at, "redefining global symbol: " + name);
  value = expression::literal_of(std::move(value));
  const bool is_text = value.text() != nullptr;
  scope.set(name, {std::move(value), is_unevaluated && is_text, at});
}

}  // namespace finemote::gen::xacro
