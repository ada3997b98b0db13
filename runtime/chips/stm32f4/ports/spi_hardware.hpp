// An SPI master of the chip: its registers, pins, chip selects, and the exchange under way.
#pragma once

#include <cstdint>

#include "finemote/at_start.hpp"
#include "finemote/ports.hpp"
#include "runtime/chips/stm32f4/peripherals.hpp"
#include "runtime/chips/stm32f4/pin.hpp"
#include "runtime/chips/stm32f4/registers/dma.hpp"

namespace finemote {
namespace stm32f4 {

/// The longest exchange whose bytes DMA cannot reach where they are: they are copied.
inline constexpr std::uint32_t kSpiCopy = 64;

/// Facts of one port; in flash.
struct SpiSetup : SpiPeripheral {
  Pin sck, miso, mosi;
  const Pin* selects;
  std::uint8_t select_count;
  bool dma;               ///< else one interrupt per byte
  std::uint8_t function;  ///< of the three pins
  DmaStream receive, transmit;
  std::uint8_t channel;
  std::uint8_t line;  ///< of the receiving stream, or of the peripheral
};

/// What DMA works on beside the devices' own bytes.
struct SpiBuffers {
  alignas(std::uint32_t) std::uint8_t out[kSpiCopy];
  alignas(std::uint32_t) std::uint8_t in[kSpiCopy];
  std::uint8_t ones, dropped;
};

}  // namespace stm32f4

struct SpiHardware {
  const stm32f4::SpiSetup& setup;
  stm32f4::SpiBuffers& buffers;

  AtStart<SpiBus*> bus{};
  std::uint32_t divider = 7;            ///< field of CR1
  AtStart<std::uint32_t> busy_limit{};  ///< of the wait for the end of the clock [cycles]
  SpiMessage message{};
  std::uint16_t moved = 0;
  bool active = false;

  /// The routine of its line. Context: interrupt.
  void on_line();

  void start_dma();
  void next_byte();
  /// Ends the exchange whatever it does. Context: its interrupt.
  void reset() const;

 private:
  void stop() const;
  void release_bus() const;
  [[nodiscard]] SpiEvent step_dma();
  [[nodiscard]] SpiEvent step_byte();
  SpiEvent finish(SpiEvent event);
};

}  // namespace finemote
