// Runs the image: a Cortex-M4 instruction by instruction, with exceptions, sleep and time around the interpreter.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "emulator/core/cost.hpp"
#include "emulator/core/execution_log.hpp"
#include "emulator/core/image.hpp"
#include "emulator/core/interpreter.hpp"
#include "emulator/core/interrupted.hpp"
#include "emulator/core/provenance.hpp"
#include "emulator/core/system_space.hpp"
#include "emulator/core/tag_flow.hpp"
#include "emulator/event_queue.hpp"
#include "emulator/report.hpp"
#include "emulator/silicon/silicon.hpp"

namespace finemote::emulator {

/// The chip's peripheral addresses as the processor sees them.
class PeripheralBus {
 public:
  virtual ~PeripheralBus() = default;
  virtual std::uint32_t read(std::uint32_t address, unsigned bytes) = 0;
  virtual void write(std::uint32_t address, unsigned bytes, std::uint32_t value) = 0;
  /// A store to the flash memory, which is for its controller to judge; `address` as it stands at 0x08000000.
  virtual void store_to_flash(std::uint32_t address, unsigned bytes, std::uint32_t value) {
    static_cast<void>(address), static_cast<void>(bytes), static_cast<void>(value);
  }
  /// An interrupt routine returns.
  virtual void returning(int exception) { static_cast<void>(exception); }
};

enum class Stop {
  time,    ///< the asked time is reached
  exit,    ///< the image ended itself by semihosting
  lockup,  ///< a fault inside the hard-fault handler
  dead,    ///< asleep with nothing left that could wake it
};

class Cpu : private Outside {
 public:
  /// What the processor works with.
  struct Around {
    EventQueue& queue;
    Reports& reports;
    SystemSpace& system;
    PeripheralBus& bus;
    Provenance& provenance;
    TagFlow& tags;
    Silicon& silicon;
  };
  Cpu(const Around& around, CostModel cost, FlashModel flash);
  Cpu(const Cpu&) = delete;
  Cpu& operator=(const Cpu&) = delete;

  /// Puts the image into flash. @throws std::runtime_error when it lies elsewhere
  void load(const Image& image);
  /// Starts from the vector table; memory keeps its contents, as on the chip.
  void reset();
  Stop run_until(Time end);

  [[nodiscard]] Time now() const { return core_.pace.time; }
  [[nodiscard]] std::uint32_t pc() const { return core_.pc(); }
  [[nodiscard]] std::uint64_t instructions() const { return core_.pace.instructions; }
  /// Of `instructions()`, those carried out one by one: iterations of a jump to itself are charged together.
  [[nodiscard]] std::uint64_t executed() const { return core_.pace.instructions - core_.pace.waits; }
  /// Spent in sleep or in a jump to itself.
  [[nodiscard]] Time idle_time() const { return idle_ + core_.pace.waited; }
  [[nodiscard]] int exit_code() const { return exit_code_; }
  [[nodiscard]] const std::string& console() const { return console_; }
  [[nodiscard]] const std::vector<int>& active_exceptions() const { return active_; }

  /// Flash, RAM or core-coupled RAM behind `address`, also by what stands at 0; null when not all bytes lie in one.
  [[nodiscard]] std::uint8_t* memory(std::uint32_t address, std::uint32_t bytes);
  /// Neither core-coupled RAM nor what stands at 0: RM0090 2.1, 2.4.
  [[nodiscard]] static bool dma_reaches(std::uint32_t address) {
    return (address >= Memories::kFlashBase && address < Memories::kCoreRamBase) || address >= Memories::kRamBase;
  }

