// Continues after a call that cannot be followed: only to find what else has no bound, never for a bound.
#pragma once

#include "generator/wcet/machine.hpp"

namespace finemote::gen::wcet {

/// From the call to the instruction after it, as if what is called kept to the procedure call standard and left the
/// stack of its callers alone: AAPCS32 (IHI 0042) 6.1.1.
Machine presumed_return(Machine machine);

}  // namespace finemote::gen::wcet
