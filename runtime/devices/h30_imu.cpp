#include "finemote/devices/h30_imu.hpp"

#include "finemote/four_bytes.hpp"
#include "finemote/loop_bound.hpp"
#include "frame_heads.hpp"
#include "little_endian.hpp"

namespace finemote {

namespace {

constexpr std::uint8_t kHead0 = 0x59, kHead1 = 0x53;
constexpr std::size_t kHeads = 2, kNumberAt = 2, kLengthAt = 4;

// Record types and what they must hold.
constexpr std::uint8_t kAcceleration = 0x10, kRates = 0x20, kAngles = 0x40;
constexpr std::size_t kVector = 12;

/// How much older a sample is than its frame: `latency_ns` in the descriptor.
constexpr Duration kLatency = 1 * kMillisecond;

constexpr float kMicro = 1e-6F;
constexpr float kMicroDegree = 1.745329252e-8F;  ///< rad

// Ranges of the part: 16 g, 2000 deg/s, one turn; in the units of the wire.
constexpr std::int32_t kMaxAcceleration = 160000000;
constexpr std::int32_t kMaxRate = 2000000000;
constexpr std::int32_t kMaxAngle = 180000000, kMaxPitch = 90000000;

/// Of a frame, modulo 256 in the end.
struct Sums {
  std::uint32_t first = 0, second = 0;

  [[gnu::always_inline]] void add(std::uint32_t byte) {
    first += byte;
    second += first;
  }
  /// The lowest byte is the first.
  [[gnu::always_inline]] void add_four(std::uint32_t four) {
    add(four & 0xFFU);
    add(four >> 8 & 0xFFU);
    add(four >> 16 & 0xFFU);
    add(four >> 24);
  }
};

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
  const std::uint32_t before = frames_;
  uart_->read_all(recent_.room(), Uart::kChunk, [this](std::size_t size) { recent_.keep(look(size), size); });
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

/// Looks for frames in what is kept and `size` bytes more. Returns the first byte that may still begin one.
const std::uint8_t* H30Imu::look(std::size_t size) {
  const std::uint8_t* const begin = recent_.begin();
  const std::uint8_t* const end = recent_.room() + size;
  const Found found = find(begin, recent_.kept() + size);
  if (found.last != nullptr && take(found.last)) {
    frames_ += found.frames;
    stamp(static_cast<std::size_t>(end - found.last), size_of(found.last, kMaxFrame));
  }
  return begin + found.decided;
}

/// Frames that fill what one read has brought, and places that are none.
unsigned H30Imu::most_frames() const {
  return static_cast<unsigned>((uart_->most_in_chunk() + kMaxFrame) / kLeastFrame) + kMostRejected;
}

/// Goes from one place at which a frame may begin to the next: behind a good one, else to the next inside, for what
/// looked like a beginning was none, or bytes were lost. Where too many look like it, inside no more: then every byte
/// is summed once, whatever the line brings.
H30Imu::Found H30Imu::find(const std::uint8_t* begin, std::size_t count) {
  const FrameHeads<kMostBytes> heads(begin, count, kHead0, kHead1);
  Found found;
  std::size_t at = 0;
  unsigned doubts = 0;
  for (unsigned left = most_frames(); left != 0; --left) {
    at = heads.next(at);
    if (at >= count) break;
    const std::uint8_t* const frame = begin + at;
    const std::size_t whole = size_of(frame, count - at);
    if (whole > count - at) break;
    if (whole != 0 && sums_agree(frame)) {
      found.last = frame;
      ++found.frames;
      at += whole;
      continue;
    }
    if (whole != 0) ++bad_frames_;
    at += whole != 0 && ++doubts > kMostRejected ? whole : kHeads;
  }
  found.decided = at < count ? at : count;
  return found;
}

/// Bytes of the frame that begins there, more than `size` where that many do not tell; 0: it is none.
std::size_t H30Imu::size_of(const std::uint8_t* frame, std::size_t size) {
  if (size < kHeader) return kHeader;
  const std::size_t payload = frame[kLengthAt];
  return payload >= kLeastPayload && payload <= kMaxPayload ? kHeader + payload + kSums : 0;
}

/// Of a frame of which size_of() knows a size: never more, which only this line tells tools.
std::size_t H30Imu::payload_of(const std::uint8_t* frame) {
  return frame[kLengthAt] < kMaxPayload ? frame[kLengthAt] : kMaxPayload;
}

/// A whole frame whose sums agree; false, and nothing is changed, when it does not count.
bool H30Imu::take(const std::uint8_t* frame) {
  ImuState decoded;
  if (!decode(frame, payload_of(frame), decoded)) {
    ++bad_frames_;
    return false;
  }
  state = decoded;
  return true;
}

/// @param since  bytes from the begin of the last good frame on
void H30Imu::stamp(std::size_t since, std::size_t whole) {
  state.origin = uart_->began(since - whole, whole) - kLatency;
  state.valid = true;
}

bool H30Imu::sums_agree(const std::uint8_t* frame) {
  const std::uint8_t* at = frame + kNumberAt;
  const std::size_t count = kHeader - kNumberAt + payload_of(frame);
  Sums sums;
  for (std::size_t fours = count / 4; fours != 0; --fours) {
    as_counted(fours);
    sums.add_four(four_bytes(at));
    at += 4;
  }
  for (std::size_t rest = count % 4; rest != 0; --rest) {
    as_counted(rest);
    sums.add(*at++);
  }
  return (sums.first & 0xFFU) == at[0] && (sums.second & 0xFFU) == at[1];
}

/// The last record of a type counts.
bool H30Imu::decode(const std::uint8_t* frame, std::size_t payload, ImuState& out) {
  const std::uint8_t *acceleration = nullptr, *rates = nullptr, *angles = nullptr;
  const std::size_t end = kHeader + payload;
  std::size_t at = kHeader;
  for (unsigned left = kMostRecords; left != 0 && at + 2 <= end; --left) {
    const std::uint8_t type = frame[at], length = frame[at + 1];
    const std::uint8_t* const data = frame + at + 2;
    at += 2U + length;
    const bool is_known = type == kAcceleration || type == kRates || type == kAngles;
    if (at > end || (is_known && length != kVector)) return false;
    if (type == kAcceleration) acceleration = data;
    if (type == kRates) rates = data;
    if (type == kAngles) angles = data;
  }
  return at == end && acceleration != nullptr && rates != nullptr && angles != nullptr &&
         vector_at(acceleration, kMaxAcceleration, kMicro, out.acceleration) &&
         vector_at(rates, kMaxRate, kMicroDegree, out.rate) && angles_at(angles, out);
}

}  // namespace finemote
