#include "generator/expression/parameters.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/expression/failure.hpp"

namespace finemote::gen::expression {

Parameters::Parameters(CallArguments& arguments, std::string_view function,
                       std::initializer_list<std::string_view> names, std::size_t required)
    : function_(function), given_(names.size(), nullptr) {
  if (arguments.positional.size() > names.size()) {
    fail_eval(fmt::format("{}() takes at most {} argument{} ({} given)", function, names.size(),
                          names.size() == 1 ? "" : "s", arguments.positional.size()));
  }
  for (std::size_t i = 0; i < arguments.positional.size(); ++i) given_[i] = &arguments.positional[i];
  for (const auto& [name, value] : arguments.named) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) fail_eval(fmt::format("{}() got an unexpected keyword argument '{}'", function, name));
    const auto place = static_cast<std::size_t>(found - names.begin());
    if (given_[place] != nullptr) fail_eval(fmt::format("{}() got multiple values for argument '{}'", function, name));
    given_[place] = &value;
  }
  for (std::size_t i = 0; i < required; ++i) {
    if (given_[i] == nullptr) {
      fail_eval(fmt::format("{}() missing required argument '{}' (pos {})", function, *(names.begin() + i), i + 1));
    }
  }
}

const std::string& Parameters::text(std::size_t i) const {
  const auto* text = given_[i]->text();
  if (text == nullptr) {
    fail_eval(fmt::format("{}() argument {} must be str, not {}", function_, i + 1, type_name(*given_[i])));
  }
  return *text;
}

std::int64_t Parameters::integer(std::size_t i, std::int64_t otherwise) const {
  if (given_[i] == nullptr || given_[i]->is_none()) return otherwise;
  const auto value = as_integer(*given_[i]);
  if (!value) fail_eval(fmt::format("'{}' object cannot be interpreted as an integer", type_name(*given_[i])));
  constexpr std::int64_t far = std::int64_t{1} << 60;
  if (!value->is_small()) return value->is_negative() ? -far : far;
  return std::clamp(value->small(), -far, far);
}

void check_no_keywords(const CallArguments& arguments, std::string_view function) {
  if (!arguments.named.empty()) fail_eval(fmt::format("{}() takes no keyword arguments", function));
}

}  // namespace finemote::gen::expression
