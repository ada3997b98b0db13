// Which marks bound a loop of an image.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "generator/image/flow_graph.hpp"
#include "generator/wcet/loop_nest.hpp"
#include "generator/wcet/marks.hpp"

namespace finemote::gen::wcet {

/// How many iterations of a loop are followed, one by one.
inline constexpr std::uint64_t kMostRounds = 10'000;

/// A mark says how often, or for how long, it is passed once its begin mark has been. So it bounds a loop that contains
/// the mark but not its begin mark. Compilers leave out loops and make one of two; where its mark has come to lie in
/// another loop, its begin mark lies there, too. Each of them has an instruction of its own, so that it is known on
/// which side of a loop's entry it lies.
bool is_of_loop_around(const LoopNest& nest, std::uint32_t mark, const Marks& marks);

/// It is, and every iteration passes it: otherwise nothing says which iterations are the long ones.
bool ends_loop_around(const LoopNest& nest, std::uint32_t mark, const Marks& marks);

/// How often a mark may be passed in its loop beyond what it says: without an instruction of its own it may lie before
/// a test that leads out.
std::uint32_t passes_besides(const Loop& loop, std::uint32_t mark, const Marks& marks);

/// Of a loop that no mark ends and the code does not: why none does.
/// @param index  of a loop of `nest`
std::string why_endless(const LoopNest& nest, std::size_t index, const Marks& marks);

/// The marks that say how long a loop waits: in it itself, not in those in it. None: it is no wait.
std::vector<std::uint32_t> waits_of(const LoopNest& nest, std::size_t index, const Marks& marks);

}  // namespace finemote::gen::wcet
