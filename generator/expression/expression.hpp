// One parsed expression: a tree that is built once per text and evaluated many times.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "generator/expression/value.hpp"

namespace finemote::gen::expression {

struct Expression;
using ExpressionPtr = std::unique_ptr<Expression>;

enum class Operator {
  add,
  subtract,
  multiply,
  divide,
  floor_divide,
  modulo,
  power,
  matrix_multiply,
  shift_left,
  shift_right,
  bit_and,
  bit_or,
  bit_xor,
  negate,
  plus,
  invert,
  logical_not,
  less,
  less_equal,
  greater,
  greater_equal,
  equal,
  not_equal,
  in,
  not_in,
  is,
  is_not
};

/// `for target in items if condition ...`
struct Clause {
  ExpressionPtr target;  ///< a name, or a tuple or list of targets
  ExpressionPtr items;
  std::vector<ExpressionPtr> conditions;
};

struct Keyword {
  std::string name;  ///< empty for `**value`
  ExpressionPtr value;
};

struct Expression {
  enum class Kind {
    constant,     // value
    name,         // name
    list,         // operands
    tuple,        // operands
    set,          // operands
    dict,         // operands: key, value, key, value ...
    list_of,      // operands[0] for clauses
    set_of,       // operands[0] for clauses
    dict_of,      // operands[0]: operands[1] for clauses
    generator,    // operands[0] for clauses
    attribute,    // operands[0].name
    subscript,    // operands[0][operands[1]]
    slice,        // operands[0..2], null where left out
    call,         // operands[0](operands[1..], keywords)
    starred,      // *operands[0], an argument or item
    unary,        // operators[0] operands[0]
    binary,       // operands[0] operators[0] operands[1]
    comparison,   // operands[0] operators[0] operands[1] operators[1] operands[2] ...
    logical_and,  // operands
    logical_or,   // operands
    conditional,  // operands[0] if operands[1] else operands[2]
    lambda,       // parameters: operands[0]; defaults in operands[1..]
  };
  Kind kind = Kind::constant;
  Value value;
  std::string name;
  std::vector<ExpressionPtr> operands;
  std::vector<Operator> operators;
  std::vector<Clause> clauses;
  std::vector<Keyword> keywords;
  std::vector<std::string> parameters;
};

/// Parses Python's expressions without assignment, `await`, f-strings, bytes and complex numbers. White space around it
/// does not count.
/// Fails with Python's words: "invalid syntax (<expression>, line 1)", or "Use of invalid name(s):  __x" where a name
/// begins with two underscores.
ExpressionPtr parse_expression(std::string_view source);

}  // namespace finemote::gen::expression
