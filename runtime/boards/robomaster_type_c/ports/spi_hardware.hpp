// An SPI master of the chip: its registers, pins, chip selects, and the exchange under way.
#pragma once

#include <cstdint>

#include "finemote/ports.hpp"
#include "runtime/boards/robomaster_type_c/pin.hpp"
#include "runtime/boards/robomaster_type_c/registers/dma.hpp"
#include "runtime/boards/robomaster_type_c/registers/spi.hpp"

namespace finemote {
namespace robomaster_type_c {

/// The longest exchange whose bytes DMA cannot reach where they are: they are copied.
inline constexpr std::uint32_t kSpiCopy = 64;

/// Facts of one port; in flash.
struct SpiSetup {
  stm32f407::SpiRegisters spi;
  stm32f407::Register clock_enable;
  std::uint32_t clock_bit, clock_hz;
  Pin sck, miso, mosi;
  const Pin* selects;
  std::uint8_t select_count;
  bool dma;  ///< else one interrupt per byte
  stm32f407::DmaStream receive, transmit;
  std::uint8_t channel;
  std::uint8_t line;  ///< of the receiving stream, or of the peripheral
};

/// What DMA works on beside the devices' own bytes.
struct SpiBuffers {
  std::uint8_t out[kSpiCopy];
  std::uint8_t in[kSpiCopy];
  std::uint8_t ones, dropped;
};

}  // namespace robomaster_type_c

struct SpiHardware {
  const robomaster_type_c::SpiSetup& setup;
  robomaster_type_c::SpiBuffers& buffers;

  SpiBus* bus = nullptr;
  std::uint32_t divider = 7;  ///< field of CR1
  SpiMessage message{};
  std::uint16_t moved = 0;
  bool active = false;

  /// The routine of its line. Context: interrupt.
  void on_line();

  void start_dma();
  void next_byte();
  void stop();

 private:
  [[nodiscard]] SpiEvent step_dma();
  [[nodiscard]] SpiEvent step_byte();
  SpiEvent finish(SpiEvent event);
};

}  // namespace finemote
