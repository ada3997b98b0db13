#include "generator/expression/library.hpp"

#include <utility>

namespace finemote::gen::expression {
namespace {

void add(Scope& scope, Symbols symbols) {
  for (auto& [name, value] : symbols) scope.set(name, {std::move(value), false, {}});
}

}  // namespace

Library::Library() {
  add(builtins_, global_symbols());
  add_name_space("python", python_, python_symbols());
  add_name_space("math", math_, math_symbols());
  add_name_space("xacro", xacro_, xacro_symbols());
}

void Library::add_name_space(const char* name, Scope& scope, Symbols symbols) {
  add(scope, std::move(symbols));
  builtins_.set(name, {NamespaceRef{&scope}, false, {}});
}

void add_eval_symbols(Scope& scope) {
  add(scope, math_symbols());
  add(scope, {{"list", Type::list},
              {"dict", Type::dict},
              {"map", Type::map},
              {"str", Type::text},
              {"float", Type::real},
              {"int", Type::integer},
              {"true", true},
              {"false", false}});
}

}  // namespace finemote::gen::expression
