// How often a walk passes the marks of loops.
#pragma once

#include <cstdint>

#include "generator/wcet/frame.hpp"
#include "generator/wcet/marks.hpp"

namespace finemote::gen::wcet {

/// The block has a mark of the loop around it, and iterations of its loop can bypass it, so it does not bound the
/// number of iterations, nor tell which of them pass it.
bool is_passed_by_some(const Frame& frame, std::uint32_t block, const Marks& marks);

/// Passes a block. False where its mark says that it is not passed again.
bool pass_mark(Frame& frame, std::uint32_t block, const Marks& marks);

}  // namespace finemote::gen::wcet
