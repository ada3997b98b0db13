// Params to a `Config` whose members are assigned by name: what a constructor gets as its `const Config&`.
#pragma once

#include <string>
#include <vector>

#include "generator/emit/template.hpp"
#include "generator/model/robot.hpp"

namespace finemote::gen {

/// Sets what templates/config.mustache names: a constant expression that assigns the members of `<cpp_class>::Config`
/// by name.
///
/// The params of a shipped class that have their default are left out: tests hold `Config{}` to the descriptors.
/// Those of a user's class are all assigned, a line each, and by an expression that compiles for the param's type only:
/// what the compiler says of a missing or changed member stands at the line that names it.
void set_config(const std::string& cpp_class, const std::vector<Param>& params, bool is_shipped, Data& data);

}  // namespace finemote::gen
