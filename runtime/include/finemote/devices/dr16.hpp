// Turns the frames of a DJI DR16 receiver (DBUS) into sticks, switches, mouse and keys.
#pragma once

#include <cstddef>
#include <cstdint>

#include "finemote/contract.hpp"
#include "finemote/interfaces/remote.hpp"
#include "finemote/recent_bytes.hpp"
#include "finemote/uart.hpp"

namespace finemote {

/// 18 bytes every 14 ms, 100 kbit/s 8E1 inverted, without header or checksum: what lies between two silences of the
/// line is a frame if it has the right length, and counts if all channels and switches are in range and the line had no
/// error. The state is valid until kMaxAge after the last one; its origin is when the frame began to arrive.
class Dr16 {
 public:
  static constexpr Duration kMaxAge = 100 * kMillisecond;
  static constexpr std::size_t kFrame = 18;

  constexpr explicit Dr16(Uart& uart) : uart_(&uart) {}

  void update();
  void handle() {}

  RemoteState state;

  [[nodiscard]] std::uint32_t bad_frames() const { return bad_frames_; }

 private:
  void take(std::size_t size);
  void end_message(std::size_t end, std::size_t behind, bool has_size);
  bool decode(const std::uint8_t* frame, RemoteState& out) const;

  Uart* const uart_;
  RecentBytes<kFrame> recent_;
  std::uint16_t size_ = 0;  ///< bytes since the line was silent last; of more than a frame a number as good
  std::uint32_t line_errors_ = 0, bad_frames_ = 0;
};

}  // namespace finemote
