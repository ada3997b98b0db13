#include "finemote/devices/sbus.hpp"

#include <cstring>

#include "finemote/control/pid.hpp"

namespace finemote {

namespace {

constexpr std::uint8_t kHead = 0x0F, kTail = 0x00;
constexpr int kCentre = 992;
constexpr float kScale = 1.0F / 820;  ///< 172..1811 is -1..1

float scaled(std::uint16_t channel) { return clamp(static_cast<float>(channel - kCentre) * kScale, -1, 1); }

RemoteSwitch switch_of(std::uint16_t channel) {
  if (channel < kCentre - 400) return RemoteSwitch::kUp;
  return channel > kCentre + 400 ? RemoteSwitch::kDown : RemoteSwitch::kMiddle;
}

}  // namespace

void Sbus::update() {
  const std::uint32_t before = gaps();
  std::uint8_t bytes[32];
  for (std::size_t size = sizeof bytes, turns = 0; size == sizeof bytes && turns < 8; ++turns) {
    size = uart_->read(bytes, sizeof bytes);
    if (gaps() != before) size_ = 0;  // what is kept lies before the gap
    for (std::size_t i = 0; i < size; ++i) take(bytes[i], size - 1 - i);
  }
  if (size_ == kFrame && uart_->idle()) decode(0);
  if (!is_fresh(state, now(), kMaxAge)) state.valid = false;
}

std::uint32_t Sbus::gaps() const { return uart_->counters().lost + uart_->counters().recoveries; }

// A whole frame waits for the silence behind it, which tells when it came, or for the first byte of the next one.
void Sbus::take(std::uint8_t byte, std::size_t behind) {
  if (size_ == kFrame) decode(behind + 1);
  frame_[size_++] = byte;
  while (size_ != 0 && (frame_[0] != kHead || (size_ == kFrame && frame_[kFrame - 1] != kTail))) resynchronise();
}

void Sbus::resynchronise() {
  bad_frames_ += size_ == kFrame ? 1 : 0;
  std::size_t from = 1;
  while (from < size_ && frame_[from] != kHead) ++from;
  size_ -= from;
  std::memmove(frame_, frame_ + from, size_);
}

std::uint16_t Sbus::channel(unsigned number) const {
  const unsigned at = 8 + 11 * (number - 1);
  const std::uint8_t* byte = last_ + at / 8;
  const std::uint32_t bits = byte[0] | std::uint32_t{byte[1]} << 8 | std::uint32_t{byte[2]} << 16;
  return static_cast<std::uint16_t>(bits >> at % 8 & 0x7FFU);
}

void Sbus::decode(std::size_t behind) {
  size_ = 0;
  ++frames_;
  std::memcpy(last_, frame_, sizeof last_);
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
