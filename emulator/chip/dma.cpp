#include "emulator/chip/dma.hpp"

#include <cstring>

#include "emulator/core/address_map.hpp"

namespace finemote::emulator {
namespace {

constexpr std::uint32_t kEnable = 1, kErrorInterrupt = 4, kHalfInterrupt = 8, kCompleteInterrupt = 16,
                        kFromMemory = 1U << 6, kFromMemoryToMemory = 2U << 6, kDirection = 3U << 6, kCircular = 1U << 8,
                        kPeripheralIncrement = 1U << 9, kMemoryIncrement = 1U << 10, kDoubleBuffer = 1U << 18,
                        kSecondBuffer = 1U << 19;
constexpr std::uint32_t kFlagError = 8, kFlagHalf = 16, kFlagComplete = 32;

struct Route {
  DmaRequest request;
  unsigned controller, stream, channel;
};
constexpr Route kRoutes[] = {
    {DmaRequest::usart1_rx, 2, 2, 4}, {DmaRequest::usart1_rx, 2, 5, 4}, {DmaRequest::usart1_tx, 2, 7, 4},
    {DmaRequest::usart2_rx, 1, 5, 4}, {DmaRequest::usart2_tx, 1, 6, 4}, {DmaRequest::usart3_rx, 1, 1, 4},
    {DmaRequest::usart3_tx, 1, 3, 4}, {DmaRequest::usart3_tx, 1, 4, 7}, {DmaRequest::usart6_rx, 2, 1, 5},
    {DmaRequest::usart6_rx, 2, 2, 5}, {DmaRequest::usart6_tx, 2, 6, 5}, {DmaRequest::usart6_tx, 2, 7, 5},
    {DmaRequest::spi1_rx, 2, 0, 3},   {DmaRequest::spi1_rx, 2, 2, 3},   {DmaRequest::spi1_tx, 2, 3, 3},
    {DmaRequest::spi1_tx, 2, 5, 3},   {DmaRequest::spi2_rx, 1, 3, 0},   {DmaRequest::spi2_tx, 1, 4, 0},
    {DmaRequest::i2c2_rx, 1, 2, 7},   {DmaRequest::i2c2_rx, 1, 3, 7},   {DmaRequest::uart4_rx, 1, 2, 4},
    {DmaRequest::uart4_tx, 1, 4, 4},  {DmaRequest::uart5_rx, 1, 0, 4},  {DmaRequest::uart5_tx, 1, 7, 4},
    {DmaRequest::spi3_rx, 1, 0, 0},   {DmaRequest::spi3_rx, 1, 2, 0},   {DmaRequest::spi3_tx, 1, 5, 0},
    {DmaRequest::spi3_tx, 1, 7, 0},   {DmaRequest::i2c2_tx, 1, 7, 7},   {DmaRequest::i2c3_rx, 1, 2, 3},
    {DmaRequest::i2c3_tx, 1, 4, 3},   {DmaRequest::i2c1_rx, 1, 0, 1},   {DmaRequest::i2c1_rx, 1, 5, 1},
    {DmaRequest::i2c1_tx, 1, 6, 1},   {DmaRequest::i2c1_tx, 1, 7, 1},   {DmaRequest::adc1, 2, 0, 0},
    {DmaRequest::adc1, 2, 4, 0},      {DmaRequest::adc2, 2, 2, 1},      {DmaRequest::adc2, 2, 3, 1},
    {DmaRequest::adc3, 2, 0, 2},      {DmaRequest::adc3, 2, 1, 2},
};

constexpr int kLines[2][8] = {{11, 12, 13, 14, 15, 16, 17, 47}, {56, 57, 58, 59, 60, 68, 69, 70}};

/// PSIZE counts for both sides in direct mode, and in memory what the FIFO packs lies in the same order:
/// RM0090 10.3.10, 10.3.12, 10.5.5.
unsigned item_bytes(std::uint32_t control) { return 1U << (control >> 11 & 3); }

unsigned shift_of(unsigned stream) { return stream % 4 / 2 * 16 + stream % 2 * 6; }

}  // namespace

void Dma::reset() {
  streams_ = {};
  flags_ = {};
  for (unsigned i = 0; i < 8; ++i) update_line(i);
}

void Dma::update_line(unsigned index) {
  const std::uint32_t c = streams_[index].control;
  const std::uint32_t enabled = ((c & kErrorInterrupt) != 0 ? kFlagError : 0) |
                                ((c & kHalfInterrupt) != 0 ? kFlagHalf : 0) |
                                ((c & kCompleteInterrupt) != 0 ? kFlagComplete : 0);
  world_.set_line(kLines[number_ - 1][index], (flags_[index] & enabled) != 0);
}

void Dma::raise(unsigned index, std::uint32_t flags) {
  flags_[index] |= flags;
  update_line(index);
}

std::uint32_t Dma::read(std::uint32_t offset) {
  if (offset < 8) {
    std::uint32_t bits = 0;
    for (unsigned i = 0; i < 4; ++i) bits |= flags_[offset + i] << shift_of(i);
    return bits;
  }
  if (offset < 0x10) return 0;
  const unsigned index = (offset - 0x10) / 0x18;
  if (index > 7) return unmodelled_read(offset);
  const Stream& s = streams_[index];
  switch ((offset - 0x10) % 0x18) {
    case 0x00:
      return s.control;
    case 0x04:
      return s.left;
    case 0x08:
      return s.peripheral;
    case 0x0C:
      return s.memory0;
    case 0x10:
      return s.memory1;
    default:
      return s.fifo;
  }
}

void Dma::write(std::uint32_t offset, std::uint32_t value) {
  if (offset == 8 || offset == 0xC) {
    const unsigned first = offset == 8 ? 0 : 4;
    for (unsigned i = 0; i < 4; ++i) {
      flags_[first + i] &= ~(value >> shift_of(i) & 0x3D);
      update_line(first + i);
    }
    return;
  }
  const unsigned index = offset < 0x10 ? 8 : (offset - 0x10) / 0x18;
  if (index > 7) return unmodelled_write(offset);
  Stream& s = streams_[index];
  const unsigned field = (offset - 0x10) % 0x18;
  if (field == 0) return write_control(index, value);
  if ((s.control & kEnable) != 0) check_set_up(index, field);
  switch (field) {
    case 0x04:
      s.count = s.left = value & 0xFFFF;
      return;
    case 0x08:
      s.peripheral = value;
      return;
    case 0x0C:
      s.memory0 = value;
      return;
    case 0x10:
      s.memory1 = value;
      return;
    default:
      s.fifo = value;
      return;
  }
}

/// While it is on, only the buffer of two that is not in use may be moved: RM0090 10.3.9.
void Dma::check_set_up(unsigned index, unsigned field) {
  const std::uint32_t control = streams_[index].control;
  const unsigned idle = (control & kSecondBuffer) != 0 ? 0x0C : 0x10;
  if ((control & kDoubleBuffer) != 0 && field == idle) return;
  world_.report(Misuse::protocol, name() + " stream " + std::to_string(index) + " is set up while it is on");
}

void Dma::write_control(unsigned index, std::uint32_t value) {
  Stream& s = streams_[index];
  const bool was = (s.control & kEnable) != 0, on = (value & kEnable) != 0;
  only(value, 0x0FEF0000U | 0x7FDF, "SxCR");  // the DMA counts, not the peripheral
  s.control = value;
  if (was && !on) raise(index, kFlagComplete);  // turned off before its end: RM0090 10.3.14
  if (on && !was) turn_on(index);
  update_line(index);
}

void Dma::turn_on(unsigned index) {
  Stream& s = streams_[index];
  const std::string stream = name() + " stream " + std::to_string(index);
  if ((flags_[index] & 0x3D) != 0)
    world_.report(Misuse::protocol, stream + " is turned on with flags of its last transfer set");
  ++s.turned_on;
  s.left = s.count;  // also again: RM0090 10.5.6
  s.position = 0;
  if (s.left == 0) s.control &= ~kEnable;
  if (on_enable) on_enable();
  if ((s.control & kDirection) != kFromMemoryToMemory) return;
  if (number_ == 1) return world_.report(Misuse::protocol, "dma1 cannot move memory to memory");
  // A read and a write of two cycles each per item: RM0090 10.3.6 gives no figure, a documented choice.
  world_.after(s.left * 4 * world_.system().clock().period(), [this, index] { move_all(index); });
}

void Dma::move_all(unsigned index) {
  while ((streams_[index].control & (kEnable | kDirection)) == (kEnable | kFromMemoryToMemory)) move(index);
}

/// The stream that is on for this request; -1: none.
int Dma::serving(DmaRequest request) const {
  for (const Route& route : kRoutes) {
    if (route.request != request || route.controller != number_) continue;
    const std::uint32_t control = streams_[route.stream].control;
    if ((control & kEnable) != 0 && (control >> 25 & 7) == route.channel) return static_cast<int>(route.stream);
  }
  return -1;
}

bool Dma::serve(DmaRequest request) {
  const int index = serving(request);
  if (index >= 0) move(static_cast<unsigned>(index));
  return index >= 0;
}

std::uint32_t Dma::left(DmaRequest request) const {
  const int index = serving(request);
  return index < 0 ? 0 : streams_[static_cast<unsigned>(index)].left;
}

bool Dma::break_stream(DmaRequest request) {
  const int index = serving(request);
  if (index < 0) return false;
  streams_[static_cast<unsigned>(index)].control &= ~kEnable;
  raise(static_cast<unsigned>(index), kFlagError);
  return true;
}

/// Memory that DMA can use; null and a report where it cannot.
std::uint8_t* Dma::reachable(std::uint32_t address, unsigned bytes, bool written) {
  std::uint8_t* p = Cpu::dma_reaches(address) ? world_.cpu().memory(address, bytes) : nullptr;
  const bool flash = address >= 0x08000000 && address < 0x10000000;
  if (p != nullptr && !(flash && written)) return p;
  world_.report(Misuse::dma_unreachable, name() + " cannot reach " + hex(address));
  return nullptr;
}

/// The first controller's way to peripherals ends at APB1: RM0090 2.1, 10.3.
bool Dma::has_bridge_to(std::uint32_t address) const {
  return is_peripheral(address) && (number_ == 2 || lies_in(address, 0x40000000, 0x8000));
}

bool Dma::fail(std::uint32_t address) {
  world_.report(Misuse::dma_unreachable, name() + " cannot reach " + hex(address));
  return false;
}

/// Behind the port of peripherals the second controller also finds memory.
bool Dma::read_peripheral(std::uint32_t address, unsigned bytes, std::uint32_t& value) {
  if (has_bridge_to(address)) {
    value = bus_.read(address, bytes);
    return true;
  }
  if (number_ == 1) return fail(address);
  const std::uint8_t* source = reachable(address, bytes, false);
  if (source == nullptr) return false;
  std::memcpy(&value, source, bytes);
  world_.crossing() = world_.tags().in_memory(address, bytes);
  return true;
}

bool Dma::write_peripheral(std::uint32_t address, unsigned bytes, std::uint32_t value) {
  if (has_bridge_to(address)) {
    bus_.write(address, bytes, value);
    return true;
  }
  if (number_ == 1) return fail(address);
  std::uint8_t* target = reachable(address, bytes, true);
  if (target == nullptr) return false;
  std::memcpy(target, &value, bytes);
  world_.cpu().ram_changed(address, bytes);
  world_.tags().put_in_memory(address, bytes, world_.crossing());
  return true;
}

/// Between the peripheral (or the first memory) and `memory`; false: one of them cannot be reached.
bool Dma::transfer(Stream& s, std::uint32_t memory) {
  const unsigned bytes = item_bytes(s.control);
  const std::uint32_t peripheral = s.peripheral + ((s.control & kPeripheralIncrement) != 0 ? s.position * bytes : 0);
  const std::uint32_t direction = s.control & kDirection;
  std::uint8_t* p = reachable(memory, bytes, direction != kFromMemory);
  if (p == nullptr) return false;
  std::uint32_t value = 0;
  if (direction == kFromMemory) {
    std::memcpy(&value, p, bytes);
    world_.crossing() = world_.tags().in_memory(memory, bytes);
    return write_peripheral(peripheral, bytes, value);
  }
  if (!read_peripheral(peripheral, bytes, value)) return false;
  store(memory, bytes, value);
  return true;
}

Time Dma::late(Strictness way) { return world_.silicon().draw_or_zero(way) * world_.system().clock().period(); }

/// What the stream has read, to memory: at once, or as late as the chip is.
void Dma::store(std::uint32_t memory, unsigned bytes, std::uint32_t value) {
  const auto arrive = [this, memory, bytes, value, tags = world_.crossing()] {
    std::memcpy(world_.cpu().memory(memory, bytes), &value, bytes);
    world_.cpu().ram_changed(memory, bytes);
    world_.tags().put_in_memory(memory, bytes, tags);
  };
  const Time delay = late(Strictness::dma_store);
  stored_at_ = delay;
  delay == 0 ? arrive() : world_.after(delay, arrive);
}

/// Flags follow the last item into memory.
void Dma::raise_late(unsigned index, std::uint32_t flags) {
  const Time delay = stored_at_ + late(Strictness::dma_flag);
  if (delay == 0) return raise(index, flags);
  world_.after(delay, [this, index, flags, turned_on = streams_[index].turned_on] {
    if (streams_[index].turned_on == turned_on) raise(index, flags);
  });
}

void Dma::move(unsigned index) {
  Stream& s = streams_[index];
  const unsigned bytes = item_bytes(s.control);
  const std::uint32_t buffer = (s.control & kSecondBuffer) != 0 ? s.memory1 : s.memory0;
  const std::uint32_t memory = buffer + ((s.control & kMemoryIncrement) != 0 ? s.position * bytes : 0);
  // The count goes first: what the peripheral does with the item may ask for the next one at once.
  ++s.position;
  --s.left;
  const std::uint32_t left = s.left;
  --s.position;
  stored_at_ = 0;
  const bool done = transfer(s, memory);
  ++s.position;
  if (!done) {
    s.control &= ~kEnable;
    raise(index, kFlagError);
    return;
  }
  std::uint32_t flags = left == s.count / 2 ? kFlagHalf : 0;
  if (left == 0) {
    flags |= kFlagComplete;
    s.position = 0;
    if ((s.control & kDoubleBuffer) != 0) s.control ^= kSecondBuffer;
    if ((s.control & (kCircular | kDoubleBuffer)) != 0) {
      s.left = s.count;
    } else {
      s.control &= ~kEnable;
    }
  }
  if (flags != 0) raise_late(index, flags);
}

}  // namespace finemote::emulator
