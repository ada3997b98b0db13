#include "emulator/chip/can_line.hpp"

namespace finemote::emulator {
namespace {

/// Start, identifier, RTR, IDE, r0, length and data: what the checksum covers.
std::vector<bool> covered_bits(const CanFrame& frame) {
  std::vector<bool> bits;
  const auto put = [&bits](std::uint32_t value, unsigned count) {
    for (unsigned i = count; i-- > 0;) bits.push_back((value >> i & 1) != 0);
  };
  put(0, 1);
  put(frame.id, 11);
  put(0, 3);
  put(frame.size, 4);
  for (unsigned i = 0; i < frame.size; ++i) put(frame.data[i], 8);
  return bits;
}

std::uint32_t crc15(const std::vector<bool>& bits) {
  std::uint32_t crc = 0;
  for (const bool bit : bits) {
    const bool invert = bit != ((crc >> 14 & 1) != 0);
    crc = crc << 1 & 0x7FFF;
    if (invert) crc ^= 0x4599;
  }
  return crc;
}

}  // namespace

unsigned can_frame_bits(const CanFrame& frame) {
  std::vector<bool> bits = covered_bits(frame);
  const std::uint32_t crc = crc15(bits);
  for (unsigned i = 15; i-- > 0;) bits.push_back((crc >> i & 1) != 0);
  unsigned stuffed = 0, run = 0;
  bool last = true;
  for (const bool bit : bits) {
    run = bit == last ? run + 1 : 1;
    last = bit;
    if (run == 5) {  // a bit of the other kind follows, and begins a run itself
      ++stuffed;
      last = !bit;
      run = 1;
    }
  }
  constexpr unsigned kTail = 1 + 2 + 7 + 3;  // CRC delimiter, acknowledge, end of frame, intermission
  return static_cast<unsigned>(bits.size()) + stuffed + kTail;
}

/// All nodes that ask at the same time take part in the same arbitration.
void CanLine::request() {
  if (busy_ || asked_) return;
  asked_ = true;
  world_.after(bit_time(), [this] {
    asked_ = false;
    begin();
  });
}

void CanLine::begin() {
  if (busy_) return;
  std::optional<CanFrame> best;
  std::size_t sender = 0;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const auto frame = nodes_[i].next ? nodes_[i].next() : std::nullopt;
    if (frame && (!best || frame->id < best->id)) {
      best = frame;
      sender = i;
    }
  }
  if (!best) return;
  busy_ = true;
  const bool disturbed = disturbed_frames != 0;
  if (disturbed) --disturbed_frames;
  const bool ok = !disturbed && nodes_.size() > 1;  // alone nobody acknowledges
  // A destroyed frame ends in an error frame: on average half of it, 20 bits, and the intermission.
  const Time duration = (ok ? can_frame_bits(*best) : can_frame_bits(*best) / 2 + 23) * bit_time();
  statistics_.busy += duration;
  world_.after(duration, [this, sender, frame = *best, ok] { end(sender, frame, ok); });
}

void CanLine::end(std::size_t sender, const CanFrame& frame, bool ok) {
  busy_ = false;
  ok ? ++statistics_.transfers : ++statistics_.errors;
  if (ok) statistics_.bytes += frame.size;
  if (nodes_[sender].sent) nodes_[sender].sent(frame, ok);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (ok && i != sender && nodes_[i].received) nodes_[i].received(frame);
  }
  begin();
}

}  // namespace finemote::emulator
