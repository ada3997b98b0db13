#include "generator/expression/parameters.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/expression/failure.hpp"

namespace finemote::gen::expression {

Parameters::Parameters(CallArguments& arguments, std::string_view function, const Signature& signature)
    : arguments_(arguments), function_(signature.shown.empty() ? function : signature.shown) {
  if (signature.kind == Signature::Kind::named) bind(signature);
  if (signature.kind == Signature::Kind::positional) check_positional(signature);
}

void Parameters::check_positional(const Signature& signature) const {
  check_no_keywords(arguments_, function_);
  const std::size_t given = positional().size();
  if (given >= signature.least && given <= signature.most) return;
  const bool is_short = given < signature.least;
  const std::size_t bound = is_short ? signature.least : signature.most;
  fail_eval(fmt::format("{} expected at {} {} argument{}, got {}", function_, is_short ? "least" : "most", bound,
                        bound == 1 ? "" : "s", given));
}

void Parameters::bind(const Signature& signature) {
  const std::size_t most = signature.most;
  const auto begin = signature.names.begin();
  const auto end = begin + static_cast<std::ptrdiff_t>(most);
  if (positional().size() > most) {
    fail_eval(fmt::format("{}() takes at most {} argument{} ({} given)", function_, most, most == 1 ? "" : "s",
                          positional().size()));
  }
  for (std::size_t i = 0; i < positional().size(); ++i) given_[i] = &positional()[i];
  for (const auto& [name, value] : arguments_.named) {
    const auto found = std::find(begin, end, name);
    if (found == end) fail_eval(fmt::format("{}() got an unexpected keyword argument '{}'", function_, name));
    const Value*& place = given_[static_cast<std::size_t>(found - begin)];
    if (place != nullptr) fail_eval(fmt::format("{}() got multiple values for argument '{}'", function_, name));
    place = &value;
  }
  for (std::size_t i = 0; i < signature.least; ++i) {
    if (given_[i] != nullptr) continue;
    fail_eval(fmt::format("{}() missing required argument '{}' (pos {})", function_, signature.names[i], i + 1));
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
