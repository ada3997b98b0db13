#include "finemote/devices/h30_imu.hpp"

namespace finemote {

namespace {

constexpr std::uint8_t kHead0 = 0x59, kHead1 = 0x53;
constexpr std::size_t kHeads = 2, kNumberAt = 2, kLengthAt = 4;

/// Frames with a wrong sum whose bytes are looked at once more, in one update().
constexpr unsigned kMostBad = 3;

// Record types and what they must hold.
constexpr std::uint8_t kAcceleration = 0x10, kRates = 0x20, kAngles = 0x40;
constexpr std::size_t kVector = 12;

constexpr float kMicro = 1e-6F;
constexpr float kMicroDegree = 1.745329252e-8F;  ///< rad

// Ranges of the part: 16 g, 2000 deg/s, one turn; in the units of the wire.
constexpr std::int32_t kMaxAcceleration = 160000000;
constexpr std::int32_t kMaxRate = 2000000000;
constexpr std::int32_t kMaxAngle = 180000000, kMaxPitch = 90000000;

std::int32_t int32_at(const std::uint8_t* bytes) {
  return static_cast<std::int32_t>(std::uint32_t{bytes[0]} | std::uint32_t{bytes[1]} << 8 |
                                   std::uint32_t{bytes[2]} << 16 | std::uint32_t{bytes[3]} << 24);
}

bool within(std::int32_t value, std::int32_t limit) { return value >= -limit && value <= limit; }

bool vector_at(const std::uint8_t* bytes, std::int32_t limit, float unit, float (&out)[3]) {
  for (int i = 0; i < 3; ++i) {
    const std::int32_t value = int32_at(bytes + 4 * i);
    if (!within(value, limit)) return false;
    out[i] = static_cast<float>(value) * unit;
  }
  return true;
}

/// Pitch, roll and yaw in this order; false, and nothing is changed, when one is out of range.
bool angles_at(const std::uint8_t* bytes, ImuState& out) {
  float pitch_roll_yaw[3] = {};
  if (!vector_at(bytes, kMaxAngle, kMicroDegree, pitch_roll_yaw) || !within(int32_at(bytes), kMaxPitch)) return false;
  out.pitch = pitch_roll_yaw[0];
  out.roll = pitch_roll_yaw[1];
  out.yaw = pitch_roll_yaw[2];
  return true;
}

}  // namespace

void H30Imu::update() {
  std::uint8_t bytes[64];
  const std::uint32_t before = frames_;
  bad_now_ = 0;
  std::size_t size = sizeof bytes;
  for (std::size_t left = uart_->full_reads(sizeof bytes) + 1; size == sizeof bytes && left != 0; --left) {
    size = uart_->read(bytes, sizeof bytes);
    take(bytes, size);
  }
  if (frames_ != before) turn_state();
  if (!is_fresh(state, now(), kMaxAge)) state.valid = false;
}

/// Of the last frame alone: the others are gone. With the part's attitude as what takes its axes to the world's, the
/// body's is the way back through the mount and then that.
void H30Imu::turn_state() {
  if (mount_ == nullptr) return;
  turn(mount_, state.acceleration);
  turn(mount_, state.rate);
  const Rotation body = Rotation::of_angles(state.roll, state.pitch, state.yaw) * inverse(*mount_);
  state.roll = body.roll();
  state.pitch = body.pitch();
  state.yaw = body.yaw();
}

void H30Imu::take(const std::uint8_t* bytes, std::size_t size) {
  for (std::size_t i = 0; i < size;) {
    if (frame_.size() < kHeads) {
      frame_.begin(bytes[i++], kHead0, kHead1);
    } else {
      const std::size_t missing = needed_ - frame_.size(), count = size - i < missing ? size - i : missing;
      frame_.append(bytes + i, count);
      i += count;
    }
    if (frame_.size() < needed_) continue;
    behind_ = size - i;
    look();
  }
}

/// Looks for frames until more bytes are needed.
void H30Imu::look() {
  do {
    needed_ = examine();
    if (needed_ != 0) continue;
    frame_.drop_to_next(kHead0);
    needed_ = kHeads;
  } while (frame_.size() >= needed_);
}

/// Looks at what there is of a frame; a whole one is decoded. How many bytes there must be to say more, 0 when this is
/// no frame.
std::size_t H30Imu::examine() {
  if (frame_[0] != kHead0 || frame_[1] != kHead1) return 0;
  if (frame_.size() < kHeader) return kHeader;
  const std::size_t payload = frame_[kLengthAt];
  const std::size_t whole = kHeader + payload + kSums;
  if (payload > kMaxPayload) return 0;
  if (frame_.size() < whole) return whole;

  ImuState decoded;
  if (!sums_agree(payload) || !decode(payload, decoded)) {
    ++bad_frames_;
    if (++bad_now_ > kMostBad) frame_.drop(whole - 1);
    return 0;
  }
  ++frames_;
  decoded.origin = uart_->arrival(behind_ + frame_.size() - whole) - uart_->wire_time(whole);
  decoded.valid = true;
  state = decoded;
  frame_.drop(whole);
  return kHeads;
}

bool H30Imu::sums_agree(std::size_t payload) const {
  std::uint8_t sum1 = 0, sum2 = 0;
  const std::size_t end = kHeader + payload;
  for (std::size_t i = kNumberAt; i < end; ++i) {
    sum1 = static_cast<std::uint8_t>(sum1 + frame_[i]);
    sum2 = static_cast<std::uint8_t>(sum2 + sum1);
  }
  return frame_[end] == sum1 && frame_[end + 1] == sum2;
}

bool H30Imu::decode(std::size_t payload, ImuState& out) const {
  bool acceleration = false, rates = false, angles = false;
  const std::size_t end = kHeader + payload;
  std::size_t at = kHeader;
  while (at + 2 <= end) {
    const std::uint8_t type = frame_[at];
    const std::size_t length = frame_[at + 1];
    const std::uint8_t* data = frame_.data() + at + 2;
    at += 2 + length;
    if (at > end) return false;
    const bool known = type == kAcceleration || type == kRates || type == kAngles;
    if (!known) continue;
    if (length != kVector) return false;
    switch (type) {
      case kAcceleration:
        acceleration = vector_at(data, kMaxAcceleration, kMicro, out.acceleration);
        break;
      case kRates:
        rates = vector_at(data, kMaxRate, kMicroDegree, out.rate);
        break;
      default:
        angles = angles_at(data, out);
        break;
    }
  }
  return at == end && acceleration && rates && angles;
}

}  // namespace finemote
