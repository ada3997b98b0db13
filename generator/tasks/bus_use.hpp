// What a robot does with one of its buses: facts that decide which interrupts there can be, and how they are counted.
#pragma once

#include <cstdint>

#include "generator/model/connection.hpp"
#include "generator/model/robot.hpp"

namespace finemote::gen::timing {

struct BusUse {
  bool is_used = false;           ///< a device or an expander sits on it
  bool transmits = false;         ///< a device writes to it, or is connected to it by a `<use>`
  bool is_declared = true;        ///< every device on it says what it sends
  std::size_t shared_frames = 1;  ///< at most, that the devices of one period fill together and one request hands over
  /// Bits of the shortest frames that parts send by themselves, and that devices send; 0: there is none, or the kind of
  /// bus does not tell.
  std::int64_t least_received = 0, least_sent = 0;
  std::int64_t slots = 0;  ///< places where its driver looks: devices, expanders, further frames they receive
};

/// Whether the device's type says what goes over this connection, and how often.
bool is_declared(const Robot& robot, const gen::Device& device, const Connection& connection);

/// Of every bus.
Table<BusId, BusUse> bus_uses(const Robot& robot);

}  // namespace finemote::gen::timing
