#include "generator/cli/named_board.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/diagnostic/suggest.hpp"

namespace finemote::gen {

const Board* named_board(const std::string& name, Library& library, Sources& sources, Diagnostics& diagnostics) {
  const std::vector<std::string> known = board_names(library);
  if (std::find(known.begin(), known.end(), name) != known.end())
    return find_board(library, name, sources, diagnostics);
  suggest(diagnostics.error(code::unknown_board, {}, fmt::format("there is no board '{}'", name)), name, known);
  return nullptr;
}

}  // namespace finemote::gen
