// The three converters at their addresses, with the registers they share. RM0090 13.13.18.
#pragma once

#include <array>

#include "emulator/chip/adc.hpp"

namespace finemote::emulator {

class AdcBlock : public Peripheral {
 public:
  static constexpr unsigned kConverters = 3;

  /// @param wiring  of converter 0..2
  AdcBlock(World& world, const std::function<Adc::Wiring(unsigned converter)>& wiring)
      : Peripheral(world, "adc"),
        converters_{Adc(world, "adc1", common_, wiring(0)), Adc(world, "adc2", common_, wiring(1)),
                    Adc(world, "adc3", common_, wiring(2))} {}

  Adc& converter(unsigned number) { return converters_[number]; }

  std::uint32_t read(std::uint32_t offset) override {
    if (offset < kCommon) return converters_[offset / kBytes].read(offset % kBytes);
    if (offset == kCommon) {
      return converters_[0].status() | converters_[1].status() << 8 | converters_[2].status() << 16;
    }
    return offset == kControl ? common_.control : unmodelled_read(offset);
  }
  void write(std::uint32_t offset, std::uint32_t value) override {
    if (offset < kCommon) return converters_[offset / kBytes].write(offset % kBytes, value);
    if (offset != kControl) return unmodelled_write(offset);
    only(value, 3U << 16 | 3U << 22, "CCR");  // each for itself
    common_.control = value;
  }
  void reset() override {
    common_ = {};
    for (Adc& converter : converters_) converter.reset();
  }
  [[nodiscard]] std::string name_at(std::uint32_t offset) const override {
    return offset < kCommon ? converters_[offset / kBytes].name() : name();
  }
  /// Each has a bit; for the shared registers any will do: RM0090 7.3.14.
  [[nodiscard]] std::uint32_t clock_bits(std::uint32_t offset, unsigned first) const override {
    return offset < kCommon ? 1U << (first + offset / kBytes) : 7U << first;
  }

 private:
  static constexpr std::uint32_t kBytes = 0x100, kCommon = 0x300, kControl = 0x304;
  AdcCommon common_;
  std::array<Adc, kConverters> converters_;
};

}  // namespace finemote::emulator
