// The trap: the child is only declared here and defined in one source file, the parent is inline. An inline variable is
// not sequenced after a child it cannot see the definition of, so the parent may be constructed first.
#pragma once

#include "part.hpp"

namespace order {

extern finemote::Ordered<Part> motor;
inline finemote::Ordered<Part> arm{motor};

}  // namespace order
