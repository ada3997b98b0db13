// The flash interface: wait states, and erasing and programming the flash that the image itself lies in. RM0090 3.
#pragma once

#include <array>

#include "emulator/chip/peripheral.hpp"

namespace finemote::emulator {

/// The core stands while the flash is busy, unless its instructions come from RAM. Option bytes can be read, not
/// changed.
class Flash : public Peripheral {
 public:
  explicit Flash(World& world) : Peripheral(world, "flash") {}

  std::uint32_t read(std::uint32_t offset) override;
  void write(std::uint32_t offset, std::uint32_t value) override;
  void write_part(std::uint32_t offset, std::uint32_t mask, std::uint32_t value) override;
  void reset() override;

  /// The processor stores to the flash memory at `address`.
  void store(std::uint32_t address, unsigned bytes, std::uint32_t value);
  [[nodiscard]] unsigned wait_states() const { return acr_ & 7; }

 private:
  /// A sequence of keys opens a register until the next reset; a wrong one shuts it for good: 3.6.1.
  class Lock {
   public:
    Lock(std::uint32_t first, std::uint32_t second) : keys_{first, second} {}
    void give(std::uint32_t key);
    void shut() { given_ = 0; }
    void reset() { given_ = 0, spoilt_ = false; }
    [[nodiscard]] bool is_open() const { return given_ == 2; }

   private:
    std::array<std::uint32_t, 2> keys_;
    unsigned given_ = 0;
    bool spoilt_ = false;
  };

  void apply();
  void write_control(std::uint32_t value);
  void erase(std::uint32_t from, std::uint32_t bytes, Time duration);
  void program(std::uint32_t address, unsigned bytes, std::uint32_t value);
  void work(Time duration);
  void refuse(std::uint32_t error);
  void update();
  [[nodiscard]] bool is_busy() const { return world_.now() < busy_until_; }

  std::uint32_t acr_ = 0, sr_ = 0, cr_ = 0;
  Lock control_{0x45670123, 0xCDEF89AB}, options_{0x08192A3B, 0x4C5D6E7F};  // 3.6.1, 3.7.2
  Time busy_until_ = 0;
};

}  // namespace finemote::emulator
