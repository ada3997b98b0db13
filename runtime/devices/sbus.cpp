#include "finemote/devices/sbus.hpp"

#include <cstring>

#include "finemote/control/pid.hpp"

namespace finemote {

namespace {

constexpr std::uint8_t kHead = 0x0F, kTail = 0x00;
/// S.BUS2: the group of telemetry slots that follows stands in bits 4 and 5.
constexpr std::uint8_t kSlotTail = 0x04, kSlotGroup = 0x30;
/// Frames with a wrong end whose bytes are looked at once more, in one update().
constexpr unsigned kMostBad = 2;
constexpr int kCentre = 992;
constexpr float kScale = 1.0F / 820;  ///< 172..1811 is -1..1

bool is_tail(std::uint8_t byte) { return byte == kTail || (byte & ~kSlotGroup) == kSlotTail; }

float scaled(std::uint16_t channel) { return clamp(static_cast<float>(channel - kCentre) * kScale, -1, 1); }

RemoteSwitch switch_of(std::uint16_t channel) {
  if (channel < kCentre - 400) return RemoteSwitch::kUp;
  return channel > kCentre + 400 ? RemoteSwitch::kDown : RemoteSwitch::kMiddle;
}

}  // namespace

void Sbus::update() {
  const std::uint32_t before = gaps();
  bad_now_ = 0;
  std::uint8_t bytes[64];
  std::size_t size = sizeof bytes;
  for (std::size_t left = uart_->full_reads(sizeof bytes) + 1; size == sizeof bytes && left != 0; --left) {
    size = uart_->read(bytes, sizeof bytes);
    if (gaps() != before) frame_.drop(frame_.size());  // what is kept lies before the gap
    for (std::size_t i = 0; i < size;) {
      if (frame_.size() == kFrame) decode(size - i);
      i += frame_.size() != 0 || bytes[i] == kHead ? take(bytes + i, size - i) : 1;
    }
  }
  if (frame_.size() == kFrame && uart_->idle()) decode(0);
  if (!is_fresh(state, now(), kMaxAge)) state.valid = false;
}

std::uint32_t Sbus::gaps() const { return uart_->counters().lost + uart_->counters().recoveries; }

// A whole frame waits for the silence behind it, which tells when it came, or for the first byte of the next one.
std::size_t Sbus::take(const std::uint8_t* bytes, std::size_t size) {
  const std::size_t missing = kFrame - frame_.size(), count = size < missing ? size : missing;
  frame_.append(bytes, count);
  if (frame_.size() < kFrame || is_tail(frame_[kFrame - 1])) return count;
  ++bad_frames_;
  if (++bad_now_ > kMostBad) frame_.drop(kFrame - 1);
  frame_.drop_to_next(kHead);
  return count;
}

std::uint16_t Sbus::channel(unsigned number) const {
  const unsigned at = 8 + 11 * (number - 1);
  const std::uint8_t* byte = last_ + at / 8;
  const std::uint32_t bits = byte[0] | std::uint32_t{byte[1]} << 8 | std::uint32_t{byte[2]} << 16;
  return static_cast<std::uint16_t>(bits >> at % 8 & 0x7FFU);
}

void Sbus::decode(std::size_t behind) {
  ++frames_;
  std::memcpy(last_, frame_.data(), sizeof last_);
  frame_.drop(kFrame);
  if (frame_lost() || failsafe()) return;
  state.right_x = scaled(channel(1));
  state.right_y = scaled(channel(2));
  state.left_y = scaled(channel(3));
  state.left_x = scaled(channel(4));
  state.left_switch = switch_of(channel(5));
  state.right_switch = switch_of(channel(6));
  state.wheel = scaled(channel(7));
  state.origin = uart_->arrival(behind) - uart_->wire_time(kFrame);
  state.valid = true;
}

}  // namespace finemote
