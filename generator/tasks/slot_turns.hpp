// Slots take one transfer at a time: how many a device has for each in a job.
#pragma once

#include <cstdint>

#include "generator/model/connection.hpp"

namespace finemote::gen::timing {

/// Units that go over a slot in each job. Between update() and handle() of one job nothing lets the first one end, nor
/// within a stage: with more than one, all but one have to leave out their turn, in any order.
struct SlotTurns {
  std::int64_t update = 0, handle = 0;  ///< begun by these stages
  bool brings = false;                  ///< something comes back with one of them

  [[nodiscard]] std::int64_t all() const { return update + handle; }
};

/// None where the connection has no slot, or where each unit may have one: frames of a second chip select on the own
/// bus may be declared with those of the first.
SlotTurns slot_turns(const Robot& robot, const gen::Device& device, const Connection& connection);

}  // namespace finemote::gen::timing
