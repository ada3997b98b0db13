#include "generator/expression/scope.hpp"

#include <algorithm>

namespace finemote::gen::expression {

Scope::Found Scope::find(const HashedName& name) {
  for (Scope* scope = this; scope != nullptr; scope = scope->parent_) {
    if (scope->kind_ == Kind::builtins && fallback_ != nullptr) return fallback_->find(name);
    const auto found = scope->properties_.find(name);
    if (found != scope->properties_.end()) return {scope, &found->second};
  }
  return {};
}

std::vector<std::string> Scope::names() const {
  std::vector<std::string> names;
  for (const Scope* scope = this; scope != nullptr; scope = scope->parent_) {
    for (const auto& [name, property] : scope->properties_) names.push_back(name);
    if (scope->kind_ != Kind::builtins && scope->fallback_ != nullptr) {
      for (std::string& name : scope->fallback_->names()) names.push_back(std::move(name));
    }
  }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

void Scope::set(std::string_view name, Property property) {
  properties_.insert_or_assign(std::string(name), std::move(property));
}

void Scope::remove(std::string_view name) {
  for (Scope* scope = this; scope->kind_ != Kind::builtins; scope = scope->parent_) {
    const auto found = scope->properties_.find(name);
    if (found != scope->properties_.end()) scope->properties_.erase(found);
  }
}

void Scope::keep() {
  for (Scope* scope = this; scope != nullptr && !scope->is_kept_; scope = scope->parent_) scope->is_kept_ = true;
}

Scope& Scope::top() {
  Scope* scope = this;
  while (scope->parent_->kind_ != Kind::builtins) scope = scope->parent_;
  return *scope;
}

bool Scope::is_builtin(std::string_view name) {
  Scope* scope = this;
  while (scope->parent_ != nullptr) scope = scope->parent_;
  return scope->properties_.find(name) != scope->properties_.end();
}

}  // namespace finemote::gen::expression
