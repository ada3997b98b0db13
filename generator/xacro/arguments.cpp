#include "generator/xacro/arguments.hpp"

#include <fmt/format.h>

#include <vector>

#include "generator/diagnostic/suggest.hpp"

namespace finemote::gen::xacro {

const std::string* ArgumentTable::ask(const std::string& name) {
  asked_.insert(name);
  const auto found = values_.find(name);
  return found != values_.end() ? &found->second : nullptr;
}

const Arguments& ArgumentTable::ask_for(const std::string& expression) {
  for (const auto& [name, value] : values_) {
    if (expression.find(name) != std::string::npos) asked_.insert(name);
  }
  return values_;
}

void ArgumentTable::warn_of_unknown(const SourceFile& entry, Warnings& warnings) const {
  const std::vector<std::string> known(asked_.begin(), asked_.end());
  for (const auto& [name, value] : given_) {
    if (asked_.contains(name)) continue;
    Diagnostic* warning =
        warnings.add(code::xacro_unknown_argument, {&entry},
                     fmt::format("argument '{}:={}' has no effect: no <xacro:arg> declares '{}'", name, value, name));
    if (warning == nullptr) continue;
    warning->hint(known.empty() ? "the file takes no arguments" : did_you_mean(name, known));
  }
}

}  // namespace finemote::gen::xacro
