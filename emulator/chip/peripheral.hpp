// What every peripheral of the chip has in common, and what it finds around it.
#pragma once

#include <array>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>

#include "emulator/core/cpu.hpp"
#include "emulator/core/system_space.hpp"
#include "emulator/event_queue.hpp"
#include "emulator/report.hpp"
#include "emulator/silicon/silicon.hpp"

namespace finemote::emulator {

/// Time, events, interrupts, memory and the report list, for peripherals and parts alike.
class World {
 public:
  World() : system_(queue_, reports_) {}

  [[nodiscard]] Time now() const { return cpu_ != nullptr ? cpu_->now() : 0; }
  void after(Time delay, EventQueue::Action action) { queue_.at(event_time() + delay, std::move(action)); }
  void at(Time time, EventQueue::Action action) { queue_.at(time, std::move(action)); }
  void report(Misuse misuse, const std::string& text) {
    reports_.add(misuse, text, now(), cpu_ != nullptr ? cpu_->pc() : 0, touched_);
  }
  /// The register at this address is accessed: reports name it; nothing: no longer.
  void touch(std::optional<std::uint32_t> address) { touched_ = address; }
  void set_line(int line, bool high) { system_.nvic().set_line(line, high); }

  /// Tags of the word that a peripheral is asked for or given, its lowest byte first: it reads them at a store, and
  /// sets them where it answers a load with bytes of known origin.
  WordTags& crossing() { return tags_.crossing; }
  Provenance& provenance() { return provenance_; }
  TagFlow& tags() { return tags_; }

  EventQueue& queue() { return queue_; }
  Reports& reports() { return reports_; }
  [[nodiscard]] const Reports& reports() const { return reports_; }
  SystemSpace& system() { return system_; }
  Silicon& silicon() { return silicon_; }
  Cpu& cpu() { return *cpu_; }
  void connect(Cpu& cpu) { cpu_ = &cpu; }

 private:
  /// Events run a little late when an instruction straddles them; what follows them counts from their own time, so that
  /// a byte follows the one before without a gap.
  [[nodiscard]] Time event_time() const { return queue_.running() != kNever ? queue_.running() : now(); }

  EventQueue queue_;
  Reports reports_;
  Silicon silicon_;
  SystemSpace system_;
  Provenance provenance_;
  TagFlow tags_{provenance_};
  Cpu* cpu_ = nullptr;
  std::optional<std::uint32_t> touched_;
};

/// A block of registers at one address.
class Peripheral {
 public:
  Peripheral(World& world, std::string name) : world_(world), name_(std::move(name)) {}
  virtual ~Peripheral() = default;
  Peripheral(const Peripheral&) = delete;
  Peripheral& operator=(const Peripheral&) = delete;

  [[nodiscard]] const std::string& name() const { return name_; }
  /// Of a block of several: who answers at `offset`, and which bits enable its clock, `first` being that of the block.
  [[nodiscard]] virtual std::string name_at(std::uint32_t offset) const {
    static_cast<void>(offset);
    return name_;
  }
  [[nodiscard]] virtual std::uint32_t clock_bits(std::uint32_t offset, unsigned first) const {
    static_cast<void>(offset);
    return 1U << first;
  }
  /// Word access; `offset` is a multiple of 4.
  virtual std::uint32_t read(std::uint32_t offset) = 0;
  virtual void write(std::uint32_t offset, std::uint32_t value) = 0;
  /// A byte or halfword of the register, `value` and `mask` in its place. Most registers take words only.
  virtual void write_part(std::uint32_t offset, std::uint32_t mask, std::uint32_t value) {
    if ((mask & 1) == 0) world_.report(Misuse::unmodelled, name_ + " is written in the middle of a register");
    while ((mask & 1) == 0) {
      mask >>= 1;
      value >>= 1;
    }
    write(offset, value);
  }
  virtual void reset() = 0;
  /// A DMA stream was turned on: peripherals that wait for one ask again.
  virtual void poll_dma() {}

 protected:
  std::uint32_t unmodelled_read(std::uint32_t offset) {
    world_.report(Misuse::unmodelled, name_ + " register at offset " + hex(offset) + " read");
    return 0;
  }
  void unmodelled_write(std::uint32_t offset) {
    world_.report(Misuse::unmodelled, name_ + " register at offset " + hex(offset) + " written");
  }
  /// Bits of `value` the model does not know.
  void only(std::uint32_t value, std::uint32_t known, const char* what) {
    if ((value & ~known) != 0) world_.report(Misuse::unmodelled, name_ + " " + what + " bits " + hex(value & ~known));
  }
  static std::string hex(std::uint32_t value) {
    char text[16];
    std::snprintf(text, sizeof text, "0x%X", value);
    return text;
  }

  World& world_;

 private:
  std::string name_;
};

}  // namespace finemote::emulator
