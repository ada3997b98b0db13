// Runs Thumb instructions on the registers and memories of the core, until something outside of them is needed.
#pragma once

#include <cstdint>
#include <cstring>
#include <map>
#include <utility>
#include <vector>

#include "emulator/core/memories.hpp"
#include "emulator/core/operation.hpp"
#include "emulator/core/pace.hpp"
#include "emulator/core/registers.hpp"
#include "emulator/core/tag_flow.hpp"

namespace finemote::emulator {

/// Why the interpreter stopped. `Registers::next` is where it goes on, unless said otherwise.
enum class Halt {
  asked,             ///< `Outside::stops` said so
  sleep,             ///< WFI
  supervisor_call,   ///< SVC
  breakpoint,        ///< BKPT; next is the instruction itself
  exception_return,  ///< a jump to an EXC_RETURN value, which `next` holds
  undefined,         ///< no such instruction; next is the instruction itself
  no_fpu,            ///< a floating-point instruction while the FPU is off; next is the instruction itself
  bad_state,         ///< a jump to an even address
  no_instruction,    ///< `next` is not in executable memory
  bad_access,        ///< no memory at `bad_address()`; next is the instruction itself
};

/// What lies behind the interpreter.
class Outside {
 public:
  virtual ~Outside() = default;
  /// An address that is no memory. @return false: nothing is there
  virtual bool read(std::uint32_t address, unsigned bytes, std::uint32_t& value) = 0;
  virtual bool write(std::uint32_t address, unsigned bytes, std::uint32_t value) = 0;
  /// Asked before the instruction at `address` once `Pace::stop_at` is reached.
  virtual bool stops(std::uint32_t address) = 0;
  /// What interrupts are let through may have changed.
  virtual void masks_changed() = 0;
  /// The stack pointer is below `Interpreter::stack_alarm`.
  virtual void stack_moved() = 0;
  virtual void report_unmodelled(const char* what) = 0;
  /// The marked instruction at `address` begins at `at`.
  virtual void passed(std::uint32_t address, Time at) = 0;
  /// Registers of the floating-point unit were saved for what was preempted, which took until `at`.
  virtual void saved_float(Time at, Time took) = 0;
  /// Asked before an instruction that was not taken apart before.
  virtual bool may_execute(std::uint32_t address) {
    static_cast<void>(address);
    return true;
  }
};

/// What stands where for the processor, and what of it is shut.
struct MemoryView {
  bool ram_at_zero = false;         ///< SRAM1 and not the flash
  bool runs_zero = true;            ///< all of what stands at 0 may be executed
  bool runs_flash = true;           ///< the same of the flash at its own place
  std::uint32_t protected_ram = 0;  ///< bytes from the start of RAM up to the last that may not be written
};

class Interpreter {
 public:
  Interpreter(const Memories& memories, Outside& outside, TagFlow& tags)
      : memories_(memories), outside_(outside), tags_(tags) {}

  Registers registers;
  Pace pace;
  bool fpu_on = false;           ///< the image has turned it on in CPACR
  bool fp_active = false;        ///< floating point was used since the last exception entry
  bool traps_unaligned = false;  ///< the image has asked for faults in CCR
  bool lazy_frame = false;       ///< the space for its registers is reserved, not filled
  std::uint32_t stack_alarm = 0;
  Time drained_at = 0;  ///< of the last DSB: every store before it has left the core

  /// The first `bytes` of flash hold an image from now on.
  void take_apart_flash(std::uint32_t bytes);
  /// These bytes of flash have changed.
  void take_apart_again(std::uint32_t address, std::uint32_t bytes);
  /// These bytes of RAM have changed.
  void forget_ram(std::uint32_t address, std::uint32_t bytes);
  void see(const MemoryView& view);
  /// Where what the processor sees at `address` has its own place; `address` itself where nothing stands at 0.
  [[nodiscard]] std::uint32_t physical(std::uint32_t address) const {
    if (address >= low_bytes_) return address;
    return address + (pace.ram_at_zero ? Memories::kRamBase : Memories::kFlashBase);
  }
  /// `Outside::passed` is told whenever the instruction at the physical `address`, in the image's flash or in RAM,
  /// begins.
  void mark(std::uint32_t address);
  /// Runs until it has to stop.
  Halt run();

