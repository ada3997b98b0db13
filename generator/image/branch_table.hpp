// The targets of a jump through a table: TBB, TBH, and `ldr pc` from a table of addresses.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "generator/image/body.hpp"
#include "generator/image/successors.hpp"

namespace finemote::gen {

/// By what the compiler writes before: `cmp r3, #5; bhi ...; tbb [pc, r3]`. The comparison counts only where every way
/// to the table passes its unsigned branch, and nothing in between changes the index. None where that is not so, where
/// the table's place is not constant, and where a target lies outside the function. Others may come to `entry`.
std::optional<std::vector<std::uint32_t>> table_targets(const Image& image, const FunctionBody& body,
                                                        const Instruction& table, const Successors& known,
                                                        std::uint32_t entry);

}  // namespace finemote::gen