  /// Called before every instruction while set: for tests and counters. Slow.
  using Probe = std::function<void(std::uint32_t pc)>;
  void set_probe(Probe probe) {
    probe_ = std::move(probe);
    set_stop();
  }
  /// What happens from now on is kept in `log`, which outlives the processor; null: nowhere.
  void set_log(ExecutionLog* log);
  /// Passing the instruction at `address` of the loaded image is an event of the log with `number`; several marks of
  /// one address come in the order they were set. An image that is linked at 0 runs in RAM.
  void mark(std::uint32_t address, std::uint32_t number) { watch(address, {number, ExecutionEvent::Kind::mark}); }
  /// The same of a place of a loop.
  void watch_loop(std::uint32_t address, std::uint32_t number) { watch(address, {number, ExecutionEvent::Kind::loop}); }
  /// The device of this update keeps its stamp at `address`: what it claims when the update ends is kept with what it
  /// used.
  void find_stamp(std::uint32_t stage, std::uint32_t address) { stamps_[stage] = address; }
  /// Interrupts (and the probe) also come between the instructions of an IT block, as the core allows. Without, they
  /// wait for its end, as in QEMU.
  void interrupt_it_blocks(bool on) { interrupt_it_blocks_ = on; }
  /// Register 0..15.
  [[nodiscard]] std::uint32_t register_value(unsigned number) const {
    return number < 15 ? core_.registers.r[number] : core_.registers.next;
  }
  [[nodiscard]] bool masks_interrupts() const { return core_.registers.primask != 0; }
  /// When the last DSB was carried out.
  [[nodiscard]] Time drained_at() const { return core_.drained_at; }
  /// Time that a peripheral access costs beyond the instruction.
  void add_wait(unsigned cycles) { core_.pace.charge(cycles); }
  /// What the flash interface is set to. Without its accelerator every new line takes the wait states; a model that
  /// always misses stays what it is.
  void set_flash(bool accelerator, unsigned wait_states);
  /// The flash does not answer for `duration`: the core stands, if that is where its instructions come from.
  void stall_in_flash(Time duration);
  /// Something has written to flash, or to RAM past the processor.
  void flash_changed(std::uint32_t address, std::uint32_t bytes) { core_.take_apart_again(address, bytes); }
  void ram_changed(std::uint32_t address, std::uint32_t bytes) { core_.forget_ram(address, bytes); }
  /// What stands at 0: SRAM1, or the flash as after a reset.
  void map_ram_to_zero(bool on);
  /// An exception's routine has ended.
  std::function<void(int exception)> on_return;
  /// The image asked for a system reset (AIRCR).
  std::function<void()> on_reset_request;
  /// Looks at pending work before the next instruction.
  void kick() {
    kick_ = true;
    core_.pace.stop_at = 0;
  }

 private:
  struct MarkedPlace {
    std::uint32_t number = 0;
    ExecutionEvent::Kind kind = ExecutionEvent::Kind::mark;
  };

  bool read(std::uint32_t address, unsigned bytes, std::uint32_t& value) override;
  bool write(std::uint32_t address, unsigned bytes, std::uint32_t value) override;
  bool stops(std::uint32_t address) override;
  void masks_changed() override;
  void stack_moved() override;
  void report_unmodelled(const char* what) override;
  void passed(std::uint32_t address, Time at) override;
  void saved_float(Time at, Time took) override;
  bool may_execute(std::uint32_t address) override;

  void after_access();
  void after_core_access();
  void look_at_memory();
  [[nodiscard]] Claim claim_at_end(std::uint32_t mark);
  void watch(std::uint32_t address, MarkedPlace what);
  void set_stop() { core_.pace.stop_at = kick_ || probe_ ? 0 : next_stop_; }
  void execute();
  void wake();
  void take_exceptions();
  bool access_alias(std::uint32_t address, unsigned bytes, const std::uint32_t* written, std::uint32_t& value);
  [[nodiscard]] int priority_limit() const;
  [[nodiscard]] int takeable() const;
  [[nodiscard]] bool fits_return(std::uint32_t exc_return) const;
  void call_supervisor();
  [[nodiscard]] bool wakes() const;
  void enter(int exception, bool tail_chained, std::uint32_t chained_return);
  void leave(std::uint32_t exc_return);
  void fault(int exception, std::uint32_t cfsr, std::uint32_t address, const std::string& what);
  void semihosting();
  std::uint32_t vector(int exception);
  void note(ExecutionEvent::Kind kind, int number) {
    if (log_ != nullptr) log_->push_back({now(), static_cast<std::uint32_t>(number), kind});
  }

  EventQueue& queue_;
  Reports& reports_;
  SystemSpace& system_;
  PeripheralBus& bus_;
  Provenance& provenance_;
  TagFlow& tags_;
  Silicon& silicon_;
  std::vector<std::uint8_t> flash_, ram_, core_ram_, system_memory_;
  Interpreter core_;

  const FlashModel asked_flash_;
  Time end_ = 0, next_stop_ = 0, idle_ = 0;
  std::vector<int> active_;
  std::uint32_t guard_begin_ = 0, guard_end_ = 0;
  Probe probe_;
  ExecutionLog* log_ = nullptr;
  std::map<std::uint32_t, std::uint32_t> stamps_;    ///< addresses by stage
  std::multimap<std::uint32_t, MarkedPlace> marks_;  ///< by address
  bool masked_ = false;
  std::string console_;
  int exit_code_ = 0;
  bool kick_ = false, sleeping_ = false;
  struct ItBlock {
    std::uint32_t begin, end;
  };
  Interrupted<ItBlock> left_it_blocks_;  ///< of what the active exceptions interrupted
  bool interrupt_it_blocks_ = false;
  bool exited_ = false, locked_up_ = false;
  bool ram_at_zero_ = false;
  bool denied_ = false;    ///< by the memory protection unit, the access that failed
  int pending_fault_ = 0;  ///< found by the emulator, not by an instruction
  std::uint32_t pending_cfsr_ = 0, pending_address_ = 0;
};

}  // namespace finemote::emulator
