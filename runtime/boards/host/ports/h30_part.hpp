// Turns an attitude into the bytes a Yesense H30 sends, for the host board.
#pragma once

#include <cstdint>
#include <vector>

#include "finemote/interfaces/imu.hpp"
#include "runtime/boards/host/ports/uart_wire.hpp"

namespace finemote::host {

/// One frame: acceleration, rates, angles and a quaternion; 67 bytes.
std::vector<std::uint8_t> h30_frame(const ImuState& state, std::uint16_t number);

/// A sensor that sends by itself from `begin` on.
class H30Part {
 public:
  /// @param interval  from one frame to the next, > 0
  H30Part(UartHardware& line, Time begin, Duration interval);

  ImuState state;            ///< the world
  bool silent = false;       ///< sends nothing
  bool noisy = false;        ///< one byte of every frame is wrong
  std::uint16_t number = 0;  ///< of the next frame

 private:
  void send(Time at);

  UartHardware& line_;
  Duration interval_;
};

}  // namespace finemote::host
