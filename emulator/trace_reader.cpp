#include "emulator/trace_reader.hpp"

#include <cstring>

#include "emulator/firmware_clock.hpp"

namespace finemote::emulator {
namespace {

// RTT control block: identifier, two counts, then name, buffer, size, write, read and flags of the first buffer.
constexpr std::uint32_t kBuffer = 28, kSize = 32, kWrite = 36, kRead = 40, kLost = 48, kBlockBytes = 52;
constexpr std::uint32_t kEntry = 8;  // bytes of the ring: stamp, code
constexpr char kIdentifier[16] = "SEGGER RTT";
constexpr Time kPollEvery = from_ns(100'000);

}  // namespace

TraceReader::TraceReader(World& world, const Image& image) : world_(world) {
  const auto symbol = image.symbol("_SEGGER_RTT");
  if (!symbol) return;
  control_ = symbol->address;
  poll();
}

void TraceReader::poll() {
  drain();
  world_.after(kPollEvery, [this] { poll(); });
}

std::uint32_t TraceReader::word(std::uint32_t address) const {
  std::uint32_t value = 0;
  if (const std::uint8_t* p = world_.cpu().memory(address, 4)) std::memcpy(&value, p, 4);
  return value;
}

std::uint32_t TraceReader::lost() const { return control_ ? word(*control_ + kLost) : 0; }

void TraceReader::restarted() {
  drain();
  begins_ = true;
}

/// When the cycle counter stood at 0, in cycles since power-on.
std::int64_t TraceReader::clock_began() const {
  const std::int64_t counter = world_.system().read(kCycleCounter, 4, world_.now(), 0);
  return static_cast<std::int64_t>(world_.now() / period_of(kFirmwareHz)) - counter;
}

void TraceReader::drain() {
  if (!control_) return;
  std::uint8_t* block = world_.cpu().memory(*control_, kBlockBytes);
  if (block == nullptr || std::memcmp(block, kIdentifier, sizeof kIdentifier) != 0) return;  // not initialised yet
  const std::uint32_t buffer = word(*control_ + kBuffer), size = word(*control_ + kSize),
                      end = word(*control_ + kWrite);
  std::uint32_t at = word(*control_ + kRead);
  if (size == 0 || at >= size || end >= size) return;
  // While the start fills the block its identifier may be there already, and the rest be what power-on has left.
  if (size % kEntry != 0 || at % kEntry != 0 || end % kEntry != 0) return;
  if (world_.cpu().memory(buffer, size) == nullptr) return;
  if (at != end && begins_) {
    begins_ = false;
    cycles_ = 0;
    if (!zero_) zero_ = clock_began();
    offset_ = clock_began() - *zero_;
  }
  for (; at != end; at = at + kEntry == size ? 0 : at + kEntry) {
    const std::uint32_t stamp = word(buffer + at), code = word(buffer + at + 4);
    // The first stamps may lie before the first release; later ones are less than 2^31 cycles apart.
    cycles_ += static_cast<std::int32_t>(stamp - static_cast<std::uint32_t>(cycles_));
    events_.push_back(StageEvent{cycles_to_ns(offset_ + cycles_), code / 2, code % 2 == 0});
  }
  std::memcpy(block + kRead, &at, 4);
}

}  // namespace finemote::emulator
