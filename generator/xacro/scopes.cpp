#include "generator/xacro/scopes.hpp"

#include <utility>

namespace finemote::gen::xacro {

Context Scopes::open_name_space(const std::string& name, const Context& context) {
  auto scope = std::make_unique<Scope>(Scope::Kind::name_space, context.scope);
  auto macros = std::make_unique<MacroScope>();
  const Context inner{scope.get(), macros.get(), context.via, context.is_placed};
  context.scope->set(name, {NamespaceRef{scope.get()}, false, {}});
  context.macros->define(name, macros.get());
  context.scope->keep();
  keep(std::move(scope), std::move(macros));
  return inner;
}

void Scopes::close(std::unique_ptr<Scope> scope, std::unique_ptr<MacroScope> macros) {
  if (scope->is_kept()) keep(std::move(scope), std::move(macros));
}

void Scopes::keep(std::unique_ptr<Scope> scope, std::unique_ptr<MacroScope> macros) {
  kept_scopes_.push_back(std::move(scope));
  kept_macros_.push_back(std::move(macros));
}

}  // namespace finemote::gen::xacro
