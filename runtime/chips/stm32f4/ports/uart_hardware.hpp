// A serial port of the chip: its peripheral, pins and DMA streams, its buffers, and what its interrupts note down.
#pragma once

#include <cstdint>

#include "finemote/ports.hpp"
#include "finemote/single_core.hpp"
#include "runtime/chips/stm32f4/peripherals.hpp"
#include "runtime/chips/stm32f4/pin.hpp"
#include "runtime/chips/stm32f4/registers/dma.hpp"

namespace finemote {
namespace stm32f4 {

inline constexpr std::uint32_t kUartTransmit = 128;

/// Facts of one port; in flash.
struct UartSetup : UsartPeripheral {
  Pin tx, rx;
  std::uint8_t function;
  DmaStream receive, transmit;
  std::uint8_t channel;  ///< DMA request channel of both streams: RM0090 10.3.3, tables 43 and 44
  std::uint8_t usart_line, receive_line;
  bool inverter;                  ///< the board inverts the receive line
  std::uint8_t* transmit_buffer;  ///< kUartTransmit bytes the DMA reaches
};

}  // namespace stm32f4

struct UartHardware {
  const stm32f4::UartSetup& setup;
  UartRing ring{};
  Shared<std::uint32_t> laps{0};     ///< times the ring was filled
  Shared<std::uint32_t> counted{0};  ///< bytes received when last asked
  UartIdle idle{};
  UartErrors errors{};
  Shared<std::uint32_t> events_left{0};
  Shared<bool> quiet{true};        ///< no line event interrupts: none is left
  Time quiet_since = kLongAgo;     ///< when the last one did
  std::uint32_t resumed_from = 0;  ///< bytes received when events were allowed again
  Shared<bool> halted{false};
  Shared<bool> sending{false};
  bool directed = false, driver_low = false;  ///< a pin turns the line driver on; it is active low
  stm32f4::Pin driver{};

  /// Turns the line driver on or off, where there is one. Context: any.
  void drive(bool on) const {
    if (directed) driver.set(on != driver_low);
  }
  /// Bytes received since start, modulo 2^32, the last one perhaps not in memory yet. Context: any.
  /// @param idle  the last silence at that instant; null: not wanted
  [[nodiscard]] std::uint32_t count(UartIdle* idle = nullptr);
  /// The routines of its lines. Context: interrupt.
  void on_usart();
  void on_receive_dma();

 private:
  void end_transmit();

  struct RingPlace {
    std::uint32_t laps, position;
  };
  [[nodiscard]] RingPlace ring_place(UartIdle* idle) const;
  [[nodiscard]] std::uint32_t forward(std::uint32_t before, std::uint32_t count);
  void take_events(std::uint32_t status, Time at);
};

}  // namespace finemote
