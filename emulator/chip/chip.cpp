#include "emulator/chip/chip.hpp"

namespace finemote::emulator {
namespace {

std::string hex(std::uint32_t value) {
  char text[16];
  std::snprintf(text, sizeof text, "0x%08X", value);
  return text;
}

constexpr std::uint32_t kFirst = 0x40000000;  ///< address of the first peripheral

/// The bridge an address lies behind: RM0090 2.3, table 1.
enum class Bridge { none, apb1, apb2 };
constexpr Bridge bridge_of(std::uint32_t address) {
  return address < 0x40010000 ? Bridge::apb1 : address < 0x40020000 ? Bridge::apb2 : Bridge::none;
}

/// Cycles a read waits for the bridge: APB2 at half, APB1 at a quarter of the core clock. A documented choice.
constexpr unsigned wait_of(Bridge bridge) { return bridge == Bridge::apb1 ? 4 : bridge == Bridge::apb2 ? 2 : 0; }

}  // namespace

// Addresses: RM0090 2.3, table 1. Clock enable bits: RM0090 7.3.10 to 7.3.14. Lines: RM0090 12.2, table 62.
Chip::Chip(World& world)
    : rcc(world), flash(world), pwr(world), exti(world), syscfg(world), iwdg(world), world_(world), dma_side_(*this) {
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
  const ClockBus one = ClockBus::apb1, two = ClockBus::apb2;
  using R = DmaRequest;
  add_usart(0x40011000, "usart1", two, 4, 37, R::usart1_rx, R::usart1_tx);
  add_usart(0x40004800, "usart3", one, 18, 39, R::usart3_rx, R::usart3_tx);
  add_usart(0x40011400, "usart6", two, 5, 71, R::usart6_rx, R::usart6_tx);
  add_i2c(0x40005800, "i2c2", 22, 33, 34);
  add_i2c(0x40005C00, "i2c3", 23, 72, 73);
  connect_wires(*i2c("i2c2"), 'F', 1, 'F', 0);
  connect_wires(*i2c("i2c3"), 'A', 8, 'C', 9);
  can1_ = std::make_unique<Can>(world, "can1", Can::Lines{19, 20, 22}, can_filters_, false, clock_of(one));
  can2_ = std::make_unique<Can>(world, "can2", Can::Lines{63, 64, 66}, can_filters_, true, clock_of(one));
  place(0x40006400, *can1_, one, 25);
  place(0x40006800, *can2_, one, 26);
  add_spi(0x40013000, "spi1", two, 12, 35, R::spi1_rx, R::spi1_tx);
  add_spi(0x40003800, "spi2", one, 14, 36, R::spi2_rx, R::spi2_tx);
  const TimerKind advanced{true, false}, wide{false, true};
  add_timer(0x40010000, "tim1", two, 0, 25, advanced);
  add_timer(0x40010400, "tim8", two, 1, 44, advanced);
  add_timer(0x40000800, "tim4", one, 2, 30);
  add_timer(0x40000C00, "tim5", one, 3, 50, wide);
  add_timer(0x40014400, "tim10", two, 17, 25);
  // The clock of ADC3 stands for the block: bit 10, RM0090 7.3.14. Input 8 is PF10: DS8626 table 7.
  adc3_ = std::make_unique<Adc>(world, "adc3", Adc::Wiring{clock_of(two), [this](unsigned input) {
                                                             return input == 8 && gpio('F').mode(10) == 3;
                                                           }});
  place(0x40012000, *adc3_, ClockBus::apb2, 10);
  // What the board leaves unconnected: for images of others.
  add_usart(0x40004400, "usart2", one, 17, 38, R::usart2_rx, R::usart2_tx);
  add_usart(0x40004C00, "uart4", one, 19, 52, R::uart4_rx, R::uart4_tx);
  add_usart(0x40005000, "uart5", one, 20, 53, R::uart5_rx, R::uart5_tx);
  add_i2c(0x40005400, "i2c1", 21, 31, 32);
  add_spi(0x40003C00, "spi3", one, 15, 51, R::spi3_rx, R::spi3_tx);
  add_timer(0x40000000, "tim2", one, 0, 28, wide);
  add_timer(0x40000400, "tim3", one, 1, 29);
  add_timer(0x40001000, "tim6", one, 4, 54);
  add_timer(0x40001400, "tim7", one, 5, 55);
  add_timer(0x40001800, "tim12", one, 6, 43);
  add_timer(0x40001C00, "tim13", one, 7, 44);
  add_timer(0x40002000, "tim14", one, 8, 45);
  add_timer(0x40014000, "tim9", two, 16, 24);
  add_timer(0x40014800, "tim11", two, 18, 26);
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

std::function<std::uint32_t()> Chip::clock_of(ClockBus bus) {
  return [this, bus] { return bus == ClockBus::apb1 ? rcc.apb1_hz() : rcc.apb2_hz(); };
}

void Chip::add_usart(std::uint32_t base, const char* name, ClockBus bus, unsigned bit, int line, DmaRequest rx,
                     DmaRequest tx) {
  const auto dma = [this](DmaRequest request) { return serve_dma(request); };
  usarts_.push_back(std::make_unique<Usart>(world_, name, Usart::Wiring{line, rx, tx, clock_of(bus), dma}));
  place(base, *usarts_.back(), bus, bit);
}

void Chip::add_spi(std::uint32_t base, const char* name, ClockBus bus, unsigned bit, int line, DmaRequest rx,
                   DmaRequest tx) {
  const auto dma = [this](DmaRequest request) { return serve_dma(request); };
  spis_.push_back(std::make_unique<Spi>(world_, name, Spi::Wiring{line, rx, tx, clock_of(bus), dma}));
  place(base, *spis_.back(), bus, bit);
}

void Chip::add_i2c(std::uint32_t base, const char* name, unsigned bit, int event_line, int error_line) {
  i2cs_.push_back(std::make_unique<I2c>(world_, name, event_line, error_line, clock_of(ClockBus::apb1)));
  place(base, *i2cs_.back(), ClockBus::apb1, bit);
}

void Chip::add_timer(std::uint32_t base, const char* name, ClockBus bus, unsigned bit, int line, TimerKind kind) {
  const auto set_line = [this, line](bool high) {
    unsigned& holders = timer_lines_[static_cast<std::size_t>(line)];
    holders += high ? 1 : -1U;
    world_.set_line(line, holders != 0);
  };
  timers_.push_back(std::make_unique<Timer>(
      world_, name, kind, [this, bus] { return rcc.timer_hz(bus); }, set_line));
  place(base, *timers_.back(), bus, bit);
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
  lowered_ = {};
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
  if (bytes == 4)
    slot->peripheral->write(offset, *value);
  else
    slot->peripheral->write_part(offset, mask << shift, (*value & mask) << shift);
  return 0;
}

std::uint32_t Chip::read(std::uint32_t address, unsigned bytes) {
  const Bridge bridge = bridge_of(address);
  if (bridge == bridge_of(lowered_.address)) lowered_.line = -1;  // it comes after the write that went the same way
  const Slot* slot = find(address);
  if (slot != nullptr) world_.cpu().add_wait(wait_of(bridge));
  return access(slot, address, bytes, nullptr);
}

void Chip::write(std::uint32_t address, unsigned bytes, std::uint32_t value) {
  static_cast<void>(world_.system().nvic().take_lowered());
  access(address, bytes, &value);
  if (const int line = world_.system().nvic().take_lowered(); line >= 0) lowered_ = {line, address, world_.now()};
}

/// Cycles from a store until the interrupt controller sees the line it lowered: two through the write buffer and the
/// bus matrix, two for the line; a bridge may wait a clock of its bus and takes two for the transfer. A documented
/// choice, on the safe side.
unsigned Chip::settling_cycles(std::uint32_t address) const {
  constexpr unsigned kStore = 2, kLine = 2, kTransfer = 3;
  const Bridge bridge = bridge_of(address);
  if (bridge == Bridge::none) return kStore + kLine;
  const std::uint32_t bus_hz = bridge == Bridge::apb1 ? rcc.apb1_hz() : rcc.apb2_hz();
  return kStore + kLine + kTransfer * (rcc.core_hz() / bus_hz);
}

/// The line of a routine that returns may still look high to the interrupt controller, which then enters it again. Not
/// so when a DSB or a read on the same bus came after the store, or time enough; nor is it the store's fault when the
/// line has risen since: then the routine is entered again anyway.
void Chip::returning(int exception) {
  const int line = lowered_.line;
  if (line < 0 || line + 16 != exception) return;
  lowered_.line = -1;
  const Nvic& nvic = world_.system().nvic();
  if (nvic.is_high(line) || nvic.is_pending(exception) || world_.cpu().drained_at() > lowered_.at) return;
  if (world_.now() - lowered_.at >= settling_cycles(lowered_.address) * world_.system().clock().period()) return;
  world_.report(Misuse::late_flag,
                "line " + std::to_string(line) + " is cleared as the last thing of its routine, without read-back");
}

Usart* Chip::usart(const std::string& name) {
  for (const auto& usart : usarts_) {
    if (usart->name() == name) return usart.get();
  }
  return nullptr;
}

I2c* Chip::i2c(const std::string& name) {
  for (const auto& i2c : i2cs_) {
    if (i2c->name() == name) return i2c.get();
  }
  return nullptr;
}

Can* Chip::can(const std::string& name) {
  return name == "can1" ? can1_.get() : name == "can2" ? can2_.get() : nullptr;
}

Spi* Chip::spi(const std::string& name) {
  for (const auto& spi : spis_) {
    if (spi->name() == name) return spi.get();
  }
  return nullptr;
}

void Chip::attach_spi(Spi& spi, char port, unsigned pin, SpiPart part) {
  const std::size_t number = spi.attach(std::move(part));
  gpio(port).watcher[pin] = [&spi, number](bool output, bool high) { spi.selected(number, output && !high); };
}

namespace {

/// A pin that selects a part at an SPI port.
struct SpiSelect {
  const char* spi;
  char port;
  unsigned pin;
};
constexpr SpiSelect kSpiSelects[] = {{"spi1", 'A', 4}, {"spi1", 'B', 0}, {"spi2", 'B', 12}};  // of the board

}  // namespace

unsigned Chip::spi_selects(const std::string& name) {
  unsigned count = 0;
  for (const SpiSelect& it : kSpiSelects) count += name == it.spi ? 1 : 0;
  return count;
}

bool Chip::attach_spi(const std::string& name, unsigned select, SpiPart part) {
  for (const SpiSelect& it : kSpiSelects) {
    if (name != it.spi || select-- != 0) continue;
    attach_spi(*spi(name), it.port, it.pin, std::move(part));
    return true;
  }
  return false;
}

bool Chip::break_dma(const std::string& port) {
  constexpr std::pair<const char*, DmaRequest> kReceiving[] = {
      {"usart1", DmaRequest::usart1_rx}, {"usart3", DmaRequest::usart3_rx}, {"usart6", DmaRequest::usart6_rx},
      {"usart2", DmaRequest::usart2_rx}, {"uart4", DmaRequest::uart4_rx},   {"uart5", DmaRequest::uart5_rx},
      {"spi1", DmaRequest::spi1_rx},     {"spi2", DmaRequest::spi2_rx},     {"spi3", DmaRequest::spi3_rx},
  };
  for (const auto& [name, request] : kReceiving) {
    if (port == name) return dma1_->break_stream(request) || dma2_->break_stream(request);
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
