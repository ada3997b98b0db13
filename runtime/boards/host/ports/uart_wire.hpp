// The two lines of a serial port on the host: bytes arrive and leave in their time, and errors can be scripted.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "board/wires.hpp"
#include "finemote/ports.hpp"

namespace finemote::host {

/// A block the robot sent.
struct Sent {
  Time begin;                       ///< first start bit
  Time end;                         ///< last stop bit
  std::vector<std::uint8_t> bytes;  ///< as sent
};

}  // namespace finemote::host

namespace finemote {

/// The host's serial line, and the hardware behind UartPort.
struct UartHardware {
  // ---- for tests
  /// Bytes from outside: the first begins at `at` (or after what is still on its way), one follows the other.
  void feed(Time at, const std::vector<std::uint8_t>& bytes);
  void feed(Time at, const std::string& text);  ///< the same of the characters of a text
  /// The receiver sees this many disturbed bytes.
  void disturb(std::uint32_t count) { errors.framing += count; }
  /// Reception stops, as after a DMA error, until the driver restarts it; what arrives meanwhile is lost.
  void halt_reception();
  /// Nothing leaves any more: transmit() never ends.
  void block_sending(bool block) { blocked = block; }
  /// Silence, no errors, nothing recorded. The driver's position in the ring stays.
  void reset();

  std::vector<host::Sent> sent;  ///< by the robot, in order

  // ---- for the port
  struct Byte {
    Time at;  ///< of its stop bit
    std::uint8_t value;
  };
  void catch_up();  ///< moves what has arrived by now into the ring

  static constexpr std::size_t kBuffer = 128;
  UartRing ring;  ///< empty: not started
  std::uint8_t buffer[kBuffer] = {};
  std::deque<Byte> coming;
  std::uint32_t received = 0;
  Time last = 0;  ///< stop bit of the last byte that arrived
  Time line_free = 0;
  UartIdle idle;
  UartErrors errors;
  bool halted = false, blocked = false, sending = false;
  Time sending_until = 0;
  Duration byte_time = 0;  ///< 0: not started
  int driver = -1;         ///< pin of the line driver; -1: none
  bool driver_low = false;
};

}  // namespace finemote
