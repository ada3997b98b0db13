#include "generator/xacro/macro_call.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/diagnostic/suggest.hpp"
#include "generator/xacro/block.hpp"

namespace finemote::gen::xacro {

Callee::Callee(const xml::Node& call, const std::string& name, const Context& context)
    : macro_(context.macros->find_macro(name)), arguments_(context), body_(context) {
  if (!macro_ && name.find('.') != std::string::npos) find_in_name_space(name, context);
  if (macro_) return;
  throw Failure{code::xacro_unknown_macro,
                "unknown macro name: xacro:" + name,
                context.place(call.at),
                {},
                near_hint(name, context.macros->names())};
}

void Callee::find_in_name_space(const std::string& name, const Context& context) {
  std::string_view rest = name;
  for (auto dot = rest.find('.'); dot != std::string_view::npos && body_.macros != nullptr; dot = rest.find('.')) {
    const std::string space(rest.substr(0, dot));
    body_.macros = body_.macros->find_namespace(space);
    const auto found = body_.scope->find(space);
    const auto* reference = found ? found.property->value.as<NamespaceRef>() : nullptr;
    if (reference == nullptr) body_.macros = nullptr;
    if (reference != nullptr) body_.scope = reference->scope;
    rest.remove_prefix(dot + 1);
  }
  if (body_.macros == nullptr) return;
  macro_ = body_.macros->find_macro(rest);
  argument_scope_ = Scope(Scope::Kind::local, body_.scope);
  argument_scope_.set_fallback(context.scope);
  argument_macros_ = MacroScope(body_.macros);
  argument_macros_.set_fallback(context.macros);
  arguments_.scope = &argument_scope_;
  arguments_.macros = &argument_macros_;
}

ParameterBinder::ParameterBinder(const xml::Node& call, const Callee& callee, Scope& scope, TextEvaluator& evaluator,
                                 Properties& properties)
    : call_(call),
      callee_(callee),
      scope_(scope),
      evaluator_(evaluator),
      properties_(properties),
      at_(callee.body().place(call.at)) {
  for (const Parameter& parameter : callee.macro().parameters) open_.push_back(&parameter);
}

void ParameterBinder::bind_arguments() {
  const bool is_dynamic = call_.name == "xacro:call";
  for (const xml::Attribute& a : call_.attributes) {
    if (is_dynamic && a.name == "macro") continue;
    const Position at = callee_.body().place(a.value_at);
    open_.erase(open_parameter(a));
    properties_.set(scope_, a.name, evaluator_.value_of(a.value, at, *callee_.arguments().scope), false, at);
  }
}

ParameterBinder::Open::iterator ParameterBinder::open_parameter(const xml::Attribute& argument) {
  const auto found =
      std::find_if(open_.begin(), open_.end(), [&](const Parameter* p) { return p->name == argument.name; });
  if (found != open_.end()) return found;
  std::string names;
  for (const Parameter& p : callee_.macro().parameters) names += (names.empty() ? "" : ", ") + p.name;
  throw Failure{code::xacro_call,
                fmt::format("Invalid parameter \"{}\"", argument.name),
                callee_.body().place(argument.at),
                {},
                {fmt::format("macro '{}' takes: {}", callee_.macro().name, names.empty() ? "nothing" : names)}};
}

void ParameterBinder::bind_blocks(xml::Node content) {
  auto next = content.children.begin();
  const auto find_element = [&] {
    next = std::find_if(next, content.children.end(), [](const xml::Node& n) { return n.is_element(); });
  };
  find_element();
  for (auto parameter = open_.begin(); parameter != open_.end();) {
    if (!(*parameter)->is_block()) {
      ++parameter;
      continue;
    }
    const std::string& name = (*parameter)->name;
    if (next == content.children.end()) {
      throw Failure{code::xacro_call,
                    "Not enough blocks",
                    at_,
                    {},
                    {fmt::format("macro '{}' needs an element for its block '{}'", callee_.macro().name, name)}};
    }
    scope_.set(name, {block_value(std::make_shared<const xml::Node>(std::move(*next)), nullptr, true), false, at_});
    ++next;
    find_element();
    parameter = open_.erase(parameter);
  }
  if (next != content.children.end()) {
    throw Failure{code::xacro_call, fmt::format("Unused block \"{}\"", next->name), next->at};
  }
}

void ParameterBinder::bind_defaults() {
  std::string undefined;
  for (const Parameter* parameter : open_) {
    if (parameter->has_default()) {
      properties_.set(scope_, parameter->name, default_of(*parameter), false, at_);
    } else {
      undefined += (undefined.empty() ? "" : ",") + parameter->name;
    }
  }
  if (!undefined.empty()) {
    throw Failure{code::xacro_call,
                  fmt::format("Undefined parameters [{}]", undefined),
                  at_,
                  {},
                  {fmt::format("add for example {}=\"...\" to the call of '{}'",
                               undefined.substr(0, undefined.find(',')), callee_.macro().name)}};
  }
}

Value ParameterBinder::default_of(const Parameter& parameter) {
  Scope& scope = *callee_.arguments().scope;
  if (parameter.is_forwarded) {
    const auto found = scope.find(parameter.name);
    if (found) return evaluator_.property_value(found, parameter.name);
    if (!parameter.default_text) {
      throw Failure{code::xacro_call, "Undefined property to forward: " + parameter.name, at_};
    }
  }
  try {
    return evaluator_.value_of(*parameter.default_text, at_, scope);
  } catch (Failure& failure) {
    const xml::Node& definition = *callee_.macro().body;
    const xml::Attribute* params = definition.attribute("params");
    failure.notes.push_back({fmt::format("'{}' is the default of the parameter '{}' of macro '{}'",
                                         *parameter.default_text, parameter.name, callee_.macro().name),
                             params != nullptr ? params->value_at : definition.at});
    throw;
  }
}

}  // namespace finemote::gen::xacro
