// The bus of a CAN port on the host: what the robot sent, what others send, and bus-off.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "board/wires.hpp"
#include "finemote/ports.hpp"

namespace finemote {

/// The host's bus, and the hardware behind CanPort.
struct CanHardware {
  // ---- for tests
  /// A frame the robot sent.
  struct Sent {
    Time at;         ///< its last bit
    CanFrame frame;  ///< as sent
  };
  /// A frame from another node at `at`; filtered as the controller does.
  void feed(Time at, const CanFrame& frame);
  /// Called for each frame the robot has sent, at its end.
  std::function<void(const CanFrame&)> listener;
  std::vector<Sent> sent;  ///< by the robot, in order
  bool off = false;        ///< the controller has left the bus
  /// Called whenever the driver pends its interrupt: in the middle of whatever asked for it.
  std::function<void()> when_pended;

  // ---- for the port
  std::vector<CanIds> accepted;
  std::vector<CanFrame> mailboxes;  ///< at most three
  std::int64_t bitrate = 0;
  CanBus* bus = nullptr;
  bool sending = false;
};

}  // namespace finemote