  /// The instruction begun last.
  [[nodiscard]] std::uint32_t pc() const { return registers.r[15] - 4; }
  [[nodiscard]] std::uint32_t bad_address() const { return bad_address_; }
  /// Whether it was refused because it is not aligned; asked once.
  bool takes_unaligned() { return std::exchange(is_unaligned_, false); }

  /// An exception that costs time to save registers lazily: PM0214 2.3.7, Cortex-M4 TRM 7.2.3.
  static constexpr unsigned kLazyCycles = 17;

 private:
  template <CostModel Cost, FlashModel Flash, bool Tagged>
  Halt run_with();
  template <CostModel Cost, FlashModel Flash>
  Halt run_at_cost() {
    return tags_.is_on() ? run_with<Cost, Flash, true>() : run_with<Cost, Flash, false>();
  }
  const Operation* operation_at(std::uint32_t address, Operation& outside_image);
  void take_apart_known(std::uint32_t n);
  const Operation* take_apart_ram(std::uint32_t n);
  const Operation* take_apart_at(std::uint32_t address, Operation& into) const;
  template <CostModel Cost>
  void arrive(std::uint32_t address, std::uint32_t expected);
  template <CostModel Cost>
  void wait_in_place(unsigned cycles);
  void pass_skipped(std::uint32_t from, std::uint32_t address);
  bool begin_float();
  [[nodiscard]] bool condition(unsigned code) const;
  void begin_it(std::uint32_t address, std::uint32_t state);

  /// Where `bytes` at `address` lie in RAM or core-coupled RAM; null when they do not.
  [[nodiscard]] std::uint8_t* in_ram(std::uint32_t address, std::uint32_t bytes) const {
    if (const std::uint32_t at = address - Memories::kRamBase; at <= Memories::kRamBytes - bytes)
      return memories_.ram + at;
    const std::uint32_t at = address - Memories::kCoreRamBase;
    return at <= Memories::kCoreRamBytes - bytes ? memories_.core_ram + at : nullptr;
  }
  /// In RAM that holds code or may not be written.
  [[nodiscard]] bool is_watched(std::uint32_t address) const { return address - Memories::kRamBase < watched_; }
  template <class T>
  bool load(std::uint32_t address, std::uint32_t& value) {
    const std::uint8_t* from = in_ram(address, sizeof(T));
    if (from == nullptr) {
      if (const std::uint32_t at = address - Memories::kFlashBase; at <= Memories::kFlashBytes - sizeof(T)) {
        from = memories_.flash + at;
        pace.read_flash();
      } else if (address <= low_bytes_ - sizeof(T)) {
        from = (pace.ram_at_zero ? memories_.ram : memories_.flash) + address;
        if (!pace.ram_at_zero) pace.read_flash();
      } else {
        return load_elsewhere(address, sizeof(T), value);
      }
    }
    if (!pays_for_alignment<T>(address)) return false;
    T item;
    std::memcpy(&item, from, sizeof(T));
    value = item;
    return true;
  }
  template <class T>
  bool store(std::uint32_t address, std::uint32_t value) {
    std::uint8_t* to = in_ram(address, sizeof(T));
    if (to == nullptr || is_watched(address)) return store_elsewhere(address, sizeof(T), value);
    if (!pays_for_alignment<T>(address)) return false;
    const T item = static_cast<T>(value);
    std::memcpy(to, &item, sizeof(T));
    return true;
  }
  /// An access that is not aligned becomes several, a word at a halfword two, at a byte three (Cortex-M4 TRM 3.3.2), or
  /// is a fault. @return false: it is
  template <class T>
  bool pays_for_alignment(std::uint32_t address) {
    if ((address & (sizeof(T) - 1)) == 0) [[likely]]
      return true;
    if (traps_unaligned) return refuse_unaligned(address);
    pace.charge(sizeof(T) == 4 && (address & 1) != 0 ? 2 : 1);
    return true;
  }
  bool refuse_unaligned(std::uint32_t address);
  bool load_elsewhere(std::uint32_t address, unsigned bytes, std::uint32_t& value);
  bool store_elsewhere(std::uint32_t address, unsigned bytes, std::uint32_t value);
  // Addresses of loads and stores.
  [[nodiscard]] std::uint32_t at_offset(const Operation& o) const { return registers.r[o.n] + o.imm; }
  [[nodiscard]] std::uint32_t at_index(const Operation& o) const {
    return registers.r[o.n] + (registers.r[o.m] << o.amount);
  }
  [[nodiscard]] std::uint32_t at_literal(const Operation& o) const { return (registers.r[15] & ~3U) + o.imm; }
  /// What a load or store moves, in the order of Opcode.
  enum class Access : std::uint8_t { ldr, ldrb, ldrh, ldrsb, ldrsh, str, strb, strh };
  template <Access What>
  bool transfer(std::uint32_t address, unsigned t);
  /// The same, chosen at run time.
  bool transfer(Access what, std::uint32_t address, unsigned t);
  bool load_multiple(const Operation& o, std::uint32_t& target);
  bool store_multiple(const Operation& o);
  bool dual(const Operation& o, bool loads);
  bool indexed(const Operation& o);
  bool exclusive(const Operation& o);
  bool float_memory(const Operation& o);
  void media(const Operation& o);
  void parallel_add(const Operation& o);
  void bit_field(const Operation& o);
  void saturate(const Operation& o);
  void multiply_long(const Operation& o);
  void read_special(const Operation& o);
  void write_special(const Operation& o);
  void floating(const Operation& o);
  void float_transfer(const Operation& o);
  void float_compare(std::uint32_t a, std::uint32_t b, bool signals);
  enum class Form : std::uint8_t { imm, reg, shifted };
  struct Operand {
    std::uint32_t value, carry;
  };
  template <Form Last>
  [[nodiscard]] Operand last_operand(const Operation& o) const;
  // Data processing: `Do` makes the result of two operands, `Terms` what is added of two operands and the carry.
  template <Form Last, auto Do>
  void logic(const Operation& o);
  template <Form Last, auto Do>
  void logic_flags(const Operation& o);
  template <Form Last, auto Do>
  void test(const Operation& o);
  template <Form Last, auto Terms>
  void sum(const Operation& o);
  template <Form Last, auto Terms>
  void sum_flags(const Operation& o);
  template <Form Last, auto Terms>
  void compare(const Operation& o);
  [[nodiscard]] std::uint32_t shifted(const Operation& o, std::uint32_t& carry) const;
  [[nodiscard]] std::uint32_t shift_by(Shift how, std::uint32_t value, std::uint32_t amount,
                                       std::uint32_t& carry) const;

