// Turns the byte stream of a Yesense H30 attitude sensor into attitude, rates and acceleration.
#pragma once

#include <cstddef>
#include <cstdint>

#include "finemote/contract.hpp"
#include "finemote/geometry.hpp"
#include "finemote/interfaces/imu.hpp"
#include "finemote/recent_bytes.hpp"
#include "finemote/uart.hpp"

namespace finemote {

/// The sensor sends frames by itself. Wire format:
///
///     0x59 0x53 | number (2, little-endian) | length (1) | length bytes of records | sum 1 | sum 2
///     record: type (1) | length (1) | payload, little-endian
///
/// Sum 1 is the sum of all bytes from the number to the last record byte, sum 2 the sum of all values sum 1 took on the
/// way, both modulo 256. Records used: 0x10 acceleration (3 x int32, 1e-6 m/s^2), 0x20 rates (3 x int32, 1e-6 deg/s),
/// 0x40 pitch, roll, yaw (3 x int32, 1e-6 deg); others are passed over.
///
/// A frame counts when both sums agree, its records, at most twelve, fill it exactly, all three records above are
/// there, and every value is in range; of several in one update() only the last one whose sums agree. Attitude, rates
/// and acceleration are in the axes of the robot's body, wherever the URDF says the part's own link points. The state
/// is valid until kMaxAge after the last one; its origin is a millisecond before its frame began to arrive, for the
/// filter inside.
class H30Imu {
 public:
  static constexpr Duration kMaxAge = 50 * kMillisecond;

  /// @param mount  takes the part's axes to those wanted; null: they are the same
  constexpr H30Imu(const Rotation* mount, Uart& uart) : mount_(mount), uart_(&uart) {}

  void update();
  void handle() {}

  ImuState state;

  /// Frames that counted, and those dropped for a wrong sum or content, of which that overlap one. Both wrap.
  [[nodiscard]] std::uint32_t frames() const { return frames_; }
  [[nodiscard]] std::uint32_t bad_frames() const { return bad_frames_; }

 private:
  static constexpr std::size_t kHeader = 5, kSums = 2, kMaxPayload = 0x58;  ///< with both records of its magnetometer
  static constexpr std::size_t kMaxFrame = kHeader + kMaxPayload + kSums;

  static constexpr std::size_t kMostBytes = RecentBytes<kMaxFrame>::kMost;
  static constexpr std::size_t kLeastPayload = 3 * 14;  ///< the three records that are used
  static constexpr std::size_t kLeastFrame = kHeader + kLeastPayload + kSums;
  /// Places that look like the begin of a frame and are none: inside so many of them a read looks for a better one.
  static constexpr unsigned kMostRejected = 1;
  static constexpr unsigned kMostRecords = 12;  ///< of a frame

  /// What one read has brought.
  struct Found {
    const std::uint8_t* last = nullptr;  ///< the last frame whose sums agree; null: there is none
    std::uint32_t frames = 0;            ///< those whose sums agree
    std::size_t decided = 0;             ///< so many bytes begin no frame that is still to come
  };

  const std::uint8_t* look(std::size_t size);
  Found find(const std::uint8_t* begin, std::size_t count);
  [[nodiscard]] unsigned most_frames() const;
  bool take(const std::uint8_t* frame);
  void stamp(std::size_t since, std::size_t whole);
  static std::size_t size_of(const std::uint8_t* frame, std::size_t size);
  static std::size_t payload_of(const std::uint8_t* frame);
  static bool sums_agree(const std::uint8_t* frame);
  static bool decode(const std::uint8_t* frame, std::size_t payload, ImuState& out);
  void turn_state();

  const Rotation* mount_;
  Uart* const uart_;
  RecentBytes<kMaxFrame> recent_;
  std::uint32_t frames_ = 0, bad_frames_ = 0;
};

}  // namespace finemote
