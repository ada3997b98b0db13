#include "emulator/chip/chip.hpp"

#include <stdexcept>
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
      wwdg(world, clock_of(ClockBus::apb1)),
      rtc(world, {[this] { return rcc.rtc_hz(); }, [this] { return pwr.opens_backup(); }}),
      rng(world, [this] { return rcc.usb_hz(); }),
      crc(world),
      dac(world),
      usb(world),
      world_(world),
      wiring_(std::move(wiring)) {
  add_system();
  add_ports();
  add_dma();
  add_buses();
  add_timers();
  add_converters();
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
  place(stm32f407::kWwdg, wwdg);
  place(stm32f407::kRtc, rtc);
  place(stm32f407::kRng, rng);
  place(stm32f407::kCrc, crc);
  place(stm32f407::kDac, dac);
  place(stm32f407::kUsb, usb, Usb::kKib);
  rcc.backup.is_open = [this] { return pwr.opens_backup(); };
  rcc.backup.before_change = [this] { rtc.clock_changes(); };
  rcc.backup.on_reset = [this] { rtc.reset_domain(); };
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
  const auto dma_left = [this](DmaRequest request) { return dma1_->left(request); };
  for (const auto& it : stm32f407::kI2cs) {
    const I2c::Wiring wiring{it.event_line, it.error_line, it.rx, it.tx, clock_of(it.place.bus), dma, dma_left};
    i2cs_.push_back(std::make_unique<I2c>(world_, it.name, wiring));
    place(it.place, *i2cs_.back());
  }
  for (const auto& it : stm32f407::kCans) {
    cans_.push_back(
        std::make_unique<Can>(world_, it.name, it.lines, can_filters_, it.is_second, clock_of(it.place.bus)));
    place(it.place, *cans_.back());
  }
}

std::function<void(bool)> Chip::shared_line(int line) {
  return [this, line](bool high) {
    unsigned& holders = line_holders_[static_cast<std::size_t>(line)];
    holders += high ? 1 : -1U;
    world_.set_line(line, holders != 0);
  };
}

void Chip::add_timers() {
  for (const auto& it : stm32f407::kTimers) {
    const auto clock = [this, bus = it.place.bus] { return rcc.timer_hz(bus); };
    const Timer::Lines lines{shared_line(it.line), shared_line(it.compare_line)};
    timers_.push_back(std::make_unique<Timer>(world_, it.name, it.kind, clock, lines));
    place(it.place, *timers_.back());
  }
  named(timers_, "tim5")->lead_in({4, 3U << 6, 1U << 6, [this] { return rcc.running_lsi_hz(); }});
  named(timers_, "tim11")->lead_in({1, 3, 2, [this] { return rcc.divided_crystal_hz(); }});
}

Adc::Wiring Chip::converter_wiring(unsigned number) {
  const stm32f407::AdcEntry& entry = stm32f407::kAdcEntries[number];
  const auto is_analog = [this, &entry](unsigned input) {
    const PinPlace pin = pin_place(entry.pins[input]);
    return gpio(pin.port).mode(pin.number) == 3;
  };
  const auto dma = [this](DmaRequest request) { return dma2_->serve(request); };
  return {clock_of(stm32f407::kAdcs.bus), is_analog, dma, entry.request, shared_line(stm32f407::kAdcLine)};
}

void Chip::add_converters() {
  adcs_ = std::make_unique<AdcBlock>(world_, [this](unsigned number) { return converter_wiring(number); });
  // Inside the first: 25 degrees Celsius, the reference, a battery that is not there. DS8626 5.3.22, 5.3.24.
  Adc& first = adcs_->converter(0);
  first.volts[16] = 0.76;
  first.volts[17] = 1.21;
  place(stm32f407::kAdcs, *adcs_);
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
Adc* Chip::adc(const std::string& name) {
  for (unsigned i = 0; i < AdcBlock::kConverters; ++i) {
    if (adcs_->converter(i).name() == name) return &adcs_->converter(i);
  }
  return nullptr;
}

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

bool Chip::break_dma(const std::string& port, DmaWay way) {
  const auto stop = [&](const auto& table) {
    for (const stm32f407::Stream& it : table) {
      const DmaRequest request = way == DmaWay::receive ? it.rx : it.tx;
      if (port == it.name) return dma1_->break_stream(request) || dma2_->break_stream(request);
    }
    return false;
  };
  return stop(stm32f407::kUsarts) || stop(stm32f407::kSpis);
}

PinPlace Chip::pulse_pin(const std::string& name) const {
  for (const Wiring::Pulse& it : wiring_.pulses) {
    if (it.port == name) return it.pin;
  }
  throw std::invalid_argument("the board has no pulse output '" + name + "'");
}

std::pair<Timer*, unsigned> Chip::pwm(const std::string& name) {
  for (const Wiring::Pulse& it : wiring_.pulses) {
    if (it.port == name) return {named(timers_, it.timer), it.channel};
  }
  return {nullptr, 0};
}

}  // namespace finemote::emulator
