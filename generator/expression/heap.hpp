// How much memory the process has taken from its heap.
#pragma once

#include <cstddef>

namespace finemote::gen::expression {

/// Bytes in use at the moment; 0 where the C library does not tell.
std::size_t heap_in_use();

}  // namespace finemote::gen::expression
