// How long frames of parts wait for a bus that arbitrates: what the firmware can date them by.
#pragma once

#include "generator/timing/transfers.hpp"

namespace finemote::gen::timing {

/// Whether the frames of this transfer come from the part to us where frames arbitrate.
bool is_arbitrated_answer(const Model& model, const Transfer& transfer);

/// Of every device: a time that no frame takes from when its part has it for us until its last bit is on a bus that
/// arbitrates. It is never below the bound of that time, and does not change with execution times: the longest that
/// frames would take if every job ended just by its deadline, or, where that has no bound, their interval. None where
/// the true time has no bound, the firmware could not hold it, or the device receives nothing so. By the board's clock.
/// Throws Overflow.
Table<Rank, std::optional<Duration>> frame_waits(const Model& model, const TransferBounds& transfers, Effort& effort);

}  // namespace finemote::gen::timing
