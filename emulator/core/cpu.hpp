// Runs the image: a Cortex-M4 instruction by instruction on libunicorn, with exceptions, sleep and time around it.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "emulator/core/cost.hpp"
#include "emulator/core/instruction.hpp"
#include "emulator/core/system_space.hpp"
#include "emulator/event_queue.hpp"
#include "emulator/image.hpp"
#include "emulator/report.hpp"

struct uc_struct;

namespace finemote::emulator {

/// The chip's peripheral addresses as the processor sees them.
class PeripheralBus {
 public:
  virtual ~PeripheralBus() = default;
  virtual std::uint32_t read(std::uint32_t address, unsigned bytes) = 0;
  virtual void write(std::uint32_t address, unsigned bytes, std::uint32_t value) = 0;
  /// An interrupt routine returns.
  virtual void returning(int exception) { static_cast<void>(exception); }
};

enum class Stop {
  time,    ///< the asked time is reached
  exit,    ///< the image ended itself by semihosting
  lockup,  ///< a fault inside the hard-fault handler
  dead,    ///< asleep with nothing left that could wake it
};

class Cpu {
 public:
  Cpu(EventQueue& queue, Reports& reports, SystemSpace& system, PeripheralBus& bus, CostModel cost, FlashModel flash);
  ~Cpu();
  Cpu(const Cpu&) = delete;
  Cpu& operator=(const Cpu&) = delete;

  /// Puts the image into flash. @throws std::runtime_error when it lies elsewhere
  void load(const Image& image);
  /// Starts from the vector table; memory keeps its contents, as on the chip.
  void reset();
  Stop run_until(Time end);

  [[nodiscard]] Time now() const { return time_; }
  [[nodiscard]] std::uint32_t pc() const { return pc_; }
  [[nodiscard]] std::uint64_t instructions() const { return instructions_; }
  [[nodiscard]] Time idle_time() const { return idle_; }
  /// Lowest stack pointer seen; 0xFFFFFFFF before the first.
  [[nodiscard]] std::uint32_t lowest_stack() const { return lowest_stack_; }
  [[nodiscard]] int exit_code() const { return exit_code_; }
  [[nodiscard]] const std::string& console() const { return console_; }
  [[nodiscard]] const std::vector<int>& active_exceptions() const { return active_; }

  /// Flash, RAM or core-coupled RAM behind `address`, or null when not all bytes lie in one of them.
  [[nodiscard]] std::uint8_t* memory(std::uint32_t address, std::uint32_t bytes);
  [[nodiscard]] static bool dma_reaches(std::uint32_t address) {
    return address < 0x10000000U || address >= 0x20000000U;
  }

  /// Called before every instruction while set: for tests and counters. Slow.
  using Probe = std::function<void(std::uint32_t pc)>;
  void set_probe(Probe probe) { probe_ = std::move(probe); }
  /// Interrupts (and the probe) also come between the instructions of an IT block, as the core allows. Without, they
  /// wait for its end, as in QEMU.
  void interrupt_it_blocks(bool on) { interrupt_it_blocks_ = on; }
  /// Register 0..15.
  [[nodiscard]] std::uint32_t register_value(unsigned number) const;
  /// Time that a peripheral access costs beyond the instruction.
  void add_wait(unsigned cycles) { time_ += cycles * cycle_; }
  /// The image asked for a system reset (AIRCR).
  std::function<void()> on_reset_request;
  /// Looks at pending work before the next instruction.
  void kick() { kick_ = true; }

 private:
  struct Callbacks;
  friend struct Callbacks;

  void on_instruction(std::uint32_t address, std::uint32_t bytes);
  void account(std::uint32_t address, const InstructionInfo& info);
  void skipped_conditionals(std::uint32_t address);
  void after_access();
  const InstructionInfo& info_at(std::uint32_t address);
  void watch_stack();
  [[nodiscard]] std::uint32_t it_bits(std::uint32_t address);

  void execute();
  void take_exceptions();
  [[nodiscard]] int takeable() const;
  void enter(int exception, bool tail_chained, std::uint32_t chained_return);
  void leave(std::uint32_t exc_return);
  void fault(int exception, std::uint32_t cfsr, std::uint32_t address, const std::string& what);
  void semihosting();
  std::uint32_t vector(int exception);
  std::uint32_t get(int reg) const;
  void set(int reg, std::uint32_t value);
  void charge(unsigned cycles);

  EventQueue& queue_;
  Reports& reports_;
  SystemSpace& system_;
  PeripheralBus& bus_;
  CostModel cost_;
  FlashModel flash_model_;

  uc_struct* uc_ = nullptr;
  std::vector<std::uint8_t> flash_, ram_, core_ram_, system_memory_;
  std::vector<InstructionInfo> infos_;  ///< one per halfword of flash
  InstructionInfo elsewhere_;           ///< of an instruction outside flash

  Time time_ = 0, end_ = 0, next_stop_ = 0, idle_ = 0, cycle_ = 0;
  std::uint32_t pc_ = 0, expected_ = 0, line_ = 0, it_begin_ = 0, it_end_ = 0;
  std::uint64_t instructions_ = 0;
  std::vector<int> active_;
  std::uint32_t lowest_stack_ = 0xFFFFFFFFU, guard_begin_ = 0, guard_end_ = 0;
  Probe probe_;
  std::string console_;
  int exit_code_ = 0;
  bool kick_ = false, stopping_ = false, waiting_ = false, sleeping_ = false, check_stack_ = false;
  struct ItBlock {
    std::uint32_t begin, end;
  };
  std::vector<ItBlock> left_it_blocks_;  ///< of what the active exceptions interrupted
  bool interrupt_it_blocks_ = false;
  bool fp_active_ = false, lazy_frame_ = false, exited_ = false, locked_up_ = false;
  int interrupt_ = -1;             ///< what unicorn stopped for
  std::uint32_t bad_address_ = 0;  ///< of the access that failed
  int pending_fault_ = 0;          ///< found by the emulator before the instruction
  std::uint32_t pending_cfsr_ = 0, pending_address_ = 0;
};

}  // namespace finemote::emulator
