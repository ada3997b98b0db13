#include "generator/expression/evaluate.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/expression/attribute.hpp"
#include "generator/expression/builtins.hpp"
#include "generator/expression/cost.hpp"
#include "generator/expression/iterate.hpp"
#include "generator/expression/locals.hpp"
#include "generator/expression/operate.hpp"
#include "generator/expression/parameters.hpp"
#include "generator/expression/print.hpp"
#include "generator/expression/runtime.hpp"
#include "generator/expression/scope.hpp"
#include "generator/expression/subscript.hpp"

namespace finemote::gen::expression {
namespace {

using Kind = Expression::Kind;

constexpr const char* kTooDeep = "maximum recursion depth exceeded in an expression";

Value set_of(Runtime& runtime, Values members) {
  auto out = std::make_shared<Set>();
  for (Value& member : members) out->table.set(runtime, std::move(member), {});
  return out;
}

/// Takes `**mapping` into the arguments of a call.
void add_mapping(Runtime& runtime, CallArguments& arguments, const Value& mapping) {
  if (mapping.object<Dict>() == nullptr) fail_eval("argument after ** must be a mapping");
  const auto& entries = mapping.object<Dict>()->table->entries();
  runtime.budget.spend(4 * entries.size());
  for (const auto& [key, value] : entries) {
    if (key.text() == nullptr) fail_eval("keywords must be strings");
    arguments.named.emplace_back(*key.text(), value);
  }
}

/// Puts the outer names back, and lets go of what the inner ones held.
struct Restore {
  LocalsPtr& current;
  LocalsPtr& outer;
  ~Restore() {
    current->names.clear();
    current.swap(outer);
  }
};

class Evaluator {
 public:
  Evaluator(Runtime& runtime, Scope& scope, LocalsPtr locals)
      : runtime_(runtime), scope_(scope), locals_(std::move(locals)) {}

  Value run(const Expression& e) {
    const Level level(runtime_.depth, kMaxEvalDepth, kTooDeep);
    runtime_.budget.spend(1);
    switch (e.kind) {
      case Kind::constant:
        return e.value;
      case Kind::name:
        return name(e.name);
      case Kind::list:
        return make_list(items(e));
      case Kind::tuple:
        return make_tuple(items(e));
      case Kind::set:
        return set_of(runtime_, items(e));
      case Kind::dict:
        return dict(e);
      case Kind::list_of:
        return make_list(comprehension(e));
      case Kind::set_of:
        return set_of(runtime_, comprehension(e));
      case Kind::dict_of:
        return dict_of(e);
      case Kind::generator:
        return make_iterator(Type::generator, comprehension(e));
      case Kind::attribute:
        return attribute_of(runtime_, run(*e.operands[0]), e.name);
      case Kind::subscript:
        return subscripted(e);
      case Kind::slice:
        return slice(e);
      case Kind::call:
        return call(e);
      case Kind::starred:
        fail_eval("can't use starred expression here");
      case Kind::unary:
        return operate(runtime_, e.operators[0], run(*e.operands[0]));
      case Kind::binary:
        return binary(e);
      case Kind::comparison:
        return comparison(e);
      case Kind::logical_and:
        return logical(e, false);
      case Kind::logical_or:
        return logical(e, true);
      case Kind::conditional:
        return run(is_true(run(*e.operands[1])) ? *e.operands[0] : *e.operands[2]);
      case Kind::lambda:
        return lambda(e);
    }
    return {};
  }

 private:
  Value name(const std::string& wanted) {
    if (const Value* local = find_local(locals_.get(), wanted)) return *local;
    auto value = runtime_.names.look_up(scope_, wanted);
    if (!value) fail_name(wanted, scope_.names());
    return std::move(*value);
  }

  /// The operands from `first` on, with `*iterable` taken apart.
  Values items(const Expression& e, std::size_t first = 0) {
    Values out;
    for (std::size_t i = first; i < e.operands.size(); ++i) {
      const Expression& operand = *e.operands[i];
      if (operand.kind == Kind::starred) {
        for (Value& item : items_of(runtime_, run(*operand.operands[0]))) out.push_back(std::move(item));
      } else {
        out.push_back(run(operand));
      }
    }
    return out;
  }

  Value dict(const Expression& e) {
    auto table = std::make_shared<Table>();
    for (std::size_t i = 0; i + 1 < e.operands.size(); i += 2) {
      Value key = run(*e.operands[i]);
      table->set(runtime_, std::move(key), run(*e.operands[i + 1]));
    }
    return make_dict(std::move(table));
  }

  Value subscripted(const Expression& e) {
    const Value container = run(*e.operands[0]);
    return subscript(runtime_, container, run(*e.operands[1]));
  }

  Value slice(const Expression& e) {
    Values bounds;
    for (const auto& bound : e.operands) bounds.push_back(bound ? run(*bound) : Value());
    return std::make_shared<const Slice>(Slice{std::make_shared<const Values>(std::move(bounds))});
  }

  Value binary(const Expression& e) {
    const Value left = run(*e.operands[0]);
    return operate(runtime_, e.operators[0], left, run(*e.operands[1]));
  }

