// What lies behind an address for the processor: its memories, an image in flash, aliases, peripherals and itself.
#include <cstring>
#include <stdexcept>
#include <tuple>

#include "emulator/core/address_map.hpp"
#include "emulator/core/bit_band.hpp"
#include "emulator/core/cpu.hpp"
#include "emulator/core/word_text.hpp"

namespace finemote::emulator {
namespace {

/// How long an access to the private peripheral bus waits beyond the instruction: the TRM gives no figure. Assumed.
constexpr unsigned kPrivateBusWait = 2;

/// MPU_CTRL to its last alias of MPU_RASR: PM0214 4.2.
bool is_protection(std::uint32_t address) { return lies_in(address, 0xE000ED94, 0x28); }

/// Its size where it is elsewhere.
std::uint32_t flash_offset(std::uint32_t physical) {
  const std::uint32_t offset = physical - Memories::kFlashBase;
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
  denied_ = !is_system(address) && !system_.mpu().may_write(address);
  if (denied_) return false;
  if (is_peripheral(address)) {
    tags_.give_stored();
    bus_.write(address, bytes, value);
    after_access();
    return true;
  }
  if (is_system(address)) {
    add_wait(kPrivateBusWait);
    system_.write(address, bytes, value, now(), pc());
    if (is_protection(address)) look_at_memory();
    after_core_access();
    return true;
  }
  const std::uint32_t place = core_.physical(address);
  if (const std::uint32_t offset = flash_offset(place); offset < Memories::kFlashBytes) {
    bus_.store_to_flash(Memories::kFlashBase + offset, bytes, value);
    after_access();
    return true;
  }
  if (std::uint8_t* ram = memory(place, bytes)) {
    std::memcpy(ram, &value, bytes);
    ram_changed(place, bytes);
    return true;
  }
  return access_alias(address, bytes, &value, value);
}

/// A word of a bit-band alias reads as its bit; written, it changes that bit of what is there.
/// @param written  null: it is read into `value`
bool Cpu::access_alias(std::uint32_t address, unsigned bytes, const std::uint32_t* written, std::uint32_t& value) {
  const auto place = banded_bit(address, bytes);
  if (!place) return false;
  const std::uint8_t* ram = memory(place->address, bytes);
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
  return write(place->address, bytes, word);
}

/// A register of the core may have changed what the core does next.
void Cpu::after_core_access() {
  std::tie(guard_begin_, guard_end_) = system_.mpu().guard();
  core_.stack_alarm = guard_end_;
  core_.fpu_on = system_.fpu_enabled();
  core_.traps_unaligned = system_.traps_unaligned();
  after_access();
}

bool Cpu::may_execute(std::uint32_t address) { return system_.mpu().may_execute(address); }

void Cpu::map_ram_to_zero(bool on) {
  ram_at_zero_ = on;
  look_at_memory();
}

void Cpu::look_at_memory() {
  const Mpu& mpu = system_.mpu();
  core_.see({ram_at_zero_, mpu.may_execute(0, ram_at_zero_ ? Memories::kMainRamBytes : Memories::kFlashBytes),
             mpu.may_execute(Memories::kFlashBase, Memories::kFlashBytes),
             mpu.end_of_protected(Memories::kRamBase, Memories::kRamBytes) - Memories::kRamBase});
  kick();
}

void Cpu::stall_in_flash(Time duration) {
  if (flash_offset(core_.physical(pc())) < Memories::kFlashBytes) core_.pace.time += duration;
}

std::uint8_t* Cpu::memory(std::uint32_t address, std::uint32_t bytes) {
  const auto inside = [&](std::vector<std::uint8_t>& area, std::uint32_t base) -> std::uint8_t* {
    const std::uint64_t offset = std::uint64_t{address} - base;
    return address >= base && offset + bytes <= area.size() ? area.data() + offset : nullptr;
  };
  address = core_.physical(address);
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
  const std::uint8_t* p = memory(system_.vector_table() + 4 * static_cast<std::uint32_t>(exception), 4);
  std::uint32_t value = 0;
  if (p != nullptr) std::memcpy(&value, p, 4);
  return value;
}

}  // namespace finemote::emulator
