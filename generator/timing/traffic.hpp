// What devices send and receive, to transfers of the timing model and budgets of the interrupts they cause.
#pragma once

#include "generator/timing/bus_use.hpp"
#include "generator/timing/connection.hpp"
#include "generator/timing/robot_buses.hpp"
#include "generator/timing/wire_use.hpp"

namespace finemote::gen::timing {

/// Adds the traffic of one device or flush after the other to a model whose buses are complete.
class Traffic {
 public:
  /// Everything must outlive this.
  Traffic(const Robot& robot, const BusPlaces& places, const Table<BusId, BusUse>& uses, Model& model);

  /// Transfers of a device that has a type, over its own bus and those of its uses, and interrupts of lines of its own.
  /// Frames of stage `flush` are left to the flush of its bucket.
  /// @param place  of the device in Model::devices
  void add_device(const gen::Device& device, Rank place);

  /// Allows `count` interrupts in one of any `every` periods of the device. Adds nothing on a bus whose parts send by
  /// themselves: there, not every interrupt belongs to a transfer the robot asked for.
  void add_budget(BusPlace bus, Rank place, std::int64_t count, std::int64_t every = 1);

  /// What goes ahead of a unit on a segment: a mux is set, and where there are several, the one set before is switched
  /// off first.
  void add_selection(SegmentId segment, const WireRate& rate, WireUse& use) const;

 private:
  void add_frames(const gen::Device& device, const Connection& connection, Rank place);
  void add_transfer(Rank place, BusPlace bus, FrameStage stage, const WireUse& use);
  void add_own_lines(const gen::Device& device);
  [[nodiscard]] bool counts_transfers(BusPlace bus) const;

  const Robot& robot_;
  const BusPlaces& places_;
  const Table<BusId, BusUse>& uses_;
  Model& model_;
  const Table<BusPlace, std::size_t> driver_sources_;  ///< how many each bus has; lines of devices come after them
};

}  // namespace finemote::gen::timing
