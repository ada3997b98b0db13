// Turns SBUS frames of a model-making receiver into sticks and switches.
#pragma once

#include <cstddef>
#include <cstdint>

#include "finemote/contract.hpp"
#include "finemote/interfaces/remote.hpp"
#include "finemote/recent_bytes.hpp"
#include "finemote/uart.hpp"

namespace finemote {

/// 25 bytes every 7 or 14 ms, 100 kbit/s 8E2 inverted: 0x0F, sixteen channels of 11 bits, flags, and 0x00 or, of
/// receivers with slots for telemetry (S.BUS2), 0x04, 0x14, 0x24, 0x34 in turn. A frame counts if both ends are right
/// the line did not fall silent within it, and the receiver reports neither a lost frame nor failsafe; none does that
/// was read together with a damaged byte. Channels 1..4 are the right stick (x, y) and the left stick (y, x) as most
/// transmitters order them (AETR), 5 and 6 the left and right switch, 7 the wheel. The state is valid until kMaxAge
/// after the last frame; its origin is when the frame began to arrive.
class Sbus {
 public:
  static constexpr Duration kMaxAge = 100 * kMillisecond;
  static constexpr std::size_t kFrame = 25;

  constexpr explicit Sbus(Uart& uart) : uart_(&uart) {}

  void update();
  void handle() {}

  RemoteState state;

  /// Frames with a wrong end, or with a silence within, or that overlap another one: of those that overlap one. Wraps.
  [[nodiscard]] std::uint32_t bad_frames() const { return bad_frames_; }
  /// Frames with both ends right, whatever their flags say; wraps.
  [[nodiscard]] std::uint32_t frames() const { return frames_; }
  /// Of the last of them: the receiver has lost its transmitter and says so.
  [[nodiscard]] bool failsafe() const { return (flags() & kFailsafe) != 0; }
  /// It has not heard the frame it should send now.
  [[nodiscard]] bool frame_lost() const { return (flags() & kFrameLost) != 0; }
  /// Channel 1..16 as on the wire, 0..2047.
  [[nodiscard]] std::uint16_t channel(unsigned number) const;
  /// Channel 17 or 18, which is on or off.
  [[nodiscard]] bool digital(unsigned number) const { return (flags() >> (number - 17) & 1U) != 0; }

 private:
  static constexpr std::size_t kFlagsAt = 23;
  static constexpr std::uint8_t kFrameLost = 0x04, kFailsafe = 0x08;

  [[nodiscard]] std::uint8_t flags() const { return last_[kFlagsAt]; }
  /// Of what was read, and what is kept.
  [[nodiscard]] bool is_damaged();
  /// Looks for frames in what is kept and `size` bytes more.
  void look(std::size_t size);
  [[nodiscard]] bool is_apart(const std::uint8_t* frame, std::size_t silence) const;
  /// @param behind  bytes that arrived together behind the frame
  void decode(const std::uint8_t* frame, std::size_t behind);
  /// How often bytes were lost.
  [[nodiscard]] std::uint32_t gaps() const;

  Uart* const uart_;
  RecentBytes<kFrame> recent_;
  std::uint8_t last_[kFlagsAt + 1]{};  ///< begin of the last whole frame
  std::uint32_t frames_ = 0, bad_frames_ = 0;
  bool has_slots_ = false;         ///< the last frame that ended at a silence has slots for telemetry
  std::uint32_t line_errors_ = 0;  ///< that the line had when it was read last
};

}  // namespace finemote
