#include "emulator/chip/chip.hpp"

namespace finemote::emulator {
namespace {

std::string hex(std::uint32_t value) {
  char text[16];
  std::snprintf(text, sizeof text, "0x%08X", value);
  return text;
}

/// Cycles an access waits for the bus bridge: APB2 at half, APB1 at a quarter of the core clock. A documented choice.
constexpr unsigned wait_of(ClockBus bus) { return bus == ClockBus::apb1 ? 4 : bus == ClockBus::apb2 ? 2 : 0; }

constexpr std::uint32_t kFirst = 0x40000000;  ///< address of the first peripheral

/// A flag cleared fewer cycles than this before the return may still raise its line.
constexpr unsigned kLateCycles = 8;

}  // namespace

// Addresses: RM0090 2.3, table 1. Clock enable bits: RM0090 7.3.10 to 7.3.14. Lines: RM0090 12.2, table 62.
Chip::Chip(World& world)
    : rcc(world), flash(world), pwr(world), exti(world), syscfg(world), iwdg(world), world_(world), dma_side_(*this) {
  const auto apb1 = [this] { return rcc.apb1_hz(); };
  const auto apb2 = [this] { return rcc.apb2_hz(); };
  const auto timer1 = [this] { return rcc.timer_hz(ClockBus::apb1); };
  const auto timer2 = [this] { return rcc.timer_hz(ClockBus::apb2); };
  const auto dma = [this](DmaRequest request) { return serve_dma(request); };
  place(0x40023800, rcc, ClockBus::always, 0);
  place(0x40023C00, flash, ClockBus::always, 0);
  place(0x40003000, iwdg, ClockBus::always, 0);
  place(0x40007000, pwr, ClockBus::apb1, 28);
  place(0x40013800, syscfg, ClockBus::apb2, 14);
  place(0x40013C00, exti, ClockBus::always, 0);
  for (char port = 'A'; port <= 'I'; ++port) {
    gpios_.push_back(std::make_unique<Gpio>(world, port));
    const auto index = static_cast<unsigned>(port - 'A');
    place(0x40020000 + 0x400 * index, *gpios_.back(), ClockBus::ahb1, index);
    gpios_.back()->on_level = [this, index](unsigned pin, bool high) {
      if (syscfg.source(pin) == index) exti.edge(pin, high);
    };
  }
  dma1_ = std::make_unique<Dma>(world, 1, dma_side_);
  dma2_ = std::make_unique<Dma>(world, 2, dma_side_);
  place(0x40026000, *dma1_, ClockBus::ahb1, 21);
  place(0x40026400, *dma2_, ClockBus::ahb1, 22);
  usart1_ = std::make_unique<Usart>(world, "usart1",
                                    Usart::Wiring{37, DmaRequest::usart1_rx, DmaRequest::usart1_tx, apb2, dma});
  usart3_ = std::make_unique<Usart>(world, "usart3",
                                    Usart::Wiring{39, DmaRequest::usart3_rx, DmaRequest::usart3_tx, apb1, dma});
  usart6_ = std::make_unique<Usart>(world, "usart6",
                                    Usart::Wiring{71, DmaRequest::usart6_rx, DmaRequest::usart6_tx, apb2, dma});
  place(0x40011000, *usart1_, ClockBus::apb2, 4);
  place(0x40004800, *usart3_, ClockBus::apb1, 18);
  place(0x40011400, *usart6_, ClockBus::apb2, 5);
  i2c2_ = std::make_unique<I2c>(world, "i2c2", 33, 34, apb1);
  i2c3_ = std::make_unique<I2c>(world, "i2c3", 72, 73, apb1);
  place(0x40005800, *i2c2_, ClockBus::apb1, 22);
  place(0x40005C00, *i2c3_, ClockBus::apb1, 23);
  connect_wires(*i2c2_, 'F', 1, 'F', 0);
  connect_wires(*i2c3_, 'A', 8, 'C', 9);
  can1_ = std::make_unique<Can>(world, "can1", Can::Lines{19, 20, 22}, can_filters_, false, apb1);
  can2_ = std::make_unique<Can>(world, "can2", Can::Lines{63, 64, 66}, can_filters_, true, apb1);
  place(0x40006400, *can1_, ClockBus::apb1, 25);
  place(0x40006800, *can2_, ClockBus::apb1, 26);
  spi1_ = std::make_unique<Spi>(world, "spi1", Spi::Wiring{35, DmaRequest::spi1_rx, DmaRequest::spi1_tx, apb2, dma});
  spi2_ = std::make_unique<Spi>(world, "spi2", Spi::Wiring{36, DmaRequest::spi2_rx, DmaRequest::spi2_tx, apb1, dma});
  place(0x40013000, *spi1_, ClockBus::apb2, 12);
  place(0x40003800, *spi2_, ClockBus::apb1, 14);
  const auto add_timer = [&](std::uint32_t base, const char* name, ClockBus bus, unsigned bit, int line) {
    const bool advanced = bit < 2 && bus == ClockBus::apb2;
    timers_.push_back(std::make_unique<Timer>(
        world, name, advanced,
        bus == ClockBus::apb1 ? std::function<std::uint32_t()>(timer1) : std::function<std::uint32_t()>(timer2), line));
    place(base, *timers_.back(), bus, bit);
  };
  add_timer(0x40010000, "tim1", ClockBus::apb2, 0, 25);
  add_timer(0x40010400, "tim8", ClockBus::apb2, 1, 44);
  add_timer(0x40000800, "tim4", ClockBus::apb1, 2, 30);
  add_timer(0x40000C00, "tim5", ClockBus::apb1, 3, 50);
  add_timer(0x40014400, "tim10", ClockBus::apb2, 17, 25);
  // The clock of ADC3 stands for the block: bit 10, RM0090 7.3.14. Input 8 is PF10: DS8626 table 7.
  adc3_ = std::make_unique<Adc>(
      world, "adc3", Adc::Wiring{apb2, [this](unsigned input) { return input == 8 && gpio('F').mode(10) == 3; }});
  place(0x40012000, *adc3_, ClockBus::apb2, 10);
  const auto poll = [this] {
    for (const Slot& slot : slots_) slot.peripheral->poll_dma();
  };
  dma1_->on_enable = poll;
  dma2_->on_enable = poll;
  rcc.wait_states = [this] { return flash.wait_states(); };
  rcc.reset_peripheral = [this](ClockBus bus, unsigned bit) {
    for (const Slot& slot : slots_) {
      if (slot.bus == bus && slot.bit == bit) slot.peripheral->reset();
    }
  };
  reset();
}

void Chip::place(std::uint32_t base, Peripheral& peripheral, ClockBus bus, unsigned bit, std::uint32_t bytes) {
  slots_.push_back(Slot{base, bytes, &peripheral, bus, bit});
  const std::size_t first = (base - kFirst) / 0x400, end = first + (bytes + 0x3FF) / 0x400;
  if (slot_at_.size() < end) slot_at_.resize(end);
  for (std::size_t at = first; at < end; ++at) slot_at_[at] = static_cast<std::uint8_t>(slots_.size());
}

/// The pins of a bus as they are when the master takes them from the peripheral to clock by hand.
void Chip::connect_wires(I2c& i2c, char port, unsigned scl, char sda_port, unsigned sda) {
  Gpio& scl_gpio = gpio(port);
  Gpio& sda_gpio = gpio(sda_port);
  scl_gpio.watcher[scl] = [&i2c](bool output, bool high) { i2c.line.set_scl(!output || high); };
  sda_gpio.watcher[sda] = [&i2c](bool output, bool high) { i2c.line.set_sda(!output || high); };
  scl_gpio.wire[scl] = [&i2c] { return i2c.line.scl(); };
  sda_gpio.wire[sda] = [&i2c] { return i2c.line.sda(); };
}

void Chip::reset() {
  for (const Slot& slot : slots_) slot.peripheral->reset();
}

const Chip::Slot* Chip::find(std::uint32_t address) const {
  const std::size_t at = (address - kFirst) / 0x400;
  const unsigned number = at < slot_at_.size() ? slot_at_[at] : 0;
  if (number == 0) return nullptr;
  const Slot& slot = slots_[number - 1];
  return address - slot.base < slot.bytes ? &slot : nullptr;
}

/// @param value  to write; null to read
std::uint32_t Chip::access(const Slot* slot, std::uint32_t address, unsigned bytes, const std::uint32_t* value) {
  if (slot == nullptr) {
    world_.report(Misuse::unmodelled, "peripheral address " + hex(address & ~0x3FFU));
    return 0;
  }
  if (!rcc.clocked(slot->bus, slot->bit)) {
    world_.report(Misuse::unclocked, slot->peripheral->name() + " is touched before its clock is on");
    return 0;
  }
  const std::uint32_t offset = (address - slot->base) & ~3U, shift = (address & 3) * 8;
  const std::uint32_t mask = bytes == 4 ? ~0U : (1U << (8 * bytes)) - 1;
  if (value == nullptr) return slot->peripheral->read(offset) >> shift & mask;
  if (shift != 0)
    world_.report(Misuse::unmodelled, slot->peripheral->name() + " is written in the middle of a register");
  slot->peripheral->write(offset, *value & mask);
  return 0;
}

std::uint32_t Chip::read(std::uint32_t address, unsigned bytes) {
  lowered_line_ = -1;
  const Slot* slot = find(address);
  if (slot != nullptr) world_.cpu().add_wait(wait_of(slot->bus));
  return access(slot, address, bytes, nullptr);
}

void Chip::write(std::uint32_t address, unsigned bytes, std::uint32_t value) {
  static_cast<void>(world_.system().nvic().take_lowered());
  access(address, bytes, &value);
  if (const int line = world_.system().nvic().take_lowered(); line >= 0) {
    lowered_line_ = line;
    lowered_at_ = world_.now();
  }
}

void Chip::returning(int exception) {
  if (lowered_line_ < 0 || lowered_line_ + 16 != exception) return;
  if (world_.now() - lowered_at_ < kLateCycles * world_.system().clock().period()) {
    world_.report(Misuse::late_flag, "line " + std::to_string(lowered_line_) +
                                         " is cleared as the last thing of its routine, without read-back");
  }
  lowered_line_ = -1;
}

Usart* Chip::usart(const std::string& name) {
  for (Usart* usart : {usart1_.get(), usart3_.get(), usart6_.get()}) {
    if (usart->name() == name) return usart;
  }
  return nullptr;
}

I2c* Chip::i2c(const std::string& name) {
  for (I2c* i2c : {i2c2_.get(), i2c3_.get()}) {
    if (i2c->name() == name) return i2c;
  }
  return nullptr;
}

Can* Chip::can(const std::string& name) {
  return name == "can1" ? can1_.get() : name == "can2" ? can2_.get() : nullptr;
}

Spi* Chip::spi(const std::string& name) {
  return name == "spi1" ? spi1_.get() : name == "spi2" ? spi2_.get() : nullptr;
}

void Chip::attach_spi(Spi& spi, char port, unsigned pin, SpiPart part) {
  const std::size_t number = spi.attach(std::move(part));
  gpio(port).watcher[pin] = [&spi, number](bool output, bool high) { spi.selected(number, output && !high); };
}

bool Chip::attach_spi(const std::string& name, unsigned select, SpiPart part) {
  struct Select {
    const char* spi;
    char port;
    unsigned pin;
  };
  constexpr Select kSelects[] = {{"spi1", 'A', 4}, {"spi1", 'B', 0}, {"spi2", 'B', 12}};  // of the board
  for (const Select& it : kSelects) {
    if (name != it.spi || select-- != 0) continue;
    attach_spi(*spi(name), it.port, it.pin, std::move(part));
    return true;
  }
  return false;
}

std::pair<Timer*, unsigned> Chip::pwm(const std::string& name) {
  const auto timer = [this](std::size_t index) { return timers_[index].get(); };  // in the order they were added
  if (name == "led_blue") return {timer(3), 1};
  if (name == "led_green") return {timer(3), 2};
  if (name == "led_red") return {timer(3), 3};
  if (name == "buzzer") return {timer(2), 3};
  if (name == "imu_heater") return {timer(4), 1};
  if (name.size() != 4 || name.compare(0, 3, "pwm") != 0 || name[3] < '1' || name[3] > '7') return {nullptr, 0};
  const auto number = static_cast<unsigned>(name[3] - '0');
  return number <= 4 ? std::pair(timer(0), number) : std::pair(timer(1), number - 4);
}

}  // namespace finemote::emulator
