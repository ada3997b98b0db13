#include "generator/tasks/slot_turns.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "generator/bus/bus_type.hpp"

namespace finemote::gen::timing {
namespace {

/// With what is declared for a connection: its own slot, and those on the same bus for which nothing is declared.
std::int64_t slots_of(const Robot& robot, const gen::Device& device, const Connection& connection) {
  const BusId bus = robot.segments[connection.segment].bus;
  return 1 + std::count_if(device.uses.begin(), device.uses.end(), [&](const Use& use) {
           return &use != connection.use && use.segment && robot.segments[*use.segment].bus == bus &&
                  frames_over(device, {*use.segment, &use}).empty();
         });
}

}  // namespace

SlotTurns slot_turns(const Robot& robot, const gen::Device& device, const Connection& connection) {
  SlotTurns turns;
  const BusType& type = bus_type(robot.segments[connection.segment].bus_kind);
  if (type.unit == nullptr) return turns;
  std::set<std::pair<FrameStage, int>> units;  // begun already, by number
  for (const Frame& frame : frames_over(device, connection)) {
    const bool is_asked = frame.stage == FrameStage::update || frame.stage == FrameStage::handle;
    if (!is_asked) continue;
    turns.brings = turns.brings || frame.read_bytes > 0 || type.kind == BusKind::spi;  // both ways at once
    const bool is_reply = !type.is_mastered && frame.write_bytes == 0;
    const bool is_begun = frame.unit > 0 && !units.insert({frame.stage, frame.unit}).second;
    if (!is_reply && !is_begun) ++(frame.stage == FrameStage::update ? turns.update : turns.handle);
  }
  return turns.all() > slots_of(robot, device, connection) ? turns : SlotTurns{};
}

}  // namespace finemote::gen::timing
