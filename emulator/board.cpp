#include "emulator/board.hpp"

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <utility>

#include "emulator/firmware_clock.hpp"

namespace finemote::emulator {
namespace {
constexpr unsigned kClocksLeft = 5;  // of a byte cut in the middle
constexpr Time kLogStep = from_ns(10'000'000);
}  // namespace

Board::Board(Wiring wiring, const BoardOptions& options) : chip_(world_, std::move(wiring)), options_(options) {
  if (options.tags) world_.tags().turn_on();
  world_.silicon() = options.silicon;
  world_.system().counts_in_sleep = !options.silicon.is(Strictness::cycle_count);
  const Cpu::Around around{world_.queue(),      world_.reports(), world_.system(), chip_,
                           world_.provenance(), world_.tags(),    world_.silicon()};
  cpu_ = std::make_unique<Cpu>(around, options.cost, options.flash);
  world_.connect(*cpu_);
  cpu_->set_log(&log_);
  chip_.syscfg.on_map = [this](bool ram) { cpu_->map_ram_to_zero(ram); };
  if (options.cost == CostModel::qemu) chip_.rcc.fixed_hz = kFirmwareHz;
  fill_ram();
  chip_.reset();
  chip_.rcc.lsi_hz =
      options.silicon.is(Strictness::clock_rates) ? world_.silicon().draw(Strictness::clock_rates) : options.lsi_hz;
  chip_.iwdg.lsi_hz = chip_.rcc.lsi_hz;
  chip_.iwdg.on_timeout = [this] { restart(Rcc::kWatchdogReset); };
  chip_.wwdg.on_timeout = [this] { restart(Rcc::kWindowReset); };
  cpu_->on_reset_request = [this] { restart(Rcc::kSoftwareReset); };
}

/// What it holds at power-on.
void Board::fill_ram() {
  if (!options_.silicon.is(Strictness::ram_pattern)) return;
  for (const auto& [base, bytes] : {std::pair{Memories::kRamBase, Memories::kRamBytes},
                                    std::pair{Memories::kCoreRamBase, Memories::kCoreRamBytes}}) {
    std::uint8_t* const ram = cpu_->memory(base, bytes);
    std::generate(ram, ram + bytes,
                  [this] { return static_cast<std::uint8_t>(world_.silicon().bits(Strictness::ram_pattern)); });
  }
}

void Board::load(const Image& image) {
  image_ = image;
  cpu_->load(image);
  for (const Mark& mark : image.marks) cpu_->mark(mark.address, mark.number);
  for (const StampPlace& place : image.stamps) cpu_->find_stamp(place.stage, place.address);
  if (options_.probe) trace_ = std::make_unique<TraceReader>(world_, image);
  chip_.rcc.note_reset(Rcc::kPowerReset | Rcc::kPinReset | Rcc::kBrownOutReset);
  cpu_->reset();
}

void Board::press_reset() {
  // A part in the middle of a byte does not know: it holds SDA until it has seen the rest of its clocks.
  for (const auto& i2c : chip_.i2cs()) {
    if (i2c->receiving()) i2c->line.hold_sda(kClocksLeft);
  }
  restart(0);
}

void Board::restart(std::uint32_t cause) {
  ++resets_;
  if (trace_) trace_->restarted();
  chip_.reset();
  chip_.rcc.note_reset(cause | Rcc::kPinReset);
  cpu_->reset();
}

Stop Board::run_for(std::uint64_t ns) {
  const Time end = cpu_->now() + from_ns(ns);
  Stop stop = Stop::time;
  while (cpu_->now() < end && stop == Stop::time) {  // in steps, so that the log stays short
    stop = cpu_->run_until(std::min(end, cpu_->now() + kLogStep));
    look_at_log();
  }
  return stop;
}

void Board::look_at_log() {
  own_times_.add(log_);
  loop_counts_.add(log_);
  if (options_.keeps_log) kept_.insert(kept_.end(), log_.begin(), log_.end());
  log_.clear();
}

const OwnTimes& Board::own_times() {
  look_at_log();
  return own_times_;
}

void Board::watch_loops(const std::vector<WatchedLoop>& loops) {
  for (std::size_t i = 0; i < loops.size(); ++i) {
    cpu_->watch_loop(loops[i].place, LoopCounts::number_of(i, false));
    if (loops[i].is_for_interrupts) loop_counts_.allow_interrupts(i);
    for (const std::uint32_t border : loops[i].borders) cpu_->watch_loop(border, LoopCounts::number_of(i, true));
  }
}

const LoopCounts& Board::loop_counts() {
  look_at_log();
  return loop_counts_;
}

const ExecutionLog& Board::log() {
  look_at_log();
  return kept_;
}

const std::vector<StageEvent>& Board::stages() {
  static const std::vector<StageEvent> none;
  if (!trace_) return none;
  trace_->drain();
  return trace_->events();
}

BusStatistics Board::bus(const std::string& port) {
  if (const Usart* usart = chip_.usart(port)) return usart->statistics();
  if (const I2c* i2c = chip_.i2c(port)) return i2c->statistics();
  if (const Spi* spi = chip_.spi(port)) return spi->statistics();
  if (const Can* can = chip_.can(port)) return can->line.statistics();
  return {};
}

void Board::set_word(const std::string& symbol, std::uint32_t value, std::uint32_t offset) {
  const auto found = image_.symbol(symbol);
  if (!found) throw std::runtime_error("the image has no symbol '" + symbol + "'");
  std::uint8_t* p = cpu_->memory(found->address + offset, 4);
  if (p == nullptr) return;
  std::memcpy(p, &value, 4);
  cpu_->ram_changed(found->address + offset, 4);
}

std::uint32_t Board::word(const std::string& symbol, std::uint32_t offset) {
  const auto found = image_.symbol(symbol);
  if (!found) throw std::runtime_error("the image has no symbol '" + symbol + "'");
  std::uint32_t value = 0;
  if (const std::uint8_t* p = cpu_->memory(found->address + offset, 4)) std::memcpy(&value, p, 4);
  return value;
}

}  // namespace finemote::emulator
