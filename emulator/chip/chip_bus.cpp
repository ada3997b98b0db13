#include "emulator/chip/chip_bus.hpp"

#include <algorithm>

#include "emulator/core/word_text.hpp"

namespace finemote::emulator {
namespace {

constexpr std::uint32_t kFirst = 0x40000000, kFirstOfAhb2 = 0x50000000;  ///< addresses of the first peripherals
constexpr std::uint32_t kKib = 1024, kKibBelowAhb2 = 512;

using Bridge = ChipBus::Bridge;

constexpr Bridge bridge_of(std::uint32_t address) {
  return address < 0x40010000 ? Bridge::apb1 : address < 0x40020000 ? Bridge::apb2 : Bridge::none;
}

}  // namespace

/// What lies behind AHB2 follows at once.
std::size_t ChipBus::kib_of(std::uint32_t address) {
  return address < kFirstOfAhb2 ? (address - kFirst) / kKib : kKibBelowAhb2 + (address - kFirstOfAhb2) / kKib;
}

void ChipBus::place(const stm32f407::Place& place, Peripheral& peripheral, unsigned kib) {
  slots_.push_back(Slot{place, &peripheral});
  const std::size_t at = kib_of(place.base);
  if (slot_at_.size() < at + kib) slot_at_.resize(at + kib);
  std::fill_n(slot_at_.begin() + static_cast<std::ptrdiff_t>(at), kib, static_cast<std::uint8_t>(slots_.size()));
}

void ChipBus::reset_all() {
  lowered_ = {};
  for (const Slot& slot : slots_) slot.peripheral->reset();
}

void ChipBus::reset_at(ClockBus bus, unsigned bit) {
  for (const Slot& slot : slots_) {
    if (slot.place.bus == bus && slot.place.bit == bit) slot.peripheral->reset();
  }
}

void ChipBus::poll_dma() {
  for (const Slot& slot : slots_) slot.peripheral->poll_dma();
}

const ChipBus::Slot* ChipBus::find(std::uint32_t address) const {
  const std::size_t at = kib_of(address);
  const unsigned number = at < slot_at_.size() ? slot_at_[at] : 0;
  if (number == 0) return nullptr;
  return &slots_[number - 1];
}

/// @param value  to write; null to read
std::uint32_t ChipBus::access(std::uint32_t address, unsigned bytes, const std::uint32_t* value) {
  world_.touch(address);
  const std::uint32_t answer = access(find(address), address, bytes, value);
  world_.touch(std::nullopt);
  return answer;
}

std::uint32_t ChipBus::access(const Slot* slot, std::uint32_t address, unsigned bytes, const std::uint32_t* value) {
  if (slot == nullptr) {
    world_.report(Misuse::unmodelled, "peripheral address " + hex(address & ~0x3FFU));
    return 0;
  }
  if (!rcc.clocked(slot->place.bus, slot->peripheral->clock_bits(address - slot->place.base, slot->place.bit))) {
    world_.report(Misuse::unclocked,
                  slot->peripheral->name_at(address - slot->place.base) + " is touched before its clock is on");
    return 0;
  }
  const std::uint32_t offset = (address - slot->place.base) & ~3U, shift = (address & 3) * 8;
  const std::uint32_t mask = bytes == 4 ? ~0U : (1U << (8 * bytes)) - 1;
  if (value == nullptr) {
    world_.crossing() = {};
    const std::uint32_t answer = slot->peripheral->read(offset) >> shift & mask;
    if (shift != 0) world_.crossing() = moved(world_.crossing(), -static_cast<int>(shift));
    return answer;
  }
  if (shift != 0) world_.crossing() = moved(world_.crossing(), static_cast<int>(shift));
  if (bytes == 4)
    slot->peripheral->write(offset, *value);
  else
    slot->peripheral->write_part(offset, mask << shift, (*value & mask) << shift);
  return 0;
}

std::uint32_t ChipBus::read(std::uint32_t address, unsigned bytes) {
  const Bridge bridge = bridge_of(address);
  if (bridge == bridge_of(lowered_.address)) lowered_.line = -1;  // it comes after the write that went the same way
  world_.cpu().add_wait(wait_cycles(address));
  return access(address, bytes, nullptr);
}

void ChipBus::write(std::uint32_t address, unsigned bytes, std::uint32_t value) {
  static_cast<void>(world_.system().nvic().take_lowered());
  world_.cpu().add_wait(wait_cycles(address));
  access(address, bytes, &value);
  if (const int line = world_.system().nvic().take_lowered(); line >= 0) lowered_ = {line, address, world_.now()};
}

/// Cycles of the core clock in one of the bus behind `bridge`.
unsigned ChipBus::ratio(Bridge bridge) const {
  return rcc.core_hz() / (bridge == Bridge::apb1 ? rcc.apb1_hz() : rcc.apb2_hz());
}

/// Cycles an access waits beyond the instruction. The bus matrix takes one for arbitration and one for the transfer, a
/// bridge two clocks of its bus besides: AN4031 2.2 and table 4, which are written for DMA. A store is charged at once
/// what the next access would wait for the write buffer.
unsigned ChipBus::wait_cycles(std::uint32_t address) const {
  constexpr unsigned kMatrix = 2, kTransfer = 2;
  const Bridge bridge = bridge_of(address);
  return bridge == Bridge::none ? kMatrix : kMatrix + kTransfer * ratio(bridge);
}

/// Cycles from a store until the interrupt controller sees the line it lowered: two through the write buffer and the
/// bus matrix, two for the line; a bridge may wait a clock of its bus and takes two for the transfer. A documented
/// choice, on the safe side.
unsigned ChipBus::settling_cycles(std::uint32_t address) const {
  constexpr unsigned kStore = 2, kLine = 2, kTransfer = 3;
  const Bridge bridge = bridge_of(address);
  if (bridge == Bridge::none) return kStore + kLine;
  return kStore + kLine + kTransfer * ratio(bridge);
}

/// The line of a routine that returns may still look high to the interrupt controller, which then enters it again. Not
/// so when a DSB or a read on the same bus came after the store, or time enough; nor is it the store's fault when the
/// line has risen since: then the routine is entered again anyway.
void ChipBus::returning(int exception) {
  const int line = lowered_.line;
  if (line < 0 || line + 16 != exception) return;
  lowered_.line = -1;
  const Nvic& nvic = world_.system().nvic();
  if (nvic.is_high(line) || nvic.is_pending(exception) || world_.cpu().drained_at() > lowered_.at) return;
  if (world_.now() - lowered_.at >= settling_cycles(lowered_.address) * world_.system().clock().period()) return;
  world_.report(Misuse::late_flag,
                "line " + std::to_string(line) + " is cleared as the last thing of its routine, without read-back");
}

}  // namespace finemote::emulator
