// The STM32F407 and what a board wires to it: its peripherals by name, and the parts of the board's pins.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "emulator/chip/adc_block.hpp"
#include "emulator/chip/can.hpp"
#include "emulator/chip/chip_bus.hpp"
#include "emulator/chip/crc.hpp"
#include "emulator/chip/dac.hpp"
#include "emulator/chip/dma.hpp"
#include "emulator/chip/exti.hpp"
#include "emulator/chip/flash.hpp"
#include "emulator/chip/gpio.hpp"
#include "emulator/chip/i2c.hpp"
#include "emulator/chip/iwdg.hpp"
#include "emulator/chip/pwr.hpp"
#include "emulator/chip/rng.hpp"
#include "emulator/chip/rtc.hpp"
#include "emulator/chip/spi.hpp"
#include "emulator/chip/timer.hpp"
#include "emulator/chip/usart.hpp"
#include "emulator/chip/usb.hpp"
#include "emulator/chip/wiring.hpp"
#include "emulator/chip/wwdg.hpp"

namespace finemote::emulator {

/// Which of the two streams of a port.
enum class DmaWay : std::uint8_t { receive, transmit };

class Chip : public ChipBus {
 public:
  Chip(World& world, Wiring wiring);

  /// Everything but the clock controller's memory of why.
  void reset();
  void store_to_flash(std::uint32_t address, unsigned bytes, std::uint32_t value) override {
    flash.store(address, bytes, value);
  }

  // All of a kind, for those who look on.
  [[nodiscard]] const std::vector<std::unique_ptr<Usart>>& usarts() const { return usarts_; }
  [[nodiscard]] const std::vector<std::unique_ptr<I2c>>& i2cs() const { return i2cs_; }
  [[nodiscard]] const std::vector<std::unique_ptr<Spi>>& spis() const { return spis_; }
  [[nodiscard]] const std::vector<std::unique_ptr<Timer>>& timers() const { return timers_; }

  Gpio& gpio(char port) { return *gpios_[static_cast<std::size_t>(port - stm32f407::kFirstPort)]; }
  /// By port name: `usart6`, `i2c2`, `adc3`; null when there is none.
  Usart* usart(const std::string& name);
  I2c* i2c(const std::string& name);
  Can* can(const std::string& name);
  Spi* spi(const std::string& name);
  Adc* adc(const std::string& name);
  /// Puts a part on an SPI port, behind a pin as its chip select.
  void attach_spi(Spi& spi, char port, unsigned pin, SpiPart part);
  /// The same by names, behind a chip select of the board. @return false: there is no such port or select
  bool attach_spi(const std::string& name, unsigned select, SpiPart part);
  /// A fault: a DMA stream of this port (`usart1`, `spi1`) meets a bus error. @return false: no such port, or the
  /// stream is off
  bool break_dma(const std::string& port, DmaWay way);
  /// Timer and channel of a pulse output of the board, by its port (`pwm1`, `led_red`); null and 0 when there is none.
  std::pair<Timer*, unsigned> pwm(const std::string& name);
  /// The pin of such an output. @throws std::invalid_argument  the board has none of this name
  [[nodiscard]] PinPlace pulse_pin(const std::string& name) const;

  Flash flash;
  Pwr pwr;
  Exti exti;
  Syscfg syscfg;
  Iwdg iwdg;
  Wwdg wwdg;
  Rtc rtc;
  Rng rng;
  Crc crc;
  Dac dac;
  Usb usb;

 private:
  void add_system();
  void add_ports();
  void add_dma();
  void add_buses();
  void add_timers();
  void add_converters();
  [[nodiscard]] Adc::Wiring converter_wiring(unsigned number);
  /// A line that several hold up.
  [[nodiscard]] std::function<void(bool)> shared_line(int line);
  void connect();
  void connect_wires(I2c& i2c, PinPlace scl, PinPlace sda);
  [[nodiscard]] std::function<std::uint32_t()> clock_of(ClockBus bus);

  World& world_;
  const Wiring wiring_;
  std::vector<std::unique_ptr<Gpio>> gpios_;
  std::unique_ptr<Dma> dma1_, dma2_;
  std::vector<std::unique_ptr<Usart>> usarts_;
  std::vector<std::unique_ptr<I2c>> i2cs_;
  std::vector<std::unique_ptr<Spi>> spis_;
  std::unique_ptr<AdcBlock> adcs_;
  CanFilters can_filters_;
  std::vector<std::unique_ptr<Can>> cans_;
  std::vector<std::unique_ptr<Timer>> timers_;
  std::array<unsigned, kExceptions> line_holders_{};  ///< how many hold a shared line up
};

}  // namespace finemote::emulator
