// The pages FMnnnn.md of the diagnostics as a list, as `finemote explain` prints it.
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

/// All pages in `folder`, by number; empty when there are none.
std::vector<CatalogueEntry> list_catalogue(const std::string& folder);

/// `the board has no such port`, of a page that starts `# FM3012: the board has no such port`.
std::string title_of(const std::string& page);

}  // namespace finemote::gen
