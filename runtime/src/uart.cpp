#include "finemote/uart.hpp"

#include "finemote/fault.hpp"
#include "finemote/four_bytes.hpp"
#include "finemote/least.hpp"

namespace finemote {

namespace {

/// Of module uart.
enum UartFault : std::uint8_t { kReceiveHalted = 1, kBytesLost, kSendOverdue };

constexpr Duration kSendSlack = 1 * kMillisecond;
/// From the event of a silent line to what its routine leaves, where nothing more urgent runs.
constexpr Duration kEventSlack = 2 * kMicrosecond;

/// The clock of a sender that is understood is off by at most one part in 22, 4.5 %, RM0090 30.3.5: that part of 2^28,
/// rounded up, so that no time it is taken from stays too long. (Dividing 64 bits would cost an image 860 bytes.)
constexpr int kDeviationScale = 28;
constexpr std::int64_t kClockDeviation = ((std::int64_t{1} << kDeviationScale) + 21) / 22;

/// Start bit, data, parity, stop bits.
constexpr int bits_per_byte(UartFormat format) {
  switch (format) {
    case UartFormat::k8N1:
      return 10;
    case UartFormat::k8E1:
    case UartFormat::k8E1Inverted:
      return 11;
    case UartFormat::k8E2:
    case UartFormat::k8E2Inverted:
      return 12;
  }
  return 12;
}

/// Bytes of a ring from number `from` on. Four at a time where they lie at a multiple of four: the end is not among
/// them.
void copy(const UartRing ring, std::uint32_t from, std::uint8_t* out, std::uint32_t count) {
  const std::uint32_t mask = ring.size - 1;
  std::uint32_t i = 0;
  for (unsigned left = 3; left != 0 && i < count && (from + i) % 4 != 0; --left, ++i)
    out[i] = ring.bytes[(from + i) & mask];
  for (; i + 4 <= count; i += 4) move_four(ring.bytes + ((from + i) & mask), out + i);
  for (unsigned left = 3; left != 0 && i < count; --left, ++i) out[i] = ring.bytes[(from + i) & mask];
}

}  // namespace

void Uart::start() {
  list_bus(counters_);
  port_->start(baud_, format_, ring_);
  port_->allow_events(limits_.events);
}

std::size_t Uart::read(std::uint8_t* out, std::size_t capacity) {
  const std::size_t allowed = least(left_, limits_.bytes);  // left_ is more at the first read() alone
  const std::size_t size = take(out, least(capacity, allowed));
  left_ = static_cast<std::uint16_t>(allowed - size);
  if (size < capacity) {
    left_ = limits_.bytes;
    port_->allow_events(limits_.events);
  }
  return size;
}

bool Uart::quiet() {
  read_ = port_->received();
  left_ = kFirst;
  port_->allow_events(limits_.events);
  return !port_->transmitting();
}

std::size_t Uart::take(std::uint8_t* out, std::size_t capacity) {
  if (port_->receive_halted()) restart();

  const Time at = now();
  const UartSeen seen = port_->seen();
  count_line_errors();  // not before: what is seen may have come since
  idle_ = seen.idle;
  std::uint32_t available = seen.received - read_;
  if (left_ == kFirst && available > limits_.bytes) {  // since long ago: what came last is enough to begin with
    read_ += available - limits_.bytes;
    available = limits_.bytes;
  }
  if (available > ring_.size) {  // lapped: what is left is overwritten from its old end on, keep the newer half
    lose(available - ring_.size / 2);
    available = ring_.size / 2;
  }
  const auto size = static_cast<std::uint32_t>(available < capacity ? available : capacity);
  copy(ring_, read_, out, size);
  Shared<std::uint32_t>::fence();
  if (port_->received() - read_ > ring_.size) {  // lapped during the copy
    lose(size);
    return 0;
  }
  read_ += size;
  counters_.transfers += size != 0 ? 1 : 0;

  if (size == available) {
    if (seen_.received != read_) before_ = seen_;
    seen_ = {read_, at};
  }
  return size;
}

/// What came before is lost. Of what comes from here on is known that it was not there yet.
void Uart::restart() {
  count_fault(Module::uart, kReceiveHalted);
  ++counters_.recoveries;
  counters_.lost += port_->received() - read_;
  const Time at = now();
  read_ = port_->restart_receive();
  seen_ = before_ = {read_, at};
}

// Every byte takes its time on the wire, so the last of some came that much later than the line was seen without them;
// and where the line did not fall silent, they came close behind each other. The line may have fallen silent again
// since take() looked, behind bytes that are not read yet. All are times that are not later: the latest counts.
Time Uart::arrival(std::size_t behind) const {
  const std::uint32_t position = read_ - static_cast<std::uint32_t>(behind);
  const bool tells_silence = port_->tells_silence_after(position);
  const UartIdle idle = port_->idle();
  const Time known = latest(earliest(idle_, position), latest(earliest(seen_, position), earliest(before_, position)));
  if (idle.received == position) return latest(known, idle.at - wire_time(1));
  if (idle_.received == position) return latest(known, idle_.at - wire_time(1));
  const std::uint32_t more = seen_.received - position;
  const bool is_unbroken =
      tells_silence && more <= ring_.size && static_cast<std::int32_t>(idle_.received - position) < 0;
  return is_unbroken ? latest(known, seen_.at - longest_unseen(more)) : known;
}

Time Uart::began(std::size_t behind, std::size_t bytes) const { return arrival(behind) - longest(wire_time(bytes)); }

/// What takes the clock that is off the most so long, by its own.
Duration Uart::longest(Duration nominal) { return nominal + (nominal * kClockDeviation >> kDeviationScale) + 1; }

/// How long ago a byte came at most, behind which so many have, and no event has told of silence: the next one begins
/// within a byte's time, and is counted when it ends. By the clock that is off the most.
Duration Uart::longest_unseen(std::uint32_t behind) const { return longest(wire_time(2 * (behind + 1))) + kEventSlack; }

/// When the byte that ends at `position` can have arrived at the earliest, if the line had not brought it at `point`.
Time Uart::earliest(const UartIdle& point, std::uint32_t position) const {
  const std::uint32_t bytes = position - point.received;
  if (bytes == 0 || bytes > ring_.size) return kLongAgo;
  const Duration nominal = wire_time(bytes - 1);
  return point.at + nominal - (nominal * kClockDeviation >> kDeviationScale);
}

void Uart::lose(std::uint32_t bytes) {
  read_ += bytes;
  counters_.lost += bytes;
  count_fault(Module::uart, kBytesLost);
}

bool Uart::write(const std::uint8_t* bytes, std::size_t size) {
  if (size == 0 || size > capacity()) return false;
  const Time at = now();  // before the look: where this is preempted for long, what ends meanwhile is not overdue
  if (port_->transmitting()) {
    if (at <= send_deadline_) return false;
    count_fault(Module::uart, kSendOverdue);
    ++counters_.overdue;
    ++counters_.errors;
    port_->abort_transmit();
  }
  std::uint8_t* buffer = port_->transmit_buffer();
  move_bytes(bytes, buffer, size);
  port_->transmit(size);
  send_deadline_ = now() + 2 * wire_time(size) + kSendSlack;  // not before, where it may be kept waiting for long
  ++counters_.transfers;
  return true;
}

bool Uart::idle() const { return idle_.received == read_ || port_->idle().received == read_; }

std::size_t Uart::since_silence() const {
  const std::uint32_t now_silent = read_ - port_->idle().received;
  const bool is_read = static_cast<std::int32_t>(now_silent) >= 0;  // else it lies behind bytes that are not read yet
  return is_read ? now_silent : read_ - idle_.received;
}

Duration Uart::wire_time(std::size_t bytes) const {
  return static_cast<Duration>(bytes) * bits_per_byte(format_) * bit_time_;
}

void Uart::count_line_errors() {
  const UartErrors errors = port_->errors();
  const std::uint32_t sum = errors.framing + errors.noise + errors.parity + errors.overrun;
  counters_.errors += sum - line_errors_;
  line_errors_ = sum;
}

}  // namespace finemote
