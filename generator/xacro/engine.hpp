// The expression engine as documents use it: all they include of generator/expression, and the names they take from it.
#pragma once

#include "generator/expression/cost.hpp"
#include "generator/expression/evaluate.hpp"
#include "generator/expression/expression.hpp"
#include "generator/expression/failure.hpp"
#include "generator/expression/library.hpp"
#include "generator/expression/literal.hpp"
#include "generator/expression/print.hpp"
#include "generator/expression/runtime.hpp"
#include "generator/expression/scope.hpp"
#include "generator/expression/token.hpp"

namespace finemote::gen::xacro {

using expression::Budget;
using expression::Expression;
using expression::fail;
using expression::fail_eval;
using expression::fail_limit;
using expression::Failure;
using expression::Level;
using expression::MessageKind;
using expression::NamespaceRef;
using expression::Property;
using expression::Runtime;
using expression::Scope;
using expression::Value;

}  // namespace finemote::gen::xacro
