// xacro:macro, calls of macros and xacro:call.
#include <fmt/format.h>

#include <algorithm>

#include "generator/xacro/expander.hpp"

namespace finemote::gen::xacro {

void Expander::define_macro(const Node& source, const Context& context, Sink& out, bool has_next) {
  const auto mark = mark_.remove_comments(out, has_next);
  mark_.set(out, mark);
  const xml::Attribute& name = required(source, "name", context);
  check_attributes(source, {"name", "params"}, context);
  const Position at = place(name.value_at, context);
  auto macro = std::make_shared<Macro>();
  macro->name = name.value;
  if (macro->name == "call") throw Failure{code::xacro_macro, "Invalid use of macro name 'call'", at};
  if (macro->name.find('.') != std::string::npos) {
    throw Failure{code::xacro_macro, "macro names must not contain '.' (reserved for namespaces): " + macro->name, at};
  }
  if (macro->name.starts_with("xacro:")) {
    warn(code::xacro_macro_prefix, at, "macro names must not contain prefix 'xacro:': " + macro->name);
    macro->name.erase(0, 6);
  }
  macro->file = files_.back();
  macro->body = std::shared_ptr<const Node>(std::shared_ptr<const Node>(), &source);
  if (const auto* parameters = source.attribute("params")) {
    if (parameters->value.size() > kMaxParameters) {
      throw Failure{code::xacro_limit, "the parameters of the macro are too long",
                    place(parameters->value_at, context)};
    }
    macro->parameters = parse_parameters(parameters->value);
  }
  context.macros->define(std::move(macro));
}

void Expander::call_by_name(const Node& source, const Context& context, Sink& out, bool has_next) {
  const xml::Attribute& macro = required(source, "macro", context);
  const Position at = place(macro.value_at, context);
  if (macro.value.empty()) throw Failure{code::xacro_call, "xacro:call is missing the 'macro' attribute", at};
  call_macro(source, text_of(macro.value, at, *context.scope), context, out, has_next);
}

void Expander::call_macro(const Node& source, const std::string& name, const Context& context, Sink& out,
                          bool has_next) {
  const Position at = place(source.at, context);
  Call call{context.macros->find_macro(name), context, context};

  // `N.m`: the macro, and the names its arguments see first, are those of the namespace.
  Scope argument_scope(Scope::Kind::local, nullptr);
  MacroScope argument_macros;
  if (!call.macro && name.find('.') != std::string::npos) {
    std::string_view rest = name;
    for (auto dot = rest.find('.'); dot != std::string_view::npos && call.body.macros != nullptr;
         dot = rest.find('.')) {
      const std::string space(rest.substr(0, dot));
      call.body.macros = call.body.macros->find_namespace(space);
      const auto found = call.body.scope->find(space);
      const auto* reference = found ? found.property->value.as<NamespaceRef>() : nullptr;
      if (reference == nullptr) call.body.macros = nullptr;
      if (reference != nullptr) call.body.scope = reference->scope;
      rest.remove_prefix(dot + 1);
    }
    if (call.body.macros != nullptr) {
      call.macro = call.body.macros->find_macro(rest);
      argument_scope = Scope(Scope::Kind::local, call.body.scope);
      argument_scope.set_fallback(context.scope);
      argument_macros = MacroScope(call.body.macros);
      argument_macros.set_fallback(context.macros);
      call.arguments.scope = &argument_scope;
      call.arguments.macros = &argument_macros;
    }
  }
  if (!call.macro) {
    throw Failure{code::xacro_unknown_macro,
                  "unknown macro name: xacro:" + name,
                  at,
                  {},
                  near_hint(name, context.macros->names())};
  }
  if (++calls_ > kMaxCalls) throw Failure{code::xacro_limit, fmt::format("more than {} macro calls", kMaxCalls), at};
  if (calls_open_.size() >= kMaxNestedCalls) {
    throw Failure{code::xacro_limit,
                  fmt::format("maximum recursion depth exceeded: macro '{}' is called inside itself "
                              "without end, or {} calls are nested",
                              call.macro->name, kMaxNestedCalls),
                  at};
  }
  calls_open_.push_back(call.macro.get());
  const std::size_t begin = out.end();
  run_macro(source, call, out);
  const auto mark = mark_.remove_comments(out, begin, has_next);
  mark_.set(out, mark);
  calls_open_.pop_back();
}

void Expander::run_macro(const Node& source, const Call& call, Sink& out) {
  const Macro& macro = *call.macro;
  auto scope = std::make_unique<Scope>(Scope::Kind::local, call.body.scope);
  auto macros = std::make_unique<MacroScope>(call.body.macros);
  OpenParameters open;
  for (const Parameter& parameter : macro.parameters) open.push_back(&parameter);
  bind_arguments(source, call, *scope, open);
  bind_blocks(source, call, *scope, open);
  bind_defaults(source, call, *scope, open);

  const Expansion* via = sources_.add(Expansion{Expansion::Kind::macro, macro.name, place(source.at, call.body)});
  const Context inner{scope.get(), macros.get(), via, false};
  lift_namespaces(*macro.body, out.element, via->at);
  warn_of_lost_attributes(*macro.body, inner, out);
  Sink content{out.element, out.id, out.end()};
  expand_children(*macro.body, inner, content);
  release(std::move(scope), std::move(macros));
}

void Expander::bind_arguments(const Node& source, const Call& call, Scope& scope, OpenParameters& open) {
  const bool is_dynamic = source.name == "xacro:call";
  for (const xml::Attribute& a : source.attributes) {
    if (is_dynamic && a.name == "macro") continue;
    const Position at = place(a.value_at, call.body);
    const auto parameter =
        std::find_if(open.begin(), open.end(), [&](const Parameter* p) { return p->name == a.name; });
    if (parameter == open.end()) {
      std::string names;
      for (const Parameter& p : call.macro->parameters) names += (names.empty() ? "" : ", ") + p.name;
      throw Failure{code::xacro_call,
                    fmt::format("Invalid parameter \"{}\"", a.name),
                    place(a.at, call.body),
                    {},
                    {fmt::format("macro '{}' takes: {}", call.macro->name, names.empty() ? "nothing" : names)}};
    }
    open.erase(parameter);
    set_property(scope, a.name, value_of(a.value, at, *call.arguments.scope), false, at);
  }
}

/// The elements inside the call are evaluated with the names of the caller, and go to the block parameters in order.
void Expander::bind_blocks(const Node& source, const Call& call, Scope& scope, OpenParameters& open) {
  Node content;
  Sink sink{content, ++elements_};
  expand_children(source, call.arguments, sink);
  const Position at = place(source.at, call.body);
  auto next = content.children.begin();
  const auto find_element = [&] {
    next = std::find_if(next, content.children.end(), [](const Node& n) { return n.is_element(); });
  };
  find_element();
  for (auto parameter = open.begin(); parameter != open.end();) {
    if (!(*parameter)->is_block()) {
      ++parameter;
      continue;
    }
    if (next == content.children.end()) {
      throw Failure{
          code::xacro_call,
          "Not enough blocks",
          at,
          {},
          {fmt::format("macro '{}' needs an element for its block '{}'", call.macro->name, (*parameter)->name)}};
    }
    scope.set((*parameter)->name,
              {block_value(std::make_shared<const Node>(std::move(*next)), nullptr, true), false, at});
    ++next;
    find_element();
    parameter = open.erase(parameter);
  }
  if (next != content.children.end()) {
    throw Failure{code::xacro_call, fmt::format("Unused block \"{}\"", next->name), next->at};
  }
}

void Expander::bind_defaults(const Node& source, const Call& call, Scope& scope, OpenParameters& open) {
  const Position at = place(source.at, call.body);
  std::string undefined;
  for (const Parameter* parameter : open) {
    if (parameter->has_default()) {
      set_property(scope, parameter->name, default_of(*parameter, call, at), false, at);
    } else {
      undefined += (undefined.empty() ? "" : ",") + parameter->name;
    }
  }
  if (!undefined.empty()) {
    throw Failure{code::xacro_call,
                  fmt::format("Undefined parameters [{}]", undefined),
                  at,
                  {},
                  {fmt::format("add for example {}=\"...\" to the call of '{}'",
                               undefined.substr(0, undefined.find(',')), call.macro->name)}};
  }
}

Value Expander::default_of(const Parameter& parameter, const Call& call, const Position& at) {
  if (parameter.is_forwarded) {
    const auto found = call.arguments.scope->find(parameter.name);
    if (found) return property_value(found, parameter.name);
    if (!parameter.default_text) {
      throw Failure{code::xacro_call, "Undefined property to forward: " + parameter.name, at};
    }
  }
  try {
    return value_of(*parameter.default_text, at, *call.arguments.scope);
  } catch (Failure& failure) {
    const xml::Attribute* params = call.macro->body->attribute("params");
    failure.notes.push_back({fmt::format("'{}' is the default of the parameter '{}' of macro '{}'",
                                         *parameter.default_text, parameter.name, call.macro->name),
                             params != nullptr ? params->value_at : call.macro->body->at});
    throw;
  }
}

/// Ends the scope of a call, unless a namespace or a function still refers to it.
void Expander::release(std::unique_ptr<Scope> scope, std::unique_ptr<MacroScope> macros) {
  if (!scope->is_kept) return;
  kept_scopes_.push_back(std::move(scope));
  kept_macros_.push_back(std::move(macros));
}

}  // namespace finemote::gen::xacro
