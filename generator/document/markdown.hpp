// Pieces of Markdown that several reference pages share.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/units/duration.hpp"

namespace finemote::gen {

/// A table row: `| a | b |` and a line end.
std::string row(const std::vector<std::string>& cells);

/// Header row and rule.
std::string table(const std::vector<std::string>& titles);

/// Words with `separator` between them; `none` for an empty list.
std::string joined(const std::vector<std::string>& words, const std::string& separator = ", ",
                   const std::string& none = "none");

/// `950 us`, `1 s`: in the largest unit that divides it; `0 ns`.
std::string time_text(Duration time);

/// The first letter large, a full stop at the end.
std::string sentence(std::string text);

/// All of `made` between the marks.
std::string as_made(const std::string& made);

/// Whether a page has the marks.
bool has_made_part(const std::string& page);

/// `page` with what stands between the marks replaced by `made`; the marks stay. A page without marks, or none, becomes
/// the title, the marks and `made`.
std::string with_made_part(const std::optional<std::string>& page, const std::string& title, const std::string& made);

}  // namespace finemote::gen
