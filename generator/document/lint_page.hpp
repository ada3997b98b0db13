// The rules of lint to the made part of their reference page.
#pragma once

#include <string>

namespace finemote::gen {

/// One row for each code, as Markdown.
std::string lint_page();

}  // namespace finemote::gen
