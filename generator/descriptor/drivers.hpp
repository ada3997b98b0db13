// What the runtime's bus drivers cost on a board: `drivers` of a board file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "generator/bus/bus_kind.hpp"
#include "generator/units/duration.hpp"

namespace finemote::gen {

/// One interrupt source of a driver.
struct DriverSource {
  /// What comes in, what goes out, or either.
  enum class RaisedBy { either, receive, transmit };
  /// What raises it, one interrupt each: declared traffic, or the line events that the driver allows; nothing: not
  /// known.
  enum class Counts { nothing, requests, steps, ends, received, events };
  std::string name;  ///< `rx_idle`
  Counts counts = Counts::nothing;
  RaisedBy raised_by = RaisedBy::either;
  Duration isr_wcet;
  Duration isr_per_slot;                    ///< besides, for everything the bus serves
  Duration isr_per_frame;                   ///< besides, for every frame that one request hands over
  std::int64_t isr_waits_bits = 0;          ///< bits on the wire that it may wait for,
  std::optional<Duration> isr_beside_wait;  ///< and how much longer than the wait it takes; none: all of its work
  std::int64_t min_frame_bits = 1;          ///< bits on the wire between two of its interrupts, at least
};

struct Driver {
  Duration isr_wcet;
  std::int64_t min_frame_bits = 1;
  std::vector<DriverSource> sources;
  Duration supervise;         ///< one look at the bus, in every job of the fastest bucket
  std::size_t mailboxes = 0;  ///< can: frames that wait in the controller and go by identifier; 0: not known
  bool is_assumed = false;    ///< not measured
  std::string summary;
};

using Drivers = std::map<BusKind, Driver>;

/// Reads a member that the schema accepts.
Drivers read_drivers(const nlohmann::ordered_json& value);

}  // namespace finemote::gen
