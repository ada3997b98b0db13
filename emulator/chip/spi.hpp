// An SPI master: eight clocks a byte, both ways at once, to the part whose chip select is low; frames of 16 bits are
// two bytes. RM0090 28. Slave, half-duplex, CRC and I2S modes are not modelled.
#pragma once

#include <functional>
#include <vector>

#include "emulator/chip/bus_statistics.hpp"
#include "emulator/chip/dma.hpp"
#include "emulator/chip/peripheral.hpp"

namespace finemote::emulator {

/// A part behind one chip select.
struct SpiPart {
  std::function<void(bool selected)> select;
  std::function<WireByte(WireByte)> exchange;
  std::uint32_t fastest_hz = 0;  ///< clock the part is good for; 0: any
};

class Spi : public Peripheral {
 public:
  struct Wiring {
    int line;
    DmaRequest rx, tx;
    std::function<std::uint32_t()> clock_hz;
    std::function<bool(DmaRequest)> dma;
  };
  Spi(World& world, std::string name, Wiring wiring) : Peripheral(world, std::move(name)), wiring_(std::move(wiring)) {}

  std::uint32_t read(std::uint32_t offset) override;
  void write(std::uint32_t offset, std::uint32_t value) override;
  void reset() override;
  void poll_dma() override { ask_dma(); }

  /// @return the part's number, for selected()
  std::size_t attach(SpiPart part) {
    parts_.push_back(Attached{std::move(part), false});
    return parts_.size() - 1;
  }
  /// Told of every frame, for those who look on.
  std::function<void(std::uint16_t out, std::uint16_t in, unsigned bits)> on_frame;
  /// The chip select of a part changes its level.
  void selected(std::size_t part, bool low);
  [[nodiscard]] const BusStatistics& statistics() const { return statistics_; }
  [[nodiscard]] std::uint32_t clock_hz() const { return wiring_.clock_hz() >> ((cr1_ >> 3 & 7) + 1); }
  [[nodiscard]] unsigned mode() const { return cr1_ & 3; }

 private:
  struct Attached {
    SpiPart part;
    bool selected;
  };
  /// Two bytes, or the lower one.
  struct Frame {
    WireByte low, high;
    [[nodiscard]] std::uint16_t value() const { return static_cast<std::uint16_t>(low.value | high.value << 8); }
  };
  [[nodiscard]] bool on() const { return (cr1_ & 0x44) == 0x44; }  // SPE, MSTR
  [[nodiscard]] bool wide() const { return (cr1_ & 0x800) != 0; }  // DFF
  WireByte exchange(WireByte out);
  void write_cr1(std::uint32_t value);
  void shift();
  void shifted(const Frame& out);
  void end_clock();
  void ask_dma();
  void update();

  Wiring wiring_;
  std::vector<Attached> parts_;
  std::uint32_t cr1_ = 0, cr2_ = 0, sr_ = 2, polynomial_ = 7;
  Frame out_, in_;
  bool full_ = false, shifting_ = false, overrun_read_ = false;
  bool ending_ = false;  ///< the last bit is sampled, the last edge of the clock still to come
  std::uint64_t token_ = 0;
  BusStatistics statistics_;
};

}  // namespace finemote::emulator
