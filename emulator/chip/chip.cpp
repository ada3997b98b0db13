#include "emulator/chip/chip.hpp"

#include <utility>

namespace finemote::emulator {
namespace {

template <class Kind>
Kind* named(const std::vector<std::unique_ptr<Kind>>& all, const std::string& name) {
  for (const auto& one : all) {
    if (one->name() == name) return one.get();
  }
  return nullptr;
}

}  // namespace

Chip::Chip(World& world, Wiring wiring)
    : ChipBus(world),
      flash(world),
      pwr(world),
      exti(world),
      syscfg(world),
      iwdg(world),
      world_(world),
      wiring_(std::move(wiring)) {
  add_system();
  add_ports();
  add_dma();
  add_buses();
  add_timers();
  add_converter();
  connect();
  reset();
}

void Chip::add_system() {
  place(stm32f407::kRcc, rcc);
  place(stm32f407::kFlash, flash);
  place(stm32f407::kIwdg, iwdg);
  place(stm32f407::kPwr, pwr);
  place(stm32f407::kSyscfg, syscfg);
  place(stm32f407::kExti, exti);
  rcc.wait_states = [this] { return flash.wait_states(); };
  rcc.reset_peripheral = [this](ClockBus bus, unsigned bit) { reset_at(bus, bit); };
}

void Chip::add_ports() {
  for (char port = stm32f407::kFirstPort; port <= stm32f407::kLastPort; ++port) {
    const auto index = static_cast<unsigned>(port - stm32f407::kFirstPort);
    gpios_.push_back(std::make_unique<Gpio>(world_, port));
    place(stm32f407::port_place(port), *gpios_.back());
    gpios_.back()->on_level = [this, index](unsigned pin, bool high) {
      if (syscfg.source(pin) == index) exti.edge(pin, high);
    };
  }
}

void Chip::add_dma() {
  dma1_ = std::make_unique<Dma>(world_, 1, dma_side());
  dma2_ = std::make_unique<Dma>(world_, 2, dma_side());
  place(stm32f407::kDma1, *dma1_);
  place(stm32f407::kDma2, *dma2_);
  dma1_->on_enable = [this] { poll_dma(); };
  dma2_->on_enable = [this] { poll_dma(); };
}

void Chip::add_buses() {
  const auto dma = [this](DmaRequest request) { return dma1_->serve(request) || dma2_->serve(request); };
  for (const auto& it : stm32f407::kUsarts) {
    const Usart::Wiring wiring{it.line, it.rx, it.tx, clock_of(it.place.bus), dma};
    usarts_.push_back(std::make_unique<Usart>(world_, it.name, wiring));
    place(it.place, *usarts_.back());
  }
  for (const auto& it : stm32f407::kSpis) {
    const Spi::Wiring wiring{it.line, it.rx, it.tx, clock_of(it.place.bus), dma};
    spis_.push_back(std::make_unique<Spi>(world_, it.name, wiring));
    place(it.place, *spis_.back());
  }
  for (const auto& it : stm32f407::kI2cs) {
    i2cs_.push_back(std::make_unique<I2c>(world_, it.name, it.event_line, it.error_line, clock_of(it.place.bus)));
    place(it.place, *i2cs_.back());
  }
  for (const auto& it : stm32f407::kCans) {
    cans_.push_back(
        std::make_unique<Can>(world_, it.name, it.lines, can_filters_, it.is_second, clock_of(it.place.bus)));
    place(it.place, *cans_.back());
  }
}

void Chip::add_timers() {
  for (const auto& it : stm32f407::kTimers) {
    const auto set_line = [this, line = it.line](bool high) {
      unsigned& holders = timer_lines_[static_cast<std::size_t>(line)];
      holders += high ? 1 : -1U;
      world_.set_line(line, holders != 0);
    };
    const auto clock = [this, bus = it.place.bus] { return rcc.timer_hz(bus); };
    timers_.push_back(std::make_unique<Timer>(world_, it.name, it.kind, clock, set_line));
    place(it.place, *timers_.back());
  }
}

void Chip::add_converter() {
  const auto is_analog = [this](unsigned input) {
    for (const Wiring::Analog& it : wiring_.analogs) {
      if (it.converter == stm32f407::kConverter && it.input == input) return gpio(it.pin.port).mode(it.pin.number) == 3;
    }
    return false;
  };
  adc_ = std::make_unique<Adc>(world_, stm32f407::kConverter, Adc::Wiring{clock_of(stm32f407::kAdcs.bus), is_analog});
  place(stm32f407::kAdcs, *adc_);
}

void Chip::connect() {
  rcc.crystal_hz = wiring_.crystal_hz;
  for (const Wiring::I2cWires& it : wiring_.i2cs) {
    if (I2c* bus = i2c(it.port)) connect_wires(*bus, it.scl, it.sda);
  }
}

std::function<std::uint32_t()> Chip::clock_of(ClockBus bus) {
  return [this, bus] { return bus == ClockBus::apb1 ? rcc.apb1_hz() : rcc.apb2_hz(); };
}

/// The pins of a bus as they are when the master takes them from the peripheral to clock by hand.
void Chip::connect_wires(I2c& i2c, PinPlace scl, PinPlace sda) {
  Gpio& scl_gpio = gpio(scl.port);
  Gpio& sda_gpio = gpio(sda.port);
  scl_gpio.watcher[scl.number] = [&i2c](bool output, bool high) { i2c.line.set_scl(!output || high); };
  sda_gpio.watcher[sda.number] = [&i2c](bool output, bool high) { i2c.line.set_sda(!output || high); };
  scl_gpio.wire[scl.number] = [&i2c] { return i2c.line.scl(); };
  sda_gpio.wire[sda.number] = [&i2c] { return i2c.line.sda(); };
}

void Chip::reset() { reset_all(); }

Usart* Chip::usart(const std::string& name) { return named(usarts_, name); }
I2c* Chip::i2c(const std::string& name) { return named(i2cs_, name); }
Can* Chip::can(const std::string& name) { return named(cans_, name); }
Spi* Chip::spi(const std::string& name) { return named(spis_, name); }
Adc* Chip::adc(const std::string& name) { return name == adc_->name() ? adc_.get() : nullptr; }

void Chip::attach_spi(Spi& spi, char port, unsigned pin, SpiPart part) {
  const std::size_t number = spi.attach(std::move(part));
  gpio(port).watcher[pin] = [&spi, number](bool output, bool high) { spi.selected(number, output && !high); };
}

bool Chip::attach_spi(const std::string& name, unsigned select, SpiPart part) {
  for (const Wiring::Select& it : wiring_.selects) {
    if (name != it.port || select-- != 0) continue;
    attach_spi(*spi(name), it.pin.port, it.pin.number, std::move(part));
    return true;
  }
  return false;
}

bool Chip::break_dma(const std::string& port) {
  const auto stop = [&](const auto& table) {
    for (const stm32f407::Stream& it : table) {
      if (port == it.name) return dma1_->break_stream(it.rx) || dma2_->break_stream(it.rx);
    }
    return false;
  };
  return stop(stm32f407::kUsarts) || stop(stm32f407::kSpis);
}

std::pair<Timer*, unsigned> Chip::pwm(const std::string& name) {
  for (const Wiring::Pulse& it : wiring_.pulses) {
    if (it.port == name) return {named(timers_, it.timer), it.channel};
  }
  return {nullptr, 0};
}

}  // namespace finemote::emulator
