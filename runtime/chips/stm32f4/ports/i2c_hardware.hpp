// An I2C master of the chip: its peripheral and pins, and the exchange that is under way.
#pragma once

#include <cstdint>

#include "finemote/at_start.hpp"
#include "finemote/ports.hpp"
#include "finemote/single_core.hpp"
#include "runtime/chips/stm32f4/peripherals.hpp"
#include "runtime/chips/stm32f4/pin.hpp"

namespace finemote {
namespace stm32f4 {

/// Facts of one port; in flash.
struct I2cSetup : I2cPeripheral {
  Pin scl, sda;
  std::uint8_t function;
  std::uint8_t event_line, error_line;
};

}  // namespace stm32f4

struct I2cHardware {
  const stm32f4::I2cSetup& setup;

  AtStart<I2cBus*> bus{};
  I2cMessage message{};
  std::uint16_t moved = 0;  ///< bytes of the present phase
  bool reading = false;     ///< the present phase
  bool active = false;      ///< an exchange is under way
  bool begins = false;      ///< its START is to be asked for
  AtStart<std::uint32_t> clock_hz{};
  AtStart<std::uint32_t> stop_limit{};  ///< of the wait for a STOP, from finished_at on [cycles]
  std::uint32_t finished_at = 0;        ///< end of the last exchange [cycles]
  Shared<std::uint32_t> stepped_at{0};  ///< the last step of one [cycles]

  /// The routines of its lines. Context: interrupt.
  void on_event();
  void on_error();

  void set_up();
  [[nodiscard]] I2cEvent step();
  [[nodiscard]] bool has_stopped() const;

 private:
  void hand_on(I2cEvent event);
  I2cEvent finish(I2cEvent event);
  void note_step();
  void send_address();
  I2cEvent address_sent();
  I2cEvent write_on(std::uint32_t status);
  I2cEvent read_on(std::uint32_t status);
  void take_byte();
};

}  // namespace finemote
