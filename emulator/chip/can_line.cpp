#include "emulator/chip/can_line.hpp"

namespace finemote::emulator {
namespace {

/// Bits of a frame as they come: counts them, with their stuff bits, and forms the checksum.
class FrameBits {
 public:
  void put(std::uint32_t value, unsigned count) {
    for (unsigned i = count; i-- > 0;) put_bit(value >> i & 1);
  }
  [[nodiscard]] std::uint32_t crc() const { return crc_; }
  [[nodiscard]] unsigned count() const { return count_; }

 private:
  void put_bit(std::uint32_t bit) {
    crc_ = (crc_ << 1 & 0x7FFF) ^ (0x4599 & (0 - (bit ^ crc_ >> 14)));
    run_ = bit == last_ ? run_ + 1 : 1;
    last_ = bit;
    ++count_;
    if (run_ == 5) {  // a bit of the other kind follows, and begins a run itself
      ++count_;
      last_ = bit ^ 1;
      run_ = 1;
    }
  }

  std::uint32_t crc_ = 0, last_ = 1;
  unsigned run_ = 0, count_ = 0;
};

}  // namespace

unsigned can_frame_bits(const CanFrame& frame) {
  FrameBits bits;
  bits.put(0, 1);  // start, identifier, RTR, IDE, r0, length and data: what the checksum covers
  bits.put(frame.id, 11);
  bits.put(0, 3);
  bits.put(frame.size, 4);
  for (unsigned i = 0; i < frame.size; ++i) bits.put(frame.data[i], 8);
  bits.put(bits.crc(), 15);
  constexpr unsigned kTail = 1 + 2 + 7 + 3;  // CRC delimiter, acknowledge, end of frame, intermission
  return bits.count() + kTail;
}

/// All nodes that ask at the same time take part in the same arbitration.
void CanLine::request() {
  if (sender_ || asked_) return;
  asked_ = true;
  world_.after(bit_time(), [this] {
    asked_ = false;
    begin();
  });
}

void CanLine::begin() {
  if (sender_) return;
  std::optional<CanFrame> best;
  std::size_t sender = 0;
  for (std::size_t i = 0; i < reachable(); ++i) {
    const auto frame = nodes_[i].next ? nodes_[i].next() : std::nullopt;
    if (frame && (!best || frame->id < best->id)) {
      best = frame;
      sender = i;
    }
  }
  if (!best) return;
  sender_ = sender;
  const bool disturbed = disturbed_frames != 0;
  if (disturbed) --disturbed_frames;
  const CanOutcome outcome = disturbed          ? CanOutcome::destroyed
                             : reachable() == 1 ? CanOutcome::unacknowledged
                                                : CanOutcome::received;
  const bool ok = outcome == CanOutcome::received;
  // A destroyed frame ends in an error frame: on average half of it, 20 bits, and the intermission.
  const Time duration = (ok ? can_frame_bits(*best) : can_frame_bits(*best) / 2 + 23) * bit_time();
  statistics_.busy += duration;
  world_.after(duration, [this, sender, frame = *best, outcome] { end(sender, frame, outcome); });
}

void CanLine::end(std::size_t sender, const CanFrame& frame, CanOutcome outcome) {
  const bool ok = outcome == CanOutcome::received;
  sender_.reset();
  ended_at_ = world_.now();
  ok ? ++statistics_.transfers : ++statistics_.errors;
  if (ok) statistics_.bytes += frame.size;
  if (nodes_[sender].sent) nodes_[sender].sent(frame, outcome);
  for (std::size_t i = 0; i < reachable(); ++i) {
    if (ok && i != sender && nodes_[i].received) nodes_[i].received(frame);
  }
  begin();
}

}  // namespace finemote::emulator
