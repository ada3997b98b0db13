// What FineMote's firmware keeps in memory for those who look from outside, and where.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <vector>

#include "emulator/board.hpp"

namespace finemote::emulator {

/// Brackets from here on are the runtime's own work, those below it stages: runtime/include/finemote/mark.hpp.
inline constexpr unsigned kFirstWork = 0x20000;

/// Overruns the firmware counted since its last start, by bucket, as its BucketStates keep them.
/// @throws std::runtime_error  a firmware with a schedule whose states are not found
std::vector<std::uint32_t> overruns_of(Board& board, const Image& image);

/// The faults the firmware counted since its last start, as runtime/src/faults.cpp keeps them: `[module, number,
/// count]`.
nlohmann::ordered_json faults_of(Board& board, const Image& image);

/// The monitor's records, as finemote/monitor.hpp lays them out; none in an image without them.
nlohmann::ordered_json monitor_of(Board& board, const Image& image);

}  // namespace finemote::emulator
