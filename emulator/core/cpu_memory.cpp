// What lies behind an address for the processor: its memories, an image in flash, aliases, peripherals and itself.
#include <cstring>
#include <stdexcept>
#include <tuple>

#include "emulator/core/address_map.hpp"
#include "emulator/core/bit_band.hpp"
#include "emulator/core/cpu.hpp"
#include "emulator/word_text.hpp"

namespace finemote::emulator {
namespace {

/// An access to the private peripheral bus waits so long beyond the instruction: the TRM gives no figure. Assumed.
constexpr unsigned kPrivateBusWait = 2;

/// In flash, which stands at 0 as well; its size where it is elsewhere.
std::uint32_t flash_offset(std::uint32_t address) {
  const std::uint32_t offset = address < Memories::kFlashBytes ? address : address - Memories::kFlashBase;
  return offset < Memories::kFlashBytes ? offset : Memories::kFlashBytes;
}

}  // namespace

bool Cpu::read(std::uint32_t address, unsigned bytes, std::uint32_t& value) {
  if (is_peripheral(address)) {
    value = bus_.read(address, bytes);
    tags_.take_answer(bytes, now());
    after_access();
    return true;
  }
  if (is_system(address)) {
    add_wait(kPrivateBusWait);
    value = system_.read(address, bytes, now(), pc());
    return true;
  }
  return access_alias(address, bytes, nullptr, value);
}

bool Cpu::write(std::uint32_t address, unsigned bytes, std::uint32_t value) {
  if (is_peripheral(address)) {
    tags_.give_stored();
    bus_.write(address, bytes, value);
    after_access();
    return true;
  }
  if (is_system(address)) {
    add_wait(kPrivateBusWait);
    system_.write(address, bytes, value, now(), pc());
    after_core_access();
    return true;
  }
  if (const std::uint32_t offset = flash_offset(address); offset < Memories::kFlashBytes) {
    bus_.store_to_flash(Memories::kFlashBase + offset, bytes, value);
    after_access();
    return true;
  }
  return access_alias(address, bytes, &value, value);
}

/// A word of a bit-band alias reads as its bit; written, it changes that bit of what is there.
/// @param written  null: it is read into `value`
bool Cpu::access_alias(std::uint32_t address, unsigned bytes, const std::uint32_t* written, std::uint32_t& value) {
  const auto place = banded_bit(address, bytes);
  if (!place) return false;
  std::uint8_t* ram = memory(place->address, bytes);
  std::uint32_t word = 0;
  if (ram != nullptr) {
    std::memcpy(&word, ram, bytes);
  } else if (!is_peripheral(place->address) || !read(place->address, bytes, word)) {
    return false;
  }
  if (written == nullptr) {
    value = word >> place->bit & 1;
    return true;
  }
  word = (word & ~(1U << place->bit)) | (*written & 1) << place->bit;
  if (ram == nullptr) return write(place->address, bytes, word);
  std::memcpy(ram, &word, bytes);
  return true;
}

/// A register of the core may have changed what the core does next.
void Cpu::after_core_access() {
  std::tie(guard_begin_, guard_end_) = system_.guard();
  core_.stack_alarm = lowest_stack_ > guard_end_ ? lowest_stack_ : guard_end_;
  core_.fpu_on = system_.fpu_enabled();
  after_access();
}

void Cpu::stall_in_flash(Time duration) {
  if (flash_offset(pc()) < Memories::kFlashBytes) core_.pace.time += duration;
}

std::uint8_t* Cpu::memory(std::uint32_t address, std::uint32_t bytes) {
  const auto inside = [&](std::vector<std::uint8_t>& area, std::uint32_t base) -> std::uint8_t* {
    const std::uint64_t offset = std::uint64_t{address} - base;
    return address >= base && offset + bytes <= area.size() ? area.data() + offset : nullptr;
  };
  if (std::uint8_t* p = inside(ram_, Memories::kRamBase)) return p;
  if (std::uint8_t* p = inside(core_ram_, Memories::kCoreRamBase)) return p;
  return inside(flash_, Memories::kFlashBase);
}

void Cpu::load(const Image& image) {
  std::uint32_t used = 0;
  for (const Segment& segment : image.segments) {
    const std::uint64_t offset = std::uint64_t{segment.address} - Memories::kFlashBase;
    if (segment.address < Memories::kFlashBase || offset + segment.bytes.size() > flash_.size())
      throw std::runtime_error("a segment at " + hex(segment.address) + " lies outside the flash");
    std::memcpy(flash_.data() + offset, segment.bytes.data(), segment.bytes.size());
    const auto end = static_cast<std::uint32_t>(offset + segment.bytes.size());
    if (end > used) used = end;
  }
  core_.take_apart_flash(used);
}

std::uint32_t Cpu::vector(int exception) {
  std::uint32_t base = system_.vector_table();
  if (base < Memories::kFlashBytes) base += Memories::kFlashBase;  // boot alias
  const std::uint8_t* p = memory(base + 4 * static_cast<std::uint32_t>(exception), 4);
  std::uint32_t value = 0;
  if (p != nullptr) std::memcpy(&value, p, 4);
  return value;
}

}  // namespace finemote::emulator
