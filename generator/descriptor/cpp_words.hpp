// What cannot be a name in C++.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace finemote::gen {

/// Why a C++ name cannot be used at all: keyword, alternative token, `main`, `__`, leading `_X`, a macro, empty.
std::optional<std::string> invalid_name(std::string_view cpp);

}  // namespace finemote::gen
