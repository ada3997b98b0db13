// The C++ class and header a descriptor names: what the pattern of its schema cannot see.
#pragma once

#include <string>

#include "generator/descriptor/contradictions.hpp"

namespace finemote::gen {

/// Reports a qualified name of which a part cannot be a name in C++, at `class`; an empty one is none.
void check_class(const std::string& qualified, const Contradictions& found);

/// Reports a header that is included by the name of a generated one or of one of the C library, at `header`: the
/// compiler would take the one for the other.
void check_include(const std::string& include, const Contradictions& found);

}  // namespace finemote::gen
