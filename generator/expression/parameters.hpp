// The arguments of a library call, checked against the signature of the function and put to its parameters.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "generator/expression/function.hpp"
#include "generator/expression/value.hpp"

namespace finemote::gen::expression {

class Parameters {
 public:
  /// Fails with Python's words on too many, missing and unknown arguments. Keeps a reference to `arguments`.
  Parameters(CallArguments& arguments, std::string_view function, const Signature& signature);

  /// The argument for a named parameter, or null.
  const Value* operator[](std::size_t i) const { return given_[i]; }
  [[nodiscard]] const Value& at(std::size_t i) const { return *given_[i]; }

  /// The argument as a text; fails for another type.
  [[nodiscard]] const std::string& text(std::size_t i) const;
  /// The argument as a machine integer; `otherwise` when it is missing or None.
  [[nodiscard]] std::int64_t integer(std::size_t i, std::int64_t otherwise) const;

  /// The arguments as they were given, for functions without named parameters.
  [[nodiscard]] CallArguments& all() const { return arguments_; }
  [[nodiscard]] const Values& positional() const { return arguments_.positional; }

  /// The name of the function in messages.
  [[nodiscard]] std::string_view function() const { return function_; }

 private:
  void check_positional(const Signature& signature) const;
  void bind(const Signature& signature);

  CallArguments& arguments_;
  std::string_view function_;
  std::array<const Value*, Signature::kMostNames> given_ = {};
};

/// Fails unless a call has no keyword arguments.
void check_no_keywords(const CallArguments& arguments, std::string_view function);

}  // namespace finemote::gen::expression
