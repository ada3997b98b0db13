// A job to what it takes around its stages.
#pragma once

#include <cstdint>
#include <set>
#include <vector>

#include "generator/wcet/marks.hpp"
#include "generator/wcet/unrolled.hpp"

namespace finemote::gen::wcet {

/// From the entry or the end of a stage to the next begin.
struct Gap {
  std::set<std::uint32_t> begun;  ///< marks of the stages that begin there; more than one where stages are empty
  Cycles cycles = 0;              ///< at most
};

struct Gaps {
  std::vector<Gap> before;  ///< by place
  Cycles rest = 0;          ///< from the last stage's end to the routine's: at most
};

/// Of the stages whose marks, of even number, are below `first_other`.
Gaps gaps_between(const UnrolledGraph& graph, const Marks& marks, std::uint32_t first_other);

}  // namespace finemote::gen::wcet
