// The processor's memories: what lies behind an address, and an image in flash.
#include <cstring>
#include <stdexcept>

#include "emulator/core/cpu.hpp"
#include "emulator/word_text.hpp"

namespace finemote::emulator {

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