  Value comparison(const Expression& e) {
    Value left = run(*e.operands[0]);
    for (std::size_t i = 0; i < e.operators.size(); ++i) {
      Value right = run(*e.operands[i + 1]);
      if (!compare(runtime_, e.operators[i], left, right)) return false;
      left = std::move(right);
    }
    return true;
  }

  /// `and` and `or` give the operand that decides.
  Value logical(const Expression& e, bool decisive) {
    for (std::size_t i = 0; i + 1 < e.operands.size(); ++i) {
      Value value = run(*e.operands[i]);
      if (is_true(value) == decisive) return value;
    }
    return run(*e.operands.back());
  }

  Value lambda(const Expression& e) {
    Lambda function{&e, {}, locals_, &scope_};
    for (std::size_t i = 1; i < e.operands.size(); ++i) function.defaults.push_back(run(*e.operands[i]));
    scope_.keep();
    return std::make_shared<const Lambda>(std::move(function));
  }

  Value call(const Expression& e) {
    const Value function = run(*e.operands[0]);
    CallArguments arguments{items(e, 1), {}};
    for (const Keyword& keyword : e.keywords) {
      Value value = run(*keyword.value);
      if (keyword.name.empty()) {
        add_mapping(runtime_, arguments, value);
      } else {
        arguments.named.emplace_back(keyword.name, std::move(value));
      }
    }
    return call_value(runtime_, function, arguments);
  }

  // ---- comprehensions ----

  /// Runs `each` for every combination of items that the clauses of `e` let through.
  template <typename Each>
  void for_each_combination(const Expression& e, Each each) {
    const Value first = run(*e.clauses[0].items);  // outside of the new scope, as in Python
    auto frame = std::make_shared<Locals>();
    frame->outer = locals_;
    locals_.swap(frame);
    const Restore restore{locals_, frame};
    loop(e, 0, first, each);
  }

  template <typename Each>
  void loop(const Expression& e, std::size_t depth, const Value& iterable, Each& each) {
    const Clause& clause = e.clauses[depth];
    for (const Value& item : items_of(runtime_, iterable)) {
      bind(runtime_, *locals_, *clause.target, item);
      const bool wanted = std::all_of(clause.conditions.begin(), clause.conditions.end(),
                                      [&](const ExpressionPtr& condition) { return is_true(run(*condition)); });
      if (!wanted) continue;
      if (depth + 1 < e.clauses.size()) {
        loop(e, depth + 1, run(*e.clauses[depth + 1].items), each);
      } else {
        each();
      }
    }
  }

  Values comprehension(const Expression& e) {
    Values out;
    for_each_combination(e, [&] {
      out.push_back(run(*e.operands[0]));
      if (out.size() > kMaxItems) fail_limit("the list is too long");
    });
    return out;
  }

  Value dict_of(const Expression& e) {
    auto table = std::make_shared<Table>();
    for_each_combination(e, [&] {
      Value key = run(*e.operands[0]);
      table->set(runtime_, std::move(key), run(*e.operands[1]));
    });
    return make_dict(std::move(table));
  }

  Runtime& runtime_;
  Scope& scope_;
  LocalsPtr locals_;
};

/// A function of the library looks at every byte of its operands at most a few times; what takes more, it counts
/// itself.
std::size_t cost_of_operands(const CallArguments& arguments) {
  std::size_t bytes = 0;
  for (const Value& value : arguments.positional) bytes += bytes_of(value);
  for (const auto& named : arguments.named) bytes += bytes_of(named.second);
  return cost_of_bytes(bytes) + arguments.named.size();
}

}  // namespace

Value evaluate(Runtime& runtime, const Expression& expression, Scope& scope) {
  return Evaluator(runtime, scope, nullptr).run(expression);
}

Value call_value(Runtime& runtime, const Value& function, CallArguments& arguments) {
  const Level level(runtime.depth, kMaxEvalDepth, kTooDeep);
  runtime.budget.spend(1);
  if (function.object<const Lambda>() == nullptr) runtime.budget.spend(cost_of_operands(arguments));
  if (const auto* builtin = function.as<const Builtin*>()) {
    const Builtin& called = **builtin;
    if (!called.deprecated_for.empty()) runtime.services.deprecated(called.name, called.deprecated_for);
    return called.call(runtime, Parameters(arguments, called.name, called.takes));
  }
  if (const auto* method = function.object<const BoundMethod>()) {
    runtime.budget.spend(cost_of_bytes(bytes_of(*method->self)));
    const Method& called = *method->method;
    return called.call(runtime, *method->self, Parameters(arguments, called.name, called.takes));
  }
  if (const auto* type = function.as<Type>()) return construct(runtime, *type, arguments);
  if (const auto* lambda = function.object<const Lambda>()) {
    return Evaluator(runtime, *lambda->scope, bind_parameters(*lambda, arguments)).run(*lambda->code->operands[0]);
  }
  fail_eval(fmt::format("'{}' object is not callable", type_name(function)));
}

}  // namespace finemote::gen::expression
