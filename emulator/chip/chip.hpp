// The STM32F407 as far as the Type C board uses it: which peripheral answers where, and what connects them.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "emulator/chip/adc.hpp"
#include "emulator/chip/can.hpp"
#include "emulator/chip/dma.hpp"
#include "emulator/chip/exti.hpp"
#include "emulator/chip/flash.hpp"
#include "emulator/chip/gpio.hpp"
#include "emulator/chip/i2c.hpp"
#include "emulator/chip/iwdg.hpp"
#include "emulator/chip/rcc.hpp"
#include "emulator/chip/spi.hpp"
#include "emulator/chip/timer.hpp"
#include "emulator/chip/usart.hpp"

namespace finemote::emulator {

class Chip : public PeripheralBus {
 public:
  explicit Chip(World& world);

  // As the processor sees them: with clock gating, bus waits and the check for late flags.
  std::uint32_t read(std::uint32_t address, unsigned bytes) override;
  void write(std::uint32_t address, unsigned bytes, std::uint32_t value) override;
  void returning(int exception) override;

  /// Everything but the clock controller's memory of why.
  void reset();

  // All of a kind, for those who look on.
  [[nodiscard]] const std::vector<std::unique_ptr<Usart>>& usarts() const { return usarts_; }
  [[nodiscard]] const std::vector<std::unique_ptr<I2c>>& i2cs() const { return i2cs_; }
  [[nodiscard]] const std::vector<std::unique_ptr<Spi>>& spis() const { return spis_; }
  [[nodiscard]] const std::vector<std::unique_ptr<Timer>>& timers() const { return timers_; }

  Gpio& gpio(char port) { return *gpios_[static_cast<std::size_t>(port - 'A')]; }
  /// By port name: `usart6`, `i2c2`; null when there is none.
  Usart* usart(const std::string& name);
  I2c* i2c(const std::string& name);
  Can* can(const std::string& name);
  Spi* spi(const std::string& name);
  /// Puts a part on an SPI port, behind a pin as its chip select.
  void attach_spi(Spi& spi, char port, unsigned pin, SpiPart part);
  /// A fault: the DMA stream that receives for this port (`usart1`, `spi1`) meets a bus error. @return false: no such
  /// port, or its stream is off
  bool break_dma(const std::string& port);
  /// Analog input by port name: `adc3`; null when there is none.
  Adc* adc(const std::string& name) { return name == "adc3" ? adc3_.get() : nullptr; }
  /// The same by names, behind a chip select of the board. @return false: there is no such port or select
  bool attach_spi(const std::string& name, unsigned select, SpiPart part);
  /// How many chip selects the board has at an SPI port.
  static unsigned spi_selects(const std::string& name);
  /// Timer and channel of a pulse output: a PWM header `pwm1`..`pwm7`, or `led_red led_green led_blue buzzer
  /// imu_heater`.
  std::pair<Timer*, unsigned> pwm(const std::string& name);

  Rcc rcc;
  Flash flash;
  Pwr pwr;
  Exti exti;
  Syscfg syscfg;
  Iwdg iwdg;

 private:
  struct Slot {
    std::uint32_t base = 0, bytes = 0;
    Peripheral* peripheral = nullptr;
    ClockBus bus = ClockBus::always;
    unsigned bit = 0;
  };
  /// What DMA uses: the same registers without the processor's side.
  class DmaSide : public PeripheralBus {
   public:
    explicit DmaSide(Chip& chip) : chip_(chip) {}
    std::uint32_t read(std::uint32_t address, unsigned bytes) override { return chip_.access(address, bytes, nullptr); }
    void write(std::uint32_t address, unsigned bytes, std::uint32_t value) override {
      chip_.access(address, bytes, &value);
    }

   private:
    Chip& chip_;
  };

  void place(std::uint32_t base, Peripheral& peripheral, ClockBus bus, unsigned bit, std::uint32_t bytes = 0x400);
  [[nodiscard]] const Slot* find(std::uint32_t address) const;
  std::uint32_t access(std::uint32_t address, unsigned bytes, const std::uint32_t* value) {
    return access(find(address), address, bytes, value);
  }
  [[nodiscard]] unsigned settling_cycles(std::uint32_t address) const;
  std::uint32_t access(const Slot* slot, std::uint32_t address, unsigned bytes, const std::uint32_t* value);
  void add_usart(std::uint32_t base, const char* name, ClockBus bus, unsigned bit, int line, DmaRequest rx,
                 DmaRequest tx);
  void add_spi(std::uint32_t base, const char* name, ClockBus bus, unsigned bit, int line, DmaRequest rx,
               DmaRequest tx);
  void add_i2c(std::uint32_t base, const char* name, unsigned bit, int event_line, int error_line);
  void add_timer(std::uint32_t base, const char* name, ClockBus bus, unsigned bit, int line, TimerKind kind = {});
  [[nodiscard]] std::function<std::uint32_t()> clock_of(ClockBus bus);
  void connect_wires(I2c& i2c, char port, unsigned scl, char sda_port, unsigned sda);
  bool serve_dma(DmaRequest request) { return dma1_->serve(request) || dma2_->serve(request); }

  World& world_;
  DmaSide dma_side_;
  std::vector<std::unique_ptr<Gpio>> gpios_;
  std::unique_ptr<Dma> dma1_, dma2_;
  std::vector<std::unique_ptr<Usart>> usarts_;
  std::vector<std::unique_ptr<I2c>> i2cs_;
  std::vector<std::unique_ptr<Spi>> spis_;
  std::unique_ptr<Adc> adc3_;
  CanFilters can_filters_;
  std::unique_ptr<Can> can1_, can2_;
  std::vector<std::unique_ptr<Timer>> timers_;
  std::array<unsigned, kExceptions> timer_lines_{};  ///< how many timers hold a line up
  std::vector<Slot> slots_;
  std::vector<std::uint8_t> slot_at_;  ///< by KiB from kFirst: index in slots_ and 1; 0: none
  /// The last store of the processor that lowered a line; `line` -1: none, or it has surely arrived.
  struct Lowered {
    int line = -1;
    std::uint32_t address = 0;
    Time at = 0;
  };
  Lowered lowered_;
};

}  // namespace finemote::emulator
