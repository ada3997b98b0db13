// Params to a `Config` whose members are assigned by name: what a constructor gets as its `const Config&`.
#pragma once

#include <string>
#include <vector>

#include "generator/model/robot.hpp"

namespace finemote::gen {

/// A value as C++ of exactly the type that a Config member for the param has (docs/howto/add-a-device.md): `1024`,
/// `20 * finemote::kMillisecond`, `0.25f`, `my::Mode::kFast`.
std::string value_expression(const ParamSpec& spec, const ParamValue& value);

/// `finemote::PwmEsc::Config{}`, or `[] { finemote::PwmEsc::Config c{}; c.reverse = true; return c; }()`: a constant
/// expression that assigns members by name.
///
/// The params of a shipped class that have their default are left out: tests hold `Config{}` to the descriptors.
/// Those of a user's class are all assigned, a line each, and by an expression that compiles for the param's type only:
/// what the compiler says of a missing or changed member stands at the line that names it.
/// Lines after the first are indented for a constructor argument.
std::string config_expression(const std::string& cpp_class, const std::vector<Param>& params, bool is_shipped);

}  // namespace finemote::gen
