// Two ways to contradict a table of costs: the documents it was made from, and the core of the emulated board.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "generator/wcet/cost_table.hpp"

namespace finemote::test {

/// An instruction by its halfwords; the second is ignored where it has one.
struct Encoding {
  std::uint16_t first = 0, second = 0;
};

/// Each with what the static side decodes, and its longest time by a table.
struct Decoded {
  Encoding code;
  gen::Instruction instruction;
};

/// All halfwords that are an instruction, and a grid of pairs, that the static side knows. Instructions in IT blocks
/// are not among them.
std::vector<Decoded> decoded_grid();

/// Those of documents.hpp.
std::vector<Decoded> documented_instructions();

/// Where it differs from documents.hpp; empty: nowhere, and every row of it is held.
std::vector<std::string> differences_from_documents(const gen::wcet::CostTable& table);

/// Where the core takes longer than the table says: an instruction, or two in sequence.
struct Excess {
  std::size_t compared = 0;
  std::vector<std::string> found;  ///< at most ten in words
  std::size_t count = 0;
};
Excess excess_over(const gen::wcet::CostTable& table, const std::vector<Decoded>& grid);

}  // namespace finemote::test
