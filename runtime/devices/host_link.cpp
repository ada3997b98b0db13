#include "finemote/devices/host_link.hpp"

#include <cstring>

namespace finemote {

namespace {

/// Frames with a wrong sum whose bytes are looked at once more, in one update().
constexpr unsigned kMostRejected = 3;

/// Bytes that a frame begins with, always the same.
constexpr std::size_t kHeads = 2;

constexpr std::size_t size_of(LinkKind kind) {
  switch (kind) {
    case LinkKind::kBool:
    case LinkKind::kU8:
      return 1;
    case LinkKind::kI16:
    case LinkKind::kU16:
      return 2;
    case LinkKind::kI32:
    case LinkKind::kU32:
    case LinkKind::kF32:
      return 4;
    case LinkKind::kI64:
      return 8;
  }
  return 0;
}

/// Writes into a frame's payload. Both ends are little endian: the bytes of a value are those in memory.
class Writer {
 public:
  explicit Writer(std::uint8_t* bytes) : bytes_(bytes) {}
  void put(const void* value, std::size_t size) {
    if (size_ + size > link::kMaxPayload) return;  // cannot be: the generator cuts the blocks
    std::memcpy(bytes_ + size_, value, size);
    size_ += size;
  }
  void put(const Stamp& stamp) {
    const auto valid = static_cast<std::uint8_t>(stamp.valid ? 1 : 0);
    put(&stamp.origin, sizeof stamp.origin);
    put(&valid, 1);
  }
  [[nodiscard]] std::size_t size() const { return size_; }

