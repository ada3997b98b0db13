#include "finemote/devices/dr16.hpp"

#include "little_endian.hpp"

namespace finemote {

namespace {

constexpr int kLowest = 364, kCentre = 1024, kHighest = 1684;
constexpr float kScale = 1.0F / 660;

bool scaled(int channel, float& out) {
  out = static_cast<float>(channel - kCentre) * kScale;
  return channel >= kLowest && channel <= kHighest;
}

bool switch_of(unsigned bits, RemoteSwitch& out) {
  constexpr RemoteSwitch kMeaning[4] = {RemoteSwitch::kUnknown, RemoteSwitch::kUp, RemoteSwitch::kDown,
                                        RemoteSwitch::kMiddle};
  out = kMeaning[bits & 3U];
  return out != RemoteSwitch::kUnknown;
}

}  // namespace

void Dr16::update() {
  uart_->read_all(recent_.room(), Uart::kChunk, [this](std::size_t size) { take(size); });
  if (!is_fresh(state, now(), kMaxAge)) state.valid = false;
}

/// The silence that ends a message may have the begin of the next one behind it.
void Dr16::take(std::size_t size) {
  const std::size_t all = size_ + size, since = uart_->since_silence();
  const std::size_t behind = since < size ? since : size;
  if (since < all)
    end_message(size - behind < size ? size - behind : size, behind, since <= size && (all - since) % kFrame == 0);
  const std::size_t left = since < all ? since : all;
  size_ = static_cast<std::uint16_t>(left < kFrame ? left : kFrame + left % kFrame);
  const std::size_t kept = size_ < kFrame ? size_ : kFrame;
  recent_.keep(recent_.room() + size - kept, size);
}

/// @param end     of those that were read last, its bytes
/// @param behind  bytes that were read behind it
void Dr16::end_message(std::size_t end, std::size_t behind, bool has_size) {
  const std::uint32_t errors = uart_->counters().errors;
  RemoteState decoded;
  const bool whole = has_size && errors == line_errors_;
  if (whole && decode(recent_.room() + end - kFrame, decoded)) {
    decoded.origin = uart_->began(behind, kFrame);
    decoded.valid = true;
    state = decoded;
  } else {
    ++bad_frames_;
  }
  line_errors_ = errors;
}

bool Dr16::decode(const std::uint8_t* frame, RemoteState& out) const {
  bool good = scaled(eleven_bits_at(frame, 0), out.right_x);
  good = scaled(eleven_bits_at(frame, 11), out.right_y) && good;
  good = scaled(eleven_bits_at(frame, 22), out.left_x) && good;
  good = scaled(eleven_bits_at(frame, 33), out.left_y) && good;
  good = switch_of(frame[5] >> 6U, out.left_switch) && good;
  good = switch_of(frame[5] >> 4U, out.right_switch) && good;
  for (int i = 0; i < 3; ++i) out.mouse[i] = int16_at(frame + 6 + 2 * i);
  out.mouse_left = frame[12] != 0;
  out.mouse_right = frame[13] != 0;
  good = good && frame[12] <= 1 && frame[13] <= 1;
  out.keys = uint16_at(frame + 14);
  const int wheel = uint16_at(frame + 16) & 0x7FF;
  // Receivers without a wheel send 0 there.
  if (wheel != 0) good = scaled(wheel, out.wheel) && good;
  return good;
}

}  // namespace finemote
