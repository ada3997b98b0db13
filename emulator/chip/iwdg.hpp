// The independent watchdog: RM0090 21.
#pragma once

#include <functional>

#include "emulator/chip/peripheral.hpp"

namespace finemote::emulator {

class Iwdg : public Peripheral {
 public:
  explicit Iwdg(World& world) : Peripheral(world, "iwdg") {}

  std::uint32_t read(std::uint32_t offset) override;
  void write(std::uint32_t offset, std::uint32_t value) override;
  void reset() override;

  std::uint32_t lsi_hz = 32'000;  ///< 17 to 47 kHz: DS8626 5.3.9
  std::function<void()> on_timeout;
  [[nodiscard]] bool running() const { return running_; }

 private:
  void feed();

  std::uint32_t prescaler_ = 0, reload_ = 0xFFF;
  bool running_ = false, unlocked_ = false;
  Time busy_until_ = 0;
  std::uint64_t token_ = 0;
};

}  // namespace finemote::emulator
