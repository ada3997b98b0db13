// The way of the processor and of DMA to the peripherals: addresses, clock gating, bus waits, and flags cleared too
// late.
#pragma once

#include <cstdint>
#include <vector>

#include "emulator/chip/rcc.hpp"
#include "emulator/chip/stm32f407.hpp"

namespace finemote::emulator {

class ChipBus : public PeripheralBus {
 public:
  /// The bridge an address lies behind: RM0090 2.3, table 1.
  enum class Bridge { none, apb1, apb2 };

  explicit ChipBus(World& world) : rcc(world), world_(world), dma_side_(*this) {}

  // As the processor sees them: with clock gating, bus waits and the check for late flags.
  std::uint32_t read(std::uint32_t address, unsigned bytes) override;
  void write(std::uint32_t address, unsigned bytes, std::uint32_t value) override;
  void returning(int exception) override;

  Rcc rcc;

 protected:
  /// @param kib  of its addresses
  void place(const stm32f407::Place& place, Peripheral& peripheral, unsigned kib = 1);
  /// What DMA uses: the same registers without the processor's side.
  PeripheralBus& dma_side() { return dma_side_; }
  void reset_all();
  void reset_at(ClockBus bus, unsigned bit);
  void poll_dma();

 private:
  struct Slot {
    stm32f407::Place place;
    Peripheral* peripheral = nullptr;
  };
  class DmaSide : public PeripheralBus {
   public:
    explicit DmaSide(ChipBus& bus) : bus_(bus) {}
    std::uint32_t read(std::uint32_t address, unsigned bytes) override { return bus_.access(address, bytes, nullptr); }
    void write(std::uint32_t address, unsigned bytes, std::uint32_t value) override {
      bus_.access(address, bytes, &value);
    }

   private:
    ChipBus& bus_;
  };
  /// The last store of the processor that lowered a line; `line` -1: none, or it has surely arrived.
  struct Lowered {
    int line = -1;
    std::uint32_t address = 0;
    Time at = 0;
  };

  static std::size_t kib_of(std::uint32_t address);
  [[nodiscard]] const Slot* find(std::uint32_t address) const;
  std::uint32_t access(std::uint32_t address, unsigned bytes, const std::uint32_t* value);
  std::uint32_t access(const Slot* slot, std::uint32_t address, unsigned bytes, const std::uint32_t* value);
  [[nodiscard]] unsigned ratio(Bridge bridge) const;
  [[nodiscard]] unsigned wait_cycles(std::uint32_t address) const;
  [[nodiscard]] unsigned settling_cycles(std::uint32_t address) const;

  World& world_;
  DmaSide dma_side_;
  std::vector<Slot> slots_;
  std::vector<std::uint8_t> slot_at_;  ///< by KiB of addresses: index in slots_ and 1; 0: none
  Lowered lowered_;
};

}  // namespace finemote::emulator
