// Why an expression, and with it the document it is in, cannot go on: thrown where it is found, reported once.
//
// The first mistake ends an expansion, as in ROS xacro: what follows depends on it. An exception keeps the interpreter
// readable; it never leaves the two modules.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/diagnostic/suggest.hpp"

namespace finemote::gen::expression {

struct Failure {
  Code code;
  std::string message;
  Position at = {};  ///< the innermost text that is to blame, once somebody who knows it has seen the failure
  std::vector<Note> notes = {};
  std::vector<std::string> hints = {};
};

/// Throws; the message is in the words of ROS xacro (that is, of Python) where that has words for it.
[[noreturn]] inline void fail(Code code, std::string message) { throw Failure{code, std::move(message)}; }

/// A mistake inside an expression.
[[noreturn]] inline void fail_eval(std::string message) { fail(code::xacro_expression, std::move(message)); }

/// A name an expression uses is not there; `visible` are those that are.
[[noreturn]] inline void fail_name(const std::string& name, const std::vector<std::string>& visible) {
  throw Failure{code::xacro_expression, "name '" + name + "' is not defined", {}, {}, near_hint(name, visible)};
}

/// A limit of this tool was reached.
[[noreturn]] inline void fail_limit(std::string message) { fail(code::xacro_limit, std::move(message)); }

}  // namespace finemote::gen::expression
