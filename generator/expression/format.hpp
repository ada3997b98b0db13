// Values into texts by a pattern: '%.3f' % x, '{:>8}'.format(x), format(x, '.2f').
#pragma once

#include <string>
#include <string_view>

#include "generator/expression/value.hpp"

namespace finemote::gen::expression {

class Runtime;

/// `pattern % arguments`: a tuple is several arguments, a dict is for %(name)s, all else is one.
Value format_percent(Runtime& runtime, const std::string& pattern, const Value& arguments);

/// `pattern.format(...)`.
std::string format_braces(Runtime& runtime, const std::string& pattern, const CallArguments& arguments);

/// One value by the text after the colon of a replacement field:
/// `[[fill]align][sign][#][0][width][,][.precision][type]`.
std::string format_value(Runtime& runtime, const Value& value, std::string_view specification);

}  // namespace finemote::gen::expression
