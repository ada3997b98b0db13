#include "emulator/chip/flash.hpp"

#include <cstring>

#include "emulator/core/memories.hpp"

namespace finemote::emulator {
namespace {

enum Offset : std::uint32_t { kAcr = 0x00, kKey = 0x04, kOptionKey = 0x08, kSr = 0x0C, kCr = 0x10, kOptcr = 0x14 };
// ACR: RM0090 3.9.1.
constexpr std::uint32_t kPrefetch = 1U << 8, kInstructionCache = 1U << 9;
// SR: RM0090 3.9.5.
constexpr std::uint32_t kEnd = 1, kOperationError = 2, kParallelismError = 64, kSequenceError = 128, kBusy = 1U << 16;
constexpr std::uint32_t kFlags = 0xF3;
// CR: 3.9.6.
constexpr std::uint32_t kProgram = 1, kSector = 2, kMass = 4, kStart = 1U << 16, kEndInterrupt = 1U << 24,
                        kErrorInterrupt = 1U << 25, kLocked = 1U << 31;
constexpr std::uint32_t kOptions = 0x0FFFAAEC, kOptionsLocked = 1;  // OPTCR after a reset without options: 3.9.7
constexpr int kLine = 4;                                            // RM0090 12.2, table 62

// Typical times with 32 bits at once: DS8626 5.3.12.
constexpr Time kProgramTime = from_ns(16'000), kSmallErase = from_ns(250'000'000), kMediumErase = from_ns(550'000'000),
               kLargeErase = from_ns(1'000'000'000), kMassErase = from_ns(8'000'000'000);

struct Sector {
  std::uint32_t offset, bytes;
  Time erase;
};

/// Four of 16 KiB, one of 64, seven of 128: RM0090 3.3, table 5.
constexpr Sector sector(unsigned number) {
  constexpr std::uint32_t kKib = 1024;
  if (number < 4) return {number * 16 * kKib, 16 * kKib, kSmallErase};
  if (number == 4) return {64 * kKib, 64 * kKib, kMediumErase};
  return {(number - 4) * 128 * kKib, 128 * kKib, kLargeErase};
}

}  // namespace

void Flash::Lock::give(std::uint32_t key) {
  if (spoilt_ || is_open()) return;
  spoilt_ = key != keys_[given_];
  given_ = spoilt_ ? 0 : given_ + 1;
}

void Flash::reset() {
  acr_ = sr_ = cr_ = 0;
  control_.reset();
  options_.reset();
  busy_until_ = 0;
  update();
}

/// Prefetch and the instruction cache together are the accelerator: each hides the wait states of straight code. 3.5.2.
void Flash::apply() { world_.cpu().set_flash((acr_ & (kPrefetch | kInstructionCache)) != 0, wait_states()); }

void Flash::update() {
  const bool end = (cr_ & kEndInterrupt) != 0 && (sr_ & kEnd) != 0;
  const bool error = (cr_ & kErrorInterrupt) != 0 && (sr_ & kOperationError) != 0;
  world_.set_line(kLine, end || error);
}

std::uint32_t Flash::read(std::uint32_t offset) {
  switch (offset) {
    case kAcr:
      return acr_;
    case kKey:
    case kOptionKey:
      return 0;
    case kSr:
      return sr_ | (is_busy() ? kBusy : 0);
    case kCr:
      return cr_ | (control_.is_open() ? 0 : kLocked);
    case kOptcr:
      return kOptions | (options_.is_open() ? 0 : kOptionsLocked);
    default:
      return unmodelled_read(offset);
  }
}

void Flash::write(std::uint32_t offset, std::uint32_t value) {
  switch (offset) {
    case kAcr:
      only(value, 0x1F07, "ACR");
      acr_ = value & 0x0707;
      return apply();
    case kKey:
      return control_.give(value);
    case kOptionKey:
      return options_.give(value);
    case kSr:
      sr_ &= ~(value & kFlags);
      return update();
    case kCr:
      return write_control(value);
    case kOptcr:
      if ((value & 2) != 0) world_.report(Misuse::unmodelled, name() + " option bytes are changed");
      if ((value & kOptionsLocked) != 0) options_.shut();
      return;
    default:
      return unmodelled_write(offset);
  }
}

/// ACR keeps its other bytes: words, halfwords and bytes are allowed, RM0090 3.9.1.
void Flash::write_part(std::uint32_t offset, std::uint32_t mask, std::uint32_t value) {
  if (offset != kAcr) return Peripheral::write_part(offset, mask, value);
  write(kAcr, (acr_ & ~mask) | value);
}

void Flash::write_control(std::uint32_t value) {
  if (!control_.is_open()) {
    world_.report(Misuse::protocol, name() + " CR is written while it is locked");
    return;
  }
  only(value, 0x83010000U | 0x37F, "CR");
  cr_ = value & 0x0300037F;
  if ((value & kLocked) != 0) control_.shut();
  if ((value & kStart) == 0) return update();
  if (is_busy() || (value & (kSector | kMass)) == 0) return refuse(kSequenceError);
  if ((value & kMass) != 0) return erase(0, Memories::kFlashBytes, kMassErase);
  const unsigned number = value >> 3 & 0xF;
  if (number > 11) return refuse(kSequenceError);
  const Sector it = sector(number);
  erase(it.offset, it.bytes, it.erase);
}

void Flash::erase(std::uint32_t from, std::uint32_t bytes, Time duration) {
  const std::uint32_t address = Memories::kFlashBase + from;
  std::memset(world_.cpu().memory(address, bytes), 0xFF, bytes);
  world_.cpu().flash_changed(address, bytes);
  work(duration);
}

void Flash::store(std::uint32_t address, unsigned bytes, std::uint32_t value) {
  if (!control_.is_open() || (cr_ & kProgram) == 0 || is_busy()) {
    world_.report(Misuse::protocol, name() + " is stored to without being set up for it");
    return refuse(kSequenceError);
  }
  if (bytes != 1U << (cr_ >> 8 & 3)) {
    world_.report(Misuse::protocol, name() + " is given another size than PSIZE says");
    return refuse(kParallelismError);
  }
  program(address, bytes, value);
}

/// Bits only go from 1 to 0.
void Flash::program(std::uint32_t address, unsigned bytes, std::uint32_t value) {
  std::uint8_t* cells = world_.cpu().memory(address, bytes);
  for (unsigned i = 0; i < bytes; ++i) cells[i] &= static_cast<std::uint8_t>(value >> (8 * i));
  world_.cpu().flash_changed(address, bytes);
  work(kProgramTime);
}

/// EOP comes only where its interrupt is wanted: 3.9.5.
void Flash::work(Time duration) {
  busy_until_ = world_.now() + duration;
  world_.at(busy_until_, [this, until = busy_until_] {
    if (until != busy_until_) return;  // reset meanwhile
    cr_ &= ~kStart;
    if ((cr_ & kEndInterrupt) != 0) sr_ |= kEnd;
    update();
  });
  world_.cpu().stall_in_flash(duration);
}

void Flash::refuse(std::uint32_t error) {
  sr_ |= error;
  if ((cr_ & kErrorInterrupt) != 0) sr_ |= kOperationError;
  update();
}

}  // namespace finemote::emulator
