#include "finemote/devices/sbus.hpp"

#include <cstring>

#include "finemote/control/numbers.hpp"
#include "little_endian.hpp"

namespace finemote {

namespace {

constexpr std::uint8_t kHead = 0x0F, kTail = 0x00;
/// S.BUS2: the group of telemetry slots that follows stands in bits 4 and 5.
constexpr std::uint8_t kSlotTail = 0x04, kSlotGroup = 0x30;
constexpr std::size_t kSlot = 3;  ///< bytes
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
  uart_->read_all(recent_.room(), Uart::kChunk, [&](std::size_t size) {
    if (gaps() != before) recent_.drop();  // what is kept lies before the gap
    if (!is_damaged()) return look(size);
    ++bad_frames_;
    recent_.drop();
  });
  if (!is_fresh(state, now(), kMaxAge)) state.valid = false;
}

std::uint32_t Sbus::gaps() const { return uart_->counters().lost + uart_->counters().recoveries; }

bool Sbus::is_damaged() {
  const std::uint32_t before = line_errors_;
  line_errors_ = uart_->counters().errors;
  return line_errors_ != before;
}

// A whole frame waits for the silence behind it, which tells when it came, or for the first byte of the next one.
// Nothing else tells data that look like a frame: one ends whole frames before or behind the last silence.
void Sbus::look(std::size_t size) {
  const std::uint8_t* const begin = recent_.begin();
  const std::size_t count = recent_.kept() + size;
  const bool is_silent = uart_->idle();
  const std::size_t since = uart_->since_silence(), silence = since <= count ? count - since : 0;
  const std::uint8_t *last = nullptr, *good = nullptr;
  std::size_t at = 0, judged = 0;
  while (at + kFrame <= count) {
    const std::uint8_t* const frame = begin + at;
    if (frame[0] != kHead) {
      ++at;
    } else if (is_tail(frame[kFrame - 1]) && at + kFrame == count && !is_silent) {
      break;
    } else if (!is_tail(frame[kFrame - 1]) || !is_apart(frame, silence > at ? silence - at : 0)) {
      if (at >= judged) {  // one of many that overlap is counted
        ++bad_frames_;
        judged = at + kFrame;
      }
      ++at;
    } else {
      ++frames_;
      last = frame;
      if (at + kFrame == silence) has_slots_ = frame[kFrame - 1] != kTail;
      if ((frame[kFlagsAt] & (kFrameLost | kFailsafe)) == 0) good = frame;
      at += kFrame;
    }
  }
  if (good != nullptr) decode(good, static_cast<std::size_t>(begin + count - good) - kFrame);
  if (last != nullptr) std::memcpy(last_, last, sizeof last_);
  recent_.keep(begin + at, size);
}

/// False where these bytes only look like a frame: the line fell silent within them, or they overlap a frame that ends
/// at the last silence, but for the slots of three bytes that a receiver with telemetry puts between.
/// @param silence  bytes from their begin to there; 0: it is not behind the begin
bool Sbus::is_apart(const std::uint8_t* frame, std::size_t silence) const {
  if (silence == 0 || silence == kFrame || silence >= 2 * kFrame) return true;
  if (silence < kFrame) return false;
  const std::size_t overlap = silence - kFrame;
  const std::uint8_t* const last = frame + overlap;
  return last[0] != kHead || !is_tail(last[kFrame - 1]) || (has_slots_ && overlap % kSlot == 0);
}

std::uint16_t Sbus::channel(unsigned number) const { return eleven_bits_at(last_, 8 + 11 * (number - 1)); }

void Sbus::decode(const std::uint8_t* frame, std::size_t behind) {
  std::memcpy(last_, frame, sizeof last_);
  state.right_x = scaled(channel(1));
  state.right_y = scaled(channel(2));
  state.left_y = scaled(channel(3));
  state.left_x = scaled(channel(4));
  state.left_switch = switch_of(channel(5));
  state.right_switch = switch_of(channel(6));
  state.wheel = scaled(channel(7));
  state.origin = uart_->began(behind, kFrame);
  state.valid = true;
}

}  // namespace finemote
