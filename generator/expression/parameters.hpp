// The arguments of a library call, put to the parameters they are for.
#pragma once

#include <initializer_list>
#include <string_view>
#include <vector>

#include "generator/expression/value.hpp"

namespace finemote::gen::expression {

class Parameters {
 public:
  /// @param names     the parameters in order; the first `required` ones must be given
  /// Fails with Python's words on too many, missing and unknown arguments.
  Parameters(CallArguments& arguments, std::string_view function, std::initializer_list<std::string_view> names,
             std::size_t required);

  /// The argument for a parameter, or null.
  const Value* operator[](std::size_t i) const { return given_[i]; }
  [[nodiscard]] const Value& at(std::size_t i) const { return *given_[i]; }

  /// The argument as a text; fails for another type.
  [[nodiscard]] const std::string& text(std::size_t i) const;
  /// The argument as a machine integer; `otherwise` when it is missing or None.
  [[nodiscard]] std::int64_t integer(std::size_t i, std::int64_t otherwise) const;

 private:
  std::string_view function_;
  std::vector<const Value*> given_;
};

/// Fails unless a call has no keyword arguments.
void check_no_keywords(const CallArguments& arguments, std::string_view function);

}  // namespace finemote::gen::expression
