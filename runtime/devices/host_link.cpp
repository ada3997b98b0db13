#include "finemote/devices/host_link.hpp"

#include "finemote/least.hpp"
#include "finemote/loop_bound.hpp"
#include "frame_heads.hpp"
#include "little_endian.hpp"

namespace finemote {

namespace {

/// Places that look like the begin of a frame and are none: inside so many of them a read looks for a better one.
constexpr unsigned kMostRejected = 1;

/// Bytes that a frame begins with, always the same.
constexpr std::size_t kHeads = 2;

/// Fields of a frame.
constexpr std::size_t kKindAt = 2, kSizeAt = 3, kLayoutAt = 4, kSequenceAt = 8;

/// Byte by byte: the sizes are small, and the places aligned to nothing.
void copy(const void* from, std::uint8_t* to, std::size_t size) {
  const auto* bytes = static_cast<const std::uint8_t*>(from);
  for (; size != 0; --size) {
    as_counted(size);
    *to++ = *bytes++;
  }
}

/// A sum goes on with a byte. x is what the division by the polynomial leaves of the highest eight bits: x^12 + x^5 + 1
/// times them and their upper half.
[[gnu::always_inline]] inline std::uint32_t with_byte(std::uint32_t sum, std::uint8_t byte) {
  std::uint32_t x = sum >> 8 ^ byte;
  x ^= x >> 4;
  return (sum << 8 ^ x << 12 ^ x << 5 ^ x) & 0xFFFFU;
}

/// Whether the sum behind `payload` bytes is right. It says so of the bytes from the kind on.
bool is_intact(const std::uint8_t* frame, std::size_t payload) {
  const std::uint8_t* const end = frame + link::kHeader + payload;
  const std::uint16_t sent = uint16_at(end);
  return link::crc(frame + kHeads, link::kHeader - kHeads + payload) == sent;
}

}  // namespace

std::uint16_t link::crc(const std::uint8_t* bytes, std::size_t size) {
  std::uint32_t value = 0xFFFF;
  for (std::size_t pairs = size / 2; pairs != 0; --pairs) {
    as_counted(pairs);
    value = with_byte(value, *bytes++);
    value = with_byte(value, *bytes++);
  }
  if (size % 2 != 0) value = with_byte(value, *bytes);
  return static_cast<std::uint16_t>(value);
}

void HostLink::update() {
  receive();
  drop_old();  // also what came before the first release, whose time is unknown
  send();
}

void HostLink::handle() { drop_old(); }

void HostLink::drop_old() {
  if (is_fresh(state, now(), max_age_)) return;
  state.valid = false;
  for (const LinkTarget& target : layout_.down) target.stamp.valid = false;
}

// --------------------------------------------------------------------------------------------------------------
// down

struct HostLink::Found {
  const std::uint8_t* latest[link::kMaxBlocks]{};  ///< the last good frame of each block
  const std::uint8_t* last = nullptr;              ///< the last of all
  const std::uint8_t* foreign = nullptr;           ///< the last whole one that no sum was made of
};

void HostLink::receive() {
  uart_.read_all(recent_.room(), Uart::kChunk, [this](std::size_t size) { recent_.keep(look(size), size); });
}

/// Takes what the frames in what is kept and `size` bytes more say. Returns the first byte that may still begin one.
const std::uint8_t* HostLink::look(std::size_t size) {
  const std::uint8_t* const begin = recent_.begin();
  const std::uint8_t* const end = recent_.room() + size;
  const std::size_t count = recent_.kept() + size;
  Found found;
  const std::size_t decided = find(begin, count, found);
  if (found.foreign != nullptr) judge_foreign(found.foreign);
  if (found.last == nullptr) return begin + decided;
  const auto arrival_of = [&](const std::uint8_t* frame) {
    const std::size_t whole = link::kHeader + frame[kSizeAt] + link::kCrc;
    return uart_.began(static_cast<std::size_t>(end - frame) - whole, whole);
  };
  for (std::uint8_t block = 0; block < layout_.down_blocks; ++block) {
    const std::uint8_t* const frame = found.latest[block];
    if (frame != nullptr) apply(block, frame + link::kHeader, arrival_of(frame));
  }
  state.origin = arrival_of(found.last);
  state.valid = true;
  return begin + decided;
}

/// Frames that fill what one read has brought, and places that are none.
unsigned HostLink::most_frames() const {
  const std::size_t bytes = uart_.most_in_chunk() + link::kMaxFrame;
  return static_cast<unsigned>(bytes / (link::kHeader + sizes_.smallest + link::kCrc)) + kMostRejected;
}

/// Goes from one place at which a frame may begin to the next: behind a good one, else to the next inside, for what
/// looked like a beginning was none, or bytes were lost. Where too many look like it, inside no more: then every byte
/// is summed once, whatever the line brings. Returns how many bytes are decided.
std::size_t HostLink::find(const std::uint8_t* begin, std::size_t count, Found& found) {
  const FrameHeads<kMostBytes> heads(begin, count, link::kFirst, link::kSecond);
  std::size_t at = 0;
  unsigned doubts = 0;
  for (unsigned left = most_frames(); left != 0; --left) {
    at = heads.next(at);
    if (at >= count) return count;
    const std::uint8_t* const frame = begin + at;
    if (count - at < link::kHeader) return at;
    const std::size_t payload = frame[kSizeAt], whole = link::kHeader + payload + link::kCrc;
    if (payload <= link::kMaxPayload && count - at < whole) return at;
    at += kHeads;
    if (payload > link::kMaxPayload) continue;
    if (!is_ours(frame)) {
      found.foreign = frame;
    } else if (is_intact(frame, least(payload, sizes_.largest))) {
      found.latest[frame[kKindAt] % link::kMaxBlocks] = found.last = frame;
      ++state.frames;
      at += whole - kHeads;
    } else {
      ++state.rejected;
      if (++doubts > kMostRejected) at += whole - kHeads;
    }
  }
  return at;
}

bool HostLink::is_ours(const std::uint8_t* frame) const {
  const unsigned kind = frame[kKindAt] >> 4U, block = frame[kKindAt] % link::kMaxBlocks;
  return four_bytes(frame + kLayoutAt) == layout_.number && kind == link::kCommands && block < layout_.down_blocks &&
         frame[kSizeAt] == sizes_.of[block];
}

/// A sum may be as long as the longest frame there is, so that one is made of these and no more.
void HostLink::judge_foreign(const std::uint8_t* frame) {
  ++(is_intact(frame, least(frame[kSizeAt], link::kMaxPayload)) ? state.mismatched : state.rejected);
}

void HostLink::apply(std::uint8_t block, const std::uint8_t* from, Time arrival) {
  for (const LinkTarget& target : layout_.down) {
    if (target.block != block) continue;
    target.stamp.origin = arrival;
    target.stamp.valid = *from++ == 1;
    for (const LinkSlot& field : target.fields) {
      const std::size_t size = link::size_of(field.kind);
      if (field.kind == LinkKind::kBool)
        *static_cast<bool*>(field.to) = *from == 1;
      else
        copy(from, static_cast<std::uint8_t*>(field.to), size);
      from += size;
    }
  }
}

// --------------------------------------------------------------------------------------------------------------
// up

/// Writes the block whose turn it is; returns its size.
std::size_t HostLink::fill(std::uint8_t* payload, Time at) const {
  copy(&at, payload, sizeof at);
  std::size_t size = sizeof at;
  for (const LinkSource& source : layout_.up) {
    if (source.block != block_) continue;
    copy(&source.stamp.origin, payload + size, sizeof source.stamp.origin);
    size += sizeof source.stamp.origin;
    payload[size++] = source.stamp.valid ? 1 : 0;
    for (const LinkField& field : source.fields) {
      copy(field.from, payload + size, link::size_of(field.kind));
      size += link::size_of(field.kind);
    }
  }
  return least(size, link::kMaxPayload);  // never more, for the generator cuts the blocks: only this line tells tools
}

void HostLink::send() {
  const Time at = now();
  if (layout_.up_blocks == 0 || at < next_send_) return;
  std::uint8_t frame[link::kMaxFrame];
  const std::size_t payload = fill(frame + link::kHeader, at);
  frame[0] = link::kFirst;
  frame[1] = link::kSecond;
  frame[kKindAt] = static_cast<std::uint8_t>(link::kStates << 4U | block_);
  frame[kSizeAt] = static_cast<std::uint8_t>(payload);
  put_uint32(layout_.number, frame + kLayoutAt);
  frame[kSequenceAt] = sequence_;
  const std::size_t end = link::kHeader + payload;
  put_uint16(link::crc(frame + kHeads, end - kHeads), frame + end);
  if (!uart_.write(frame, end + link::kCrc)) return;  // the last one is still under way: at the next update
  ++sequence_;
  ++state.sent;
  block_ = static_cast<std::uint8_t>(block_ + 1 < layout_.up_blocks ? block_ + 1 : 0);
  // Frames are due on a fixed grid: a job that starts a little sooner after its release than the last one misses none.
  next_send_ += interval_;
  if (next_send_ <= at) next_send_ = at - (at - next_send_) % interval_ + interval_;
}

}  // namespace finemote