 private:
  std::uint8_t* bytes_;
  std::size_t size_ = 0;
};

std::size_t size_of(const LinkTarget& target) {
  std::size_t size = 1;
  for (const LinkSlot& field : target.fields) size += size_of(field.kind);
  return size;
}

}  // namespace

// Half bytes at a time: 16 words of table instead of 256.
std::uint16_t link::crc(const std::uint8_t* bytes, std::size_t size) {
  constexpr std::uint16_t kTable[16] = {0x0000, 0x1021, 0x2042, 0x3063, 0x4084, 0x50A5, 0x60C6, 0x70E7,
                                        0x8108, 0x9129, 0xA14A, 0xB16B, 0xC18C, 0xD1AD, 0xE1CE, 0xF1EF};
  unsigned value = 0xFFFF;
  for (std::size_t i = 0; i < size; ++i) {
    value = (value << 4 ^ kTable[(value >> 12 ^ bytes[i] >> 4U) & 0xFU]) & 0xFFFFU;
    value = (value << 4 ^ kTable[(value >> 12 ^ bytes[i]) & 0xFU]) & 0xFFFFU;
  }
  return static_cast<std::uint16_t>(value);
}

void HostLink::update() {
  receive();
  send();
}

void HostLink::handle() {
  if (is_fresh(state, now(), config_.max_age)) return;
  state.valid = false;
  for (const LinkTarget& target : layout_->down) target.stamp.valid = false;
}

// --------------------------------------------------------------------------------------------------------------
// down

void HostLink::receive() {
  std::uint8_t bytes[64];
  rejected_now_ = 0;
  std::size_t size = sizeof bytes;
  for (std::size_t left = uart_->full_reads(sizeof bytes) + 1; size == sizeof bytes && left != 0; --left) {
    size = uart_->read(bytes, sizeof bytes);
    take(bytes, size);
  }
}

void HostLink::take(const std::uint8_t* bytes, std::size_t size) {
  for (std::size_t i = 0; i < size;) {
    if (in_.size() < kHeads) {
      in_.begin(bytes[i++], link::kFirst, link::kSecond);
    } else {
      const std::size_t missing = needed_ - in_.size(), count = size - i < missing ? size - i : missing;
      in_.append(bytes + i, count);
      i += count;
    }
    if (in_.size() < needed_) continue;
    behind_ = size - i;
    look();
  }
}

/// A broken beginning is left behind; every turn needs more bytes than there are, or drops one, so that this ends.
void HostLink::look() {
  do {
    needed_ = examine();
    if (needed_ == 0) {
      in_.drop_to_next(link::kFirst);
      needed_ = kHeads;
    } else if (needed_ <= in_.size()) {
      judge();
      needed_ = kHeads;
    }
  } while (in_.size() >= needed_);
}

/// How many bytes there must be to say more of what begins a frame, no more than there are for a whole one; 0 when this
/// is none.
std::size_t HostLink::examine() const {
  if (in_[0] != link::kFirst || in_[1] != link::kSecond) return 0;
  if (in_.size() < link::kHeader) return link::kHeader;
  return in_[3] <= link::kMaxPayload ? expected() : 0;
}

std::size_t HostLink::expected() const { return link::kHeader + in_[3] + link::kCrc; }

void HostLink::judge() {
  const std::size_t whole = expected(), end = whole - link::kCrc;
  const unsigned sent = in_[end] | static_cast<unsigned>(in_[end + 1]) << 8;
  if (link::crc(in_.data() + 2, end - 2) != sent) {
    ++state.rejected;
    // What looked like a beginning was none, or bytes were lost: the next frame may stand inside. Each that is looked
    // for there costs a sum over bytes that were summed before.
    if (++rejected_now_ <= kMostRejected)
      in_.drop_to_next(link::kFirst);
    else
      in_.drop(whole);
    return;
  }
  std::uint32_t layout = 0;
  std::memcpy(&layout, in_.data() + 4, sizeof layout);
  const std::uint8_t kind = in_[2] >> 4U, block = in_[2] & 0xFU;
  if (layout != layout_->number || kind != link::kCommands || block >= layout_->down_blocks) {
    ++state.mismatched;
  } else {
    apply(block);
  }
  in_.drop(whole);  // after a broken beginning more may stand behind
}

void HostLink::apply(std::uint8_t block) {
  std::size_t need = 0;
  for (const LinkTarget& target : layout_->down) need += target.block == block ? size_of(target) : 0;
  if (need != in_[3]) {
    ++state.mismatched;
    return;
  }
  const Time arrival = uart_->arrival(behind_ + in_.size() - expected()) - uart_->wire_time(expected());
  const std::uint8_t* from = in_.data() + link::kHeader;
  for (const LinkTarget& target : layout_->down) {
    if (target.block != block) continue;
    target.stamp.origin = arrival;
    target.stamp.valid = *from++ == 1;
    for (const LinkSlot& field : target.fields) {
      std::memcpy(field.to, from, size_of(field.kind));
      if (field.kind == LinkKind::kBool) *static_cast<bool*>(field.to) = *from == 1;
      from += size_of(field.kind);
    }
  }
  ++state.frames;
  state.origin = arrival;
  state.valid = true;
}

// --------------------------------------------------------------------------------------------------------------
// up

void HostLink::send() {
  const Time at = now();
  if (layout_->up_blocks == 0 || at < next_send_) return;
  std::uint8_t frame[link::kMaxFrame];
  Writer payload(frame + link::kHeader);
  payload.put(&at, sizeof at);
  for (const LinkSource& source : layout_->up) {
    if (source.block != block_) continue;
    payload.put(source.stamp);
    for (const LinkField& field : source.fields) payload.put(field.from, size_of(field.kind));
  }
  frame[0] = link::kFirst;
  frame[1] = link::kSecond;
  frame[2] = static_cast<std::uint8_t>(link::kStates << 4U | block_);
  frame[3] = static_cast<std::uint8_t>(payload.size());
  std::memcpy(frame + 4, &layout_->number, sizeof layout_->number);
  frame[8] = sequence_;
  const std::size_t end = link::kHeader + payload.size();
  const std::uint16_t check = link::crc(frame + 2, end - 2);
  frame[end] = static_cast<std::uint8_t>(check & 0xFFU);
  frame[end + 1] = static_cast<std::uint8_t>(check >> 8U);
  if (!uart_->write(frame, end + link::kCrc)) return;  // the last one is still under way: at the next update
  ++sequence_;
  ++state.sent;
  block_ = static_cast<std::uint8_t>(block_ + 1 < layout_->up_blocks ? block_ + 1 : 0);
  // Frames are due on a fixed grid: a job that starts a little sooner after its release than the last one misses none.
  next_send_ += config_.interval;
  if (next_send_ <= at) next_send_ = at - (at - next_send_) % config_.interval + config_.interval;
}

}  // namespace finemote
