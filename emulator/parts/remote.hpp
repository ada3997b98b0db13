// Receivers of remote controls: what the operator's hands do, as frames on a serial line.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "emulator/chip/peripheral.hpp"
#include "emulator/chip/usart.hpp"

namespace finemote::emulator {

/// What the operator does. Sticks and wheel -1..1, to the right and away from the operator.
struct Hands {
  enum Switch { kUp = 1, kDown = 2, kMiddle = 3 };  // as DBUS codes them
  double right_x = 0, right_y = 0, left_x = 0, left_y = 0, wheel = 0;
  Switch left_switch = kMiddle, right_switch = kMiddle;
  std::uint16_t keys = 0;
  std::array<std::int16_t, 3> mouse{};  ///< x, y and wheel, counts per frame
  bool mouse_left = false, mouse_right = false;
  bool failsafe = false;  ///< the receiver has lost its transmitter; SBUS says so, DBUS falls silent
};

/// 18 bytes of the DR16: four channels of 11 bits around 1024, two switches, mouse, keys, wheel. Without checksum.
std::vector<std::uint8_t> dbus_frame(const Hands& hands);

using SbusChannels = std::array<unsigned, 16>;  ///< 0..2047 each
/// 25 bytes of SBUS: 0x0F, sixteen channels of 11 bits, flags, 0x00.
std::vector<std::uint8_t> sbus_frame(const SbusChannels& channels, std::uint8_t flags);
/// Channels in the order A E T R, switches, wheel; the others at their centre.
std::vector<std::uint8_t> sbus_frame(const Hands& hands);

class RemoteReceiver {
 public:
  using Encode = std::vector<std::uint8_t> (*)(const Hands&);
  RemoteReceiver(World& world, Usart& usart, const SerialFormat& format, Encode encode, Time period, Time phase);

  Hands hands;
  bool silent = false;
  unsigned damaged_frames = 0;  ///< the next ones lack their last byte
  /// Told when a frame begins that is whole. @return what its bytes carry
  std::function<Tag(Time begin, Time end)> on_frame;

 private:
  void send();

  World& world_;
  Usart& usart_;
  SerialFormat format_;
  Encode encode_;
  Time period_;
};

}  // namespace finemote::emulator
