// What devices send and receive, to transfers of the timing model and budgets of the interrupts they cause.
#pragma once

#include <optional>

#include "generator/model/connection.hpp"
#include "generator/tasks/bus_use.hpp"
#include "generator/tasks/robot_buses.hpp"
#include "generator/tasks/wire_use.hpp"

namespace finemote::gen::timing {

/// Adds the traffic of one device or flush after the other to a model whose buses are complete.
class Traffic {
 public:
  /// Robot, places, uses and model must outlive this.
  /// @param counts  what the sources of each bus of the model count, as DriverBuses has it
  Traffic(const Robot& robot, const BusPlaces& places, const Table<BusId, BusUse>& uses,
          Table<BusPlace, std::vector<DriverSource::Counts>> counts, Model& model);

  /// Transfers of a device that has a type, over its own bus and those of its uses, and interrupts of lines of its own.
  /// Frames of stage `flush` are left to the flush of its bucket.
  /// @param place  of the device in Model::devices
  void add_device(const gen::Device& device, Rank place);

  /// Allows the interrupts of one use of a bus, asked for in one of any `every` periods of the device. Adds nothing
  /// where a driver does not say what its interrupts count. Where a device does not say what it sends, adds requests
  /// alone.
  /// @param stage  that asks: of the device, or the flush of its job
  void add_budget(BusPlace bus, Rank place, const WireUse& use, FrameStage stage, std::int64_t every = 1);

  /// Once, after all traffic was added: a source that no declared traffic raises does not interrupt. Where a device
  /// does not say what it sends, every slot may ask for a transfer as soon as its last one has ended.
  void settle();

  /// Every device on the bus says what it sends, and how often.
  [[nodiscard]] bool is_counted(BusPlace bus) const;

  /// How long the routines of one use run on their own, where a driver says what its interrupts count; else 0.
  [[nodiscard]] Duration service(BusPlace bus, const WireUse& use) const;

  /// What goes ahead of a unit on a segment: a mux is set, and where there are several, the one set before is switched
  /// off first.
  void add_selection(SegmentId segment, const WireRate& rate, WireUse& use) const;

 private:
  void add_frames(const gen::Device& device, const Connection& connection, Rank place);
  static void share_wire_of_answers(std::vector<Transfer>& transfers, std::size_t first);
  void add_transfer(Rank place, BusPlace bus, FrameStage stage, const WireUse& use);
  void add_own_lines(const gen::Device& device, Rank place);
  [[nodiscard]] std::optional<BusPlace> bus_of(const gen::Device& device) const;
  [[nodiscard]] std::vector<InterruptSource>& own_lines(const gen::Device& device);
  [[nodiscard]] InterruptSource own_line(const gen::Device& device, const Interrupt& entry, Rank place) const;
  [[nodiscard]] bool may_send_late(const gen::Device& device) const;
  void mark_late_commands(const gen::Device& device, Rank place);
  [[nodiscard]] Duration pin_wcet(const gen::Device& device) const;
  void allow_events(BusPlace bus, Rank reader);
  void allow(BusPlace bus, DriverSource::Counts what, const FrameBudget& budget);
  void allow_bytes(BusPlace bus, const WireUse& use, FrameBudget budget);
  [[nodiscard]] std::int64_t under_way(BusPlace bus) const;
  void let_requests_meet(BusPlace bus);
  void drop_unraised(BusPlace bus);
  void allow_requests_of_slots(BusPlace bus);

  const Robot& robot_;
  const BusPlaces& places_;
  const Table<BusId, BusUse>& uses_;
  Model& model_;
  Table<BusPlace, std::vector<DriverSource::Counts>> counts_;  ///< of driver sources; lines of devices come after
  Table<BusPlace, std::optional<Rank>> user_;                  ///< the first device on each bus
  Bus pins_;                                                   ///< lines of devices that no bus carries
};

}  // namespace finemote::gen::timing
