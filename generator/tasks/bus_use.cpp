#include "generator/tasks/bus_use.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "generator/bus/bus_type.hpp"
#include "generator/model/shared_frame.hpp"

namespace finemote::gen::timing {
namespace {

/// A device that has frames nowhere may send anything. A second chip select on the own bus: its frames may be declared
/// with those of the first.
bool says_what_it_sends(const Robot& robot, const gen::Device& device, const Connection& connection) {
  if (!frames_over(device, connection).empty()) return true;
  if (connection.use == nullptr) return device.type->frames.has_value();
  return device.segment && robot.segments[*device.segment].bus == robot.segments[connection.segment].bus;
}

/// A part that sends by itself says how often.
bool says_how_often(const gen::Device& device, const Connection& connection) {
  const std::vector<Frame> frames = frames_over(device, connection);
  return std::all_of(frames.begin(), frames.end(), [&](const Frame& frame) {
    return frame.stage != FrameStage::autonomous || device.type->says_interval_of(frame);
  });
}

bool writes(const gen::Device& device, const Connection& connection) {
  const std::vector<Frame> frames = frames_over(device, connection);
  return std::any_of(frames.begin(), frames.end(),
                     [](const Frame& frame) { return frame.write_bytes > 0 && frame.stage != FrameStage::autonomous; });
}

void lower_to(std::int64_t bits, std::int64_t& least) { least = least == 0 ? bits : std::min(least, bits); }

/// Lowers the bits of the shortest frames to those of a connection. What is written and read is a frame that asks and
/// one that answers.
void note_lengths(const gen::Device& device, const Connection& connection, const BusType& type, BusUse& use) {
  if (type.least_bits == nullptr) return;
  for (const Frame& frame : frames_over(device, connection)) {
    const bool is_autonomous = frame.stage == FrameStage::autonomous;
    if (!is_autonomous) lower_to(type.least_bits(frame.write_bytes), use.least_sent);
    if (is_autonomous || frame.read_bytes > 0) lower_to(type.least_bits(frame.read_bytes), use.least_received);
  }
}

/// The most shared frames on a bus that devices of one period fill; at least one.
std::size_t shared_frames(const Robot& robot, BusId bus) {
  std::map<Duration, std::set<std::uint32_t>> frames;
  for (const gen::Device& device : robot.devices) {
    if (!device.segment || robot.segments[*device.segment].bus != bus) continue;
    if (const auto frame = shared_frame_of(device)) frames[device.period].insert(frame->identifier);
  }
  std::size_t most = 1;
  for (const auto& [period, identifiers] : frames) most = std::max(most, identifiers.size());
  return most;
}

}  // namespace

bool is_declared(const Robot& robot, const gen::Device& device, const Connection& connection) {
  return says_what_it_sends(robot, device, connection) && says_how_often(device, connection);
}

Table<BusId, BusUse> bus_uses(const Robot& robot) {
  Table<BusId, BusUse> uses(robot.buses.size());
  for (const gen::Device& device : robot.devices) {
    for (const Connection& connection : connections_of(device)) {
      BusUse& use = uses[robot.segments[connection.segment].bus];
      use.is_used = true;
      const std::size_t received = device.type == nullptr ? 0 : device.type->receives.size();
      use.slots += static_cast<std::int64_t>(std::max<std::size_t>(received, 1));
      if (connection.use != nullptr) use.transmits = true;
      if (device.type == nullptr) continue;
      if (!is_declared(robot, device, connection)) use.is_declared = false;
      if (writes(device, connection)) use.transmits = true;
      note_lengths(device, connection, bus_type(robot.buses[robot.segments[connection.segment].bus].kind), use);
    }
  }
  for (const Expander& expander : robot.expanders) {
    BusUse& use = uses[robot.segments[expander.segment].bus];
    use.is_used = true;
    ++use.slots;
  }
  for (const BusId bus : robot.buses.ids()) uses[bus].shared_frames = shared_frames(robot, bus);
  return uses;
}

}  // namespace finemote::gen::timing
