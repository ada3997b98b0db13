#include "generator/expression/locals.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/expression/failure.hpp"
#include "generator/expression/iterate.hpp"

namespace finemote::gen::expression {
namespace {

void bind_name(Locals& locals, const std::string& bound, const Value& value) {
  for (auto& [name, held] : locals.names) {
    if (name == bound) {
      held = value;
      return;
    }
  }
  locals.names.emplace_back(bound, value);
}

}  // namespace

const Value* find_local(const Locals* locals, const std::string& name) {
  for (const Locals* frame = locals; frame != nullptr; frame = frame->outer.get()) {
    for (const auto& [bound, value] : frame->names) {
      if (bound == name) return &value;
    }
  }
  return nullptr;
}

void bind(Runtime& runtime, Locals& locals, const Expression& target, const Value& value) {
  if (target.kind == Expression::Kind::name) return bind_name(locals, target.name, value);
  const Values parts = items_of(runtime, value);
  if (parts.size() < target.operands.size()) {
    fail_eval(fmt::format("not enough values to unpack (expected {}, got {})", target.operands.size(), parts.size()));
  }
  if (parts.size() > target.operands.size()) {
    fail_eval(fmt::format("too many values to unpack (expected {})", target.operands.size()));
  }
  for (std::size_t i = 0; i < parts.size(); ++i) bind(runtime, locals, *target.operands[i], parts[i]);
}

LocalsPtr bind_parameters(const Lambda& function, CallArguments& arguments) {
  const auto& parameters = function.code->parameters;
  const std::size_t given = arguments.positional.size();
  if (given > parameters.size()) {
    fail_eval(fmt::format("<lambda>() takes {} positional argument{} but {} {} given", parameters.size(),
                          parameters.size() == 1 ? "" : "s", given, given == 1 ? "was" : "were"));
  }
  auto frame = std::make_shared<Locals>();
  frame->outer = function.locals;
  const std::size_t first_default = parameters.size() - function.defaults.size();
  for (auto& [name, value] : arguments.named) {
    if (std::find(parameters.begin(), parameters.end(), name) == parameters.end()) {
      fail_eval(fmt::format("<lambda>() got an unexpected keyword argument '{}'", name));
    }
  }
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const auto named = std::find_if(arguments.named.begin(), arguments.named.end(),
                                    [&](const auto& argument) { return argument.first == parameters[i]; });
    if (i < given) {
      frame->names.emplace_back(parameters[i], arguments.positional[i]);
    } else if (named != arguments.named.end()) {
      frame->names.emplace_back(parameters[i], named->second);
    } else if (i >= first_default) {
      frame->names.emplace_back(parameters[i], function.defaults[i - first_default]);
    } else {
      fail_eval(fmt::format("<lambda>() missing 1 required positional argument: '{}'", parameters[i]));
    }
  }
  return frame;
}

}  // namespace finemote::gen::expression
