// The pages docs/diagnostics/FMnnnn.md as a list: what `finemote explain` prints.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/diagnostic/code.hpp"

namespace finemote::gen {

struct CatalogueEntry {
  Code code;
  std::string title;  ///< of the page, without the number
};

/// `FM3012`, `fm3012` or `3012` as a code; none for anything else.
std::optional<Code> parse_code(std::string_view text);

/// All pages below `data_dir`, by number; empty when there are none.
std::vector<CatalogueEntry> list_catalogue(const std::string& data_dir);

/// The page of a code, as Markdown; none when there is no such page.
std::optional<std::string> explain(const std::string& data_dir, Code code);

}  // namespace finemote::gen