  Memories memories_;
  Outside& outside_;
  TagFlow& tags_;
  std::vector<Operation> operations_;              ///< one per halfword of the image, and what lies past its end
  std::uint32_t known_count_ = 0;                  ///< halfwords of the image
  std::vector<Operation> ram_operations_;          ///< the same of SRAM1, once it has stood at 0
  const Operation* known_ = nullptr;               ///< of the flash, at hand
  Operation* low_ = nullptr;                       ///< of what stands at 0
  std::uint32_t flash_count_ = 0, low_count_ = 0;  ///< how many of them may be executed
  std::uint32_t low_bytes_ = Memories::kFlashBytes;
  std::uint32_t protected_ram_ = 0, ram_code_ = 0;  ///< bytes from the start of RAM
  std::uint32_t watched_ = 0;                       ///< the larger of them
  MemoryView view_;
  Operation elsewhere_, conditional_;          ///< an instruction outside of it; one inside an IT block
  std::map<std::uint32_t, Operation> marked_;  ///< by physical address: what stands at a mark
  std::uint32_t bad_address_ = 0;
  bool is_unaligned_ = false;
};

template <Interpreter::Access What>
inline bool Interpreter::transfer(std::uint32_t address, unsigned t) {
  std::uint32_t& value = registers.r[t];
  if constexpr (What == Access::str) return store<std::uint32_t>(address, value);
  if constexpr (What == Access::strb) return store<std::uint8_t>(address, value);
  if constexpr (What == Access::strh) return store<std::uint16_t>(address, value);
  std::uint32_t loaded = 0;
  const bool ok = What == Access::ldr                             ? load<std::uint32_t>(address, loaded)
                  : What == Access::ldrb || What == Access::ldrsb ? load<std::uint8_t>(address, loaded)
                                                                  : load<std::uint16_t>(address, loaded);
  if (!ok) return false;
  if constexpr (What == Access::ldrsb) loaded = static_cast<std::uint32_t>(static_cast<std::int8_t>(loaded));
  if constexpr (What == Access::ldrsh) loaded = static_cast<std::uint32_t>(static_cast<std::int16_t>(loaded));
  value = loaded;
  return true;
}

}  // namespace finemote::emulator
