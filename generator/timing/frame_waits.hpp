// How long frames of parts wait for a bus that arbitrates: what the firmware can date them by.
#pragma once

#include "generator/timing/transfers.hpp"

namespace finemote::gen::timing {

/// Whether the frames of this transfer come from the part to us where frames arbitrate.
bool is_arbitrated_answer(const Model& model, const Transfer& transfer);

/// Of every device: a time that no frame takes from when its part has it for us until its last bit is on a bus that
/// arbitrates. None where that has no bound, or the device receives nothing so. What the execution times are has no
/// influence but whether there is a bound: where there is one, the longest that frames take while every job ends by its
/// deadline, or, where that may be any time, their interval. By the board's clock. Throws Overflow.
Table<Rank, std::optional<Duration>> frame_waits(const Model& model, const TransferBounds& transfers, Effort& effort);

}  // namespace finemote::gen::timing
