// Buses of a robot to those of the timing model: rates, interrupt sources of their drivers, and what hints can offer.
#pragma once

#include "generator/bus/bus_type.hpp"
#include "generator/model/robot.hpp"
#include "generator/tasks/bus_use.hpp"
#include "generator/timing/model.hpp"

namespace finemote::gen::timing {

/// Which buses of a robot the model has: those with a rate, in document order. The others make pulses or switch pins,
/// without frames and interrupts.
class BusPlaces {
 public:
  /// The robot must outlive this.
  explicit BusPlaces(const Robot& robot);

  /// Places in Model::buses of a bus, and of the bus under a segment.
  [[nodiscard]] std::optional<BusPlace> of(BusId bus) const { return places_[bus]; }
  [[nodiscard]] std::optional<BusPlace> of(SegmentId segment) const { return of(robot_.segments[segment].bus); }

  /// The robot's buses that the model has, by place.
  [[nodiscard]] const Table<BusPlace, BusId>& buses() const { return buses_; }

 private:
  const Robot& robot_;
  Table<BusId, std::optional<BusPlace>> places_;
  Table<BusPlace, BusId> buses_;
};

/// Frames that wait in the bus's controller and go by identifier; 0: the board does not say.
std::size_t mailboxes_of(const Robot& robot, BusId bus);

/// What moves the bytes of a bus.
Mover mover_of(const Robot& robot, BusId bus);

/// Buses, and what the sources of their drivers count.
struct DriverBuses {
  Table<BusPlace, Bus> buses;
  Table<BusPlace, std::vector<DriverSource::Counts>> counts;  ///< of the first sources of each bus, in their order
};

/// Without budgets and without the lines of devices: with the sources of the driver that can interrupt in this robot.
DriverBuses make_buses(const Robot& robot, const BusPlaces& places, const Table<BusId, BusUse>& uses);

}  // namespace finemote::gen::timing
