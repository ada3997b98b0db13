#include "emulator/core/cpu.hpp"

#include <unicorn/unicorn.h>

#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <tuple>

namespace finemote::emulator {
namespace {

constexpr std::uint32_t kFlashBase = 0x08000000, kFlashBytes = 0x100000;
constexpr std::uint32_t kRamBase = 0x20000000, kRamBytes = 0x20000;
constexpr std::uint32_t kCoreRamBase = 0x10000000, kCoreRamBytes = 0x10000;
constexpr std::uint32_t kSystemMemoryBase = 0x1FFF7000, kSystemMemoryBytes = 0x1000;

// Exception entry and return without wait states, and a tail-chained one: Cortex-M4 TRM 3.9 and ARMv7-M B1.5.
constexpr unsigned kEntryCycles = 12, kReturnCycles = 10, kTailCycles = 6, kLazyCycles = 17, kFlashWait = 5;
constexpr std::uint32_t kItBits = 0x0600FC00;  // xPSR 26:25 and 15:10
constexpr Time kQemuInstruction = from_ns(8);

// Numbers unicorn gives to what stops it (target/arm/cpu.h of QEMU).
enum Interrupt : int {
  kUndefined = 1,
  kSvc = 2,
  kPrefetchAbort = 3,
  kDataAbort = 4,
  kBreakpoint = 7,
  kExceptionReturn = 8,
  kSemihosting = 16,
  kNoCoprocessor = 17,
  kInvalidState = 18
};

// PM0214 4.4.13: configurable fault status.
constexpr std::uint32_t kStackingMem = 1U << 4, kInstructionBus = 1U << 8, kPreciseBus = 1U << 9,
                        kBusAddress = 1U << 15, kUndefinedInstruction = 1U << 16, kBadState = 1U << 17,
                        kNoFpu = 1U << 19, kDataMem = 1U << 1, kMemAddress = 1U << 7;

void must(uc_err error, const char* what) {
  if (error != UC_ERR_OK) throw std::runtime_error(std::string("unicorn: ") + what + ": " + uc_strerror(error));
}

std::string hex(std::uint32_t value) {
  char text[16];
  std::snprintf(text, sizeof text, "0x%08X", value);
  return text;
}

}  // namespace

/// What unicorn calls back into.
struct Cpu::Callbacks {
  static Cpu& cpu(void* user) { return *static_cast<Cpu*>(user); }

  static void code(uc_engine*, std::uint64_t address, std::uint32_t bytes, void* user) {
    cpu(user).on_instruction(static_cast<std::uint32_t>(address), bytes);
  }

  static void interrupt(uc_engine* uc, std::uint32_t number, void* user) {
    cpu(user).interrupt_ = static_cast<int>(number);
    uc_emu_stop(uc);
  }

  static bool unmapped(uc_engine*, uc_mem_type, std::uint64_t address, int, std::int64_t, void* user) {
    cpu(user).bad_address_ = static_cast<std::uint32_t>(address);
    return false;
  }

  template <std::uint32_t Base>
  static std::uint64_t read_system(uc_engine*, std::uint64_t offset, unsigned bytes, void* user) {
    Cpu& c = cpu(user);
    return c.system_.read(Base + static_cast<std::uint32_t>(offset), bytes, c.time_, c.pc_);
  }
  template <std::uint32_t Base>
  static void write_system(uc_engine*, std::uint64_t offset, unsigned bytes, std::uint64_t value, void* user) {
    Cpu& c = cpu(user);
    c.system_.write(Base + static_cast<std::uint32_t>(offset), bytes, static_cast<std::uint32_t>(value), c.time_,
                    c.pc_);
    std::tie(c.guard_begin_, c.guard_end_) = c.system_.guard();
    c.after_access();
  }
  template <std::uint32_t Base>
  static std::uint64_t read_peripheral(uc_engine*, std::uint64_t offset, unsigned bytes, void* user) {
    Cpu& c = cpu(user);
    const std::uint32_t value = c.bus_.read(Base + static_cast<std::uint32_t>(offset), bytes);
    c.after_access();
    return value;
  }
  template <std::uint32_t Base>
  static void write_peripheral(uc_engine*, std::uint64_t offset, unsigned bytes, std::uint64_t value, void* user) {
    Cpu& c = cpu(user);
    c.bus_.write(Base + static_cast<std::uint32_t>(offset), bytes, static_cast<std::uint32_t>(value));
    c.after_access();
  }
};

Cpu::Cpu(EventQueue& queue, Reports& reports, SystemSpace& system, PeripheralBus& bus, CostModel cost, FlashModel flash)
    : queue_(queue),
      reports_(reports),
      system_(system),
      bus_(bus),
      cost_(cost),
      flash_model_(flash),
      flash_(kFlashBytes, 0xFF),
      ram_(kRamBytes, 0xA5),  // not zero: an image that forgets to clear shows
      core_ram_(kCoreRamBytes, 0xA5),
      system_memory_(kSystemMemoryBytes, 0xFF),
      infos_(kFlashBytes / 2) {
  must(uc_open(UC_ARCH_ARM, static_cast<uc_mode>(UC_MODE_THUMB | UC_MODE_MCLASS), &uc_), "open");
  must(uc_ctl_set_cpu_model(uc_, UC_CPU_ARM_CORTEX_M4), "Cortex-M4");
  must(uc_mem_map_ptr(uc_, kFlashBase, kFlashBytes, UC_PROT_READ | UC_PROT_EXEC, flash_.data()), "flash");
  must(uc_mem_map_ptr(uc_, 0, kFlashBytes, UC_PROT_READ | UC_PROT_EXEC, flash_.data()), "flash alias");
  must(uc_mem_map_ptr(uc_, kRamBase, kRamBytes, UC_PROT_ALL, ram_.data()), "RAM");
  must(uc_mem_map_ptr(uc_, kCoreRamBase, kCoreRamBytes, UC_PROT_READ | UC_PROT_WRITE, core_ram_.data()), "CCM");
  must(uc_mem_map_ptr(uc_, kSystemMemoryBase, kSystemMemoryBytes, UC_PROT_READ, system_memory_.data()),
       "system memory");
  constexpr std::uint32_t kApb = 0x40000000, kAhb2 = 0x50000000, kDwt = 0xE0001000, kScs = 0xE000E000,
                          kDebug = 0xE0042000;
  must(uc_mmio_map(uc_, kApb, 0x80000, Callbacks::read_peripheral<kApb>, this, Callbacks::write_peripheral<kApb>, this),
       "peripherals");
  must(uc_mmio_map(uc_, kAhb2, 0x61000, Callbacks::read_peripheral<kAhb2>, this, Callbacks::write_peripheral<kAhb2>,
                   this),
       "AHB2");
  must(uc_mmio_map(uc_, kDwt, 0x1000, Callbacks::read_system<kDwt>, this, Callbacks::write_system<kDwt>, this), "DWT");
  must(uc_mmio_map(uc_, kScs, 0x1000, Callbacks::read_system<kScs>, this, Callbacks::write_system<kScs>, this),
       "system control space");
  must(uc_mmio_map(uc_, kDebug, 0x1000, Callbacks::read_system<kDebug>, this, Callbacks::write_system<kDebug>, this),
       "debug");
  uc_hook hook = 0;
  must(uc_hook_add(uc_, &hook, UC_HOOK_CODE, reinterpret_cast<void*>(Callbacks::code), this, 1, 0), "code hook");
  must(uc_hook_add(uc_, &hook, UC_HOOK_INTR, reinterpret_cast<void*>(Callbacks::interrupt), this, 1, 0),
       "interrupt hook");
  must(uc_hook_add(uc_, &hook, UC_HOOK_MEM_INVALID, reinterpret_cast<void*>(Callbacks::unmapped), this, 1, 0),
       "fault hook");
  set(UC_ARM_REG_C1_C0_2, 0xFU << 20);  // unicorn's own FPU switch; the image's CPACR is checked per instruction
  set(UC_ARM_REG_FPEXC, 1U << 30);
}

Cpu::~Cpu() { uc_close(uc_); }

std::uint32_t Cpu::get(int reg) const {
  std::uint32_t value = 0;
  uc_reg_read(uc_, reg, &value);
  return value;
}

void Cpu::set(int reg, std::uint32_t value) { uc_reg_write(uc_, reg, &value); }

std::uint32_t Cpu::register_value(unsigned number) const {
  if (number < 13) return get(UC_ARM_REG_R0 + static_cast<int>(number));
  return get(number == 13 ? UC_ARM_REG_SP : number == 14 ? UC_ARM_REG_LR : UC_ARM_REG_PC);
}

std::uint8_t* Cpu::memory(std::uint32_t address, std::uint32_t bytes) {
  const auto inside = [&](std::vector<std::uint8_t>& area, std::uint32_t base) -> std::uint8_t* {
    const std::uint64_t offset = std::uint64_t{address} - base;
    return address >= base && offset + bytes <= area.size() ? area.data() + offset : nullptr;
  };
  if (std::uint8_t* p = inside(ram_, kRamBase)) return p;
  if (std::uint8_t* p = inside(core_ram_, kCoreRamBase)) return p;
  return inside(flash_, kFlashBase);
}

void Cpu::load(const Image& image) {
  for (const Segment& segment : image.segments) {
    const std::uint64_t offset = std::uint64_t{segment.address} - kFlashBase;
    if (segment.address < kFlashBase || offset + segment.bytes.size() > flash_.size())
      throw std::runtime_error("a segment at " + hex(segment.address) + " lies outside the flash");
    std::memcpy(flash_.data() + offset, segment.bytes.data(), segment.bytes.size());
  }
  infos_.assign(infos_.size(), {});
}

std::uint32_t Cpu::vector(int exception) {
  std::uint32_t base = system_.vector_table();
  if (base < kFlashBytes) base += kFlashBase;  // boot alias
  const std::uint8_t* p = memory(base + 4 * static_cast<std::uint32_t>(exception), 4);
  std::uint32_t value = 0;
  if (p != nullptr) std::memcpy(&value, p, 4);
  return value;
}

void Cpu::reset() {
  system_.reset();
  active_.clear();
  left_it_blocks_.clear();
  set(UC_ARM_REG_XPSR, 1U << 24);
  set(UC_ARM_REG_CONTROL, 0);
  set(UC_ARM_REG_PRIMASK, 0);
  set(UC_ARM_REG_BASEPRI, 0);
  set(UC_ARM_REG_FAULTMASK, 0);
  set(UC_ARM_REG_SP, vector(0) & ~3U);
  set(UC_ARM_REG_LR, 0xFFFFFFFFU);
  pc_ = vector(kReset) & ~1U;
  set(UC_ARM_REG_PC, pc_ | 1);
  expected_ = pc_;
  cycle_ = system_.clock().period();
  fp_active_ = lazy_frame_ = sleeping_ = waiting_ = kick_ = check_stack_ = false;
  guard_begin_ = guard_end_ = it_begin_ = it_end_ = 0;
}

const InstructionInfo& Cpu::info_at(std::uint32_t address) {
  const std::uint32_t offset = address & 0x07FFFFFFU;
  InstructionInfo* slot =
      address < kFlashBase + kFlashBytes && offset < kFlashBytes ? &infos_[offset / 2] : &elsewhere_;
  if (slot->cycles == 0 || slot == &elsewhere_) {
    std::uint16_t halves[2] = {0xBF00, 0};
    const std::uint32_t real = address < kFlashBytes ? address + kFlashBase : address;
    if (const std::uint8_t* p = memory(real, 2)) std::memcpy(&halves[0], p, 2);
    if (const std::uint8_t* p = memory(real + 2, 2)) std::memcpy(&halves[1], p, 2);
    *slot = decode(halves[0], halves[1]);
  }
  return *slot;
}

/// Unicorn does not announce conditional instructions whose condition fails: they are found by the gap they leave.
void Cpu::skipped_conditionals(std::uint32_t address) {
  for (std::uint32_t at = expected_; at < address;) {
    const InstructionInfo& skipped = info_at(at);
    time_ += cost_ == CostModel::qemu ? kQemuInstruction : cycle_;
    ++instructions_;
    at += skipped.bytes;
  }
}

void Cpu::account(std::uint32_t address, const InstructionInfo& info) {
  if (address != expected_) {
    if (address > expected_ && address <= it_end_ && expected_ > it_begin_) {
      skipped_conditionals(address);
    } else if (cost_ != CostModel::qemu) {
      time_ += kRefillCycles * cycle_;
    }
  }
  if (flash_model_ == FlashModel::miss_always && (address >> 4) != line_) {
    line_ = address >> 4;
    time_ += kFlashWait * cycle_;
  }
  expected_ = address + info.bytes;
  time_ += cost_ == CostModel::qemu ? kQemuInstruction : info.cycles * cycle_;
  ++instructions_;
}

void Cpu::watch_stack() {
  check_stack_ = false;
  const std::uint32_t sp = get(UC_ARM_REG_SP);
  if (sp < lowest_stack_) lowest_stack_ = sp;
  if (sp < guard_end_ && sp >= guard_begin_ && guard_end_ != 0 && pending_fault_ == 0) {
    pending_fault_ = kMemManage;
    pending_cfsr_ = kDataMem | kMemAddress;
    pending_address_ = sp;
    kick_ = true;
  }
}

void Cpu::on_instruction(std::uint32_t address, std::uint32_t) {
  if (stopping_) return;
  pc_ = address;
  if (check_stack_) watch_stack();
  const bool in_it_block = !interrupt_it_blocks_ && address > it_begin_ && address < it_end_;
  if (probe_ && !in_it_block) probe_(address);
  if ((kick_ || time_ >= next_stop_) && !in_it_block) {
    stopping_ = true;
    uc_emu_stop(uc_);
    return;
  }
  const InstructionInfo& info = info_at(address);
  account(address, info);
  if (info.flags == 0) return;
  if ((info.flags & InstructionInfo::kFloatingPoint) != 0) {
    if (!system_.fpu_enabled()) {
      pending_fault_ = kUsageFault;
      pending_cfsr_ = kNoFpu;
      stopping_ = true;
      uc_emu_stop(uc_);
      return;
    }
    fp_active_ = true;
    if (lazy_frame_) charge(kLazyCycles);
    lazy_frame_ = false;
  }
  if ((info.flags & InstructionInfo::kMasks) != 0) kick_ = true;
  if ((info.flags & InstructionInfo::kWaits) != 0) waiting_ = true;
  if ((info.flags & InstructionInfo::kMovesStack) != 0) check_stack_ = true;
  if ((info.flags & InstructionInfo::kIfThen) != 0) {
    it_begin_ = address;
    it_end_ = address + 2;
    std::uint16_t op = 0;
    if (const std::uint8_t* p = memory(address < kFlashBytes ? address + kFlashBase : address, 2))
      std::memcpy(&op, p, 2);
    const unsigned mask = op & 0xF;
    const unsigned length = (mask & 1) != 0 ? 4 : (mask & 2) != 0 ? 3 : (mask & 4) != 0 ? 2 : 1;
    for (unsigned i = 0; i < length; ++i) it_end_ += info_at(it_end_).bytes;
  }
}

/// The IT bits of xPSR before the instruction at `address`, which unicorn keeps to itself: condition and mask of the IT
/// instruction, shifted once per instruction of the block (ARMv7-M A7.3.2). 0 outside a block.
std::uint32_t Cpu::it_bits(std::uint32_t address) {
  if (address <= it_begin_ || address >= it_end_) return 0;
  std::uint16_t op = 0;
  if (const std::uint8_t* p = memory(it_begin_ < kFlashBytes ? it_begin_ + kFlashBase : it_begin_, 2))
    std::memcpy(&op, p, 2);
  std::uint32_t state = op & 0xFF;
  for (std::uint32_t at = it_begin_ + 2; at < address; at += info_at(at).bytes)
    state = (state & 7) == 0 ? 0 : (state & 0xE0) | (state << 1 & 0x1F);
  return (state & 3) << 25 | (state >> 2) << 10;
}

/// A peripheral may have asked for an interrupt or an earlier event.
void Cpu::after_access() {
  const Time next = queue_.next();
  next_stop_ = next < end_ ? next : end_;
  cycle_ = system_.clock().period();
  if (system_.nvic().changed() || system_.reset_requested()) kick_ = true;
}

void Cpu::charge(unsigned cycles) {
  if (cost_ != CostModel::qemu) time_ += cycles * cycle_;
}

int Cpu::takeable() const {
  const Nvic& nvic = system_.nvic();
  const int next = nvic.most_urgent();
  if (next == 0) return 0;
  int limit = nvic.active_priority();
  if ((get(UC_ARM_REG_FAULTMASK) & 1) != 0 && limit > -1) limit = -1;
  if ((get(UC_ARM_REG_PRIMASK) & 1) != 0 && limit > 0) limit = 0;
  const int basepri = static_cast<int>(get(UC_ARM_REG_BASEPRI) & 0xF0);
  if (basepri != 0 && limit > basepri) limit = basepri;
  return nvic.priority(next) < limit ? next : 0;
}

void Cpu::enter(int exception, bool tail_chained, std::uint32_t chained_return) {
  std::uint32_t exc_return = chained_return;
  if (!tail_chained) {
    const bool fp = fp_active_, process = (get(UC_ARM_REG_CONTROL) & 2) != 0 && active_.empty();
    const std::uint32_t sp = get(UC_ARM_REG_SP), pad = sp & 4, frame = sp - pad - (fp ? 104U : 32U);
    std::uint8_t* bytes = memory(frame, fp ? 104 : 32);
    const bool guarded = guard_end_ != 0 && frame < guard_end_ && frame + 32 > guard_begin_;
    if (bytes == nullptr || guarded) {  // stacking fails: hard fault without a usable frame is the end
      reports_.add(Misuse::fault, "exception " + std::to_string(exception) + " finds no stack at " + hex(frame), time_,
                   pc_);
      system_.note_fault(kStackingMem, frame, true);
      locked_up_ = true;
      return;
    }
    const auto put = [bytes](unsigned offset, std::uint32_t value) { std::memcpy(bytes + offset, &value, 4); };
    for (unsigned i = 0; i < 4; ++i) put(4 * i, get(UC_ARM_REG_R0 + static_cast<int>(i)));
    put(16, get(UC_ARM_REG_R12));
    put(20, get(UC_ARM_REG_LR));
    put(24, get(UC_ARM_REG_PC) & ~1U);
    const std::uint32_t it = it_bits(get(UC_ARM_REG_PC) & ~1U);
    left_it_blocks_.push_back({it_begin_, it_end_});
    put(28, (get(UC_ARM_REG_XPSR) & ~(0x200U | kItBits)) | it | (pad != 0 ? 0x200U : 0) | 1U << 24);
    if (fp) {
      for (int i = 0; i < 16; ++i) put(32 + 4 * static_cast<unsigned>(i), get(UC_ARM_REG_S0 + i));
      put(96, get(UC_ARM_REG_FPSCR));
    }
    set(UC_ARM_REG_SP, frame);
    exc_return = 0xFFFFFFE1U | (fp ? 0U : 0x10U) | (active_.empty() ? 8U : 0U) | (process ? 4U : 0U);
    lazy_frame_ = fp;
    charge(kEntryCycles);
  } else {
    charge(kTailCycles);
  }
  fp_active_ = false;
  active_.push_back(exception);
  system_.nvic().enter(exception);
  system_.set_active_exception(exception);
  set(UC_ARM_REG_XPSR, static_cast<std::uint32_t>(exception) | 1U << 24);
  set(UC_ARM_REG_LR, exc_return);
  pc_ = vector(exception) & ~1U;
  set(UC_ARM_REG_PC, pc_ | 1);
  expected_ = pc_;
  it_begin_ = it_end_ = 0;
  watch_stack();
}

void Cpu::leave(std::uint32_t exc_return) {
  if (active_.empty()) {
    fault(kUsageFault, 1U << 18, 0, "exception return without an exception");
    return;
  }
  const int exception = active_.back();
  active_.pop_back();
  bus_.returning(exception);
  system_.nvic().leave(exception);
  if (exception != kHardFault && exception != kNmi) set(UC_ARM_REG_FAULTMASK, 0);
  if (const int next = takeable(); next != 0) {
    static_cast<void>(system_.nvic().take_change());
    enter(next, true, exc_return);
    return;
  }
  const bool fp = (exc_return & 0x10) == 0;
  const std::uint32_t frame = get((exc_return & 4) != 0 ? UC_ARM_REG_PSP : UC_ARM_REG_SP);
  const std::uint8_t* bytes = memory(frame, fp ? 104 : 32);
  if (bytes == nullptr) {
    reports_.add(Misuse::fault, "exception return finds no frame at " + hex(frame), time_, pc_);
    locked_up_ = true;
    return;
  }
  const auto word = [bytes](unsigned offset) {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes + offset, 4);
    return value;
  };
  const std::uint32_t xpsr = word(28);
  const std::uint32_t after = frame + (fp ? 104U : 32U) + ((xpsr & 0x200) != 0 ? 4U : 0U);
  if ((exc_return & 4) != 0) {
    set(UC_ARM_REG_PSP, after);
  } else {
    set(UC_ARM_REG_SP, after);
  }
  set(UC_ARM_REG_XPSR, (xpsr & ~0x1FFU) | static_cast<std::uint32_t>(active_.empty() ? 0 : active_.back()));
  for (unsigned i = 0; i < 4; ++i) set(UC_ARM_REG_R0 + static_cast<int>(i), word(4 * i));
  set(UC_ARM_REG_R12, word(16));
  set(UC_ARM_REG_LR, word(20));
  if (fp) {
    for (int i = 0; i < 16; ++i) set(UC_ARM_REG_S0 + i, word(32 + 4 * static_cast<unsigned>(i)));
    set(UC_ARM_REG_FPSCR, word(96));
  }
  it_begin_ = left_it_blocks_.back().begin;
  it_end_ = left_it_blocks_.back().end;
  left_it_blocks_.pop_back();
  fp_active_ = fp;
  lazy_frame_ = false;
  system_.set_active_exception(active_.empty() ? 0 : active_.back());
  pc_ = word(24);
  set(UC_ARM_REG_PC, pc_ | 1);
  expected_ = pc_;
  charge(kReturnCycles);
}

void Cpu::fault(int exception, std::uint32_t cfsr, std::uint32_t address, const std::string& what) {
  reports_.add(Misuse::fault, what, time_, pc_);
  const Nvic& nvic = system_.nvic();
  const bool masked = (get(UC_ARM_REG_PRIMASK) & 1) != 0;
  const bool reachable = nvic.is_enabled(exception) && nvic.priority(exception) < nvic.active_priority() && !masked;
  if (!reachable && nvic.active_priority() <= -1) {
    locked_up_ = true;
    return;
  }
  system_.note_fault(cfsr, address, !reachable);
  set(UC_ARM_REG_PC, pc_ | 1);
  enter(reachable ? exception : static_cast<int>(kHardFault), false, 0);
}

void Cpu::semihosting() {
  const std::uint32_t operation = get(UC_ARM_REG_R0);
  std::uint32_t argument = get(UC_ARM_REG_R1);
  if (operation == 0x04) {  // SYS_WRITE0
    for (const std::uint8_t* p = memory(argument, 1); p != nullptr && *p != 0; p = memory(++argument, 1))
      console_ += static_cast<char>(*p);
  } else if (operation == 0x18 || operation == 0x20) {  // SYS_EXIT, SYS_EXIT_EXTENDED
    exited_ = true;
    if (const std::uint8_t* p = operation == 0x20 ? memory(argument + 4, 4) : nullptr) std::memcpy(&exit_code_, p, 4);
  } else if (operation == 0x10 || operation == 0x11) {
    set(UC_ARM_REG_R0, 0);
  } else {
    reports_.add(Misuse::unmodelled, "semihosting operation " + hex(operation), time_, pc_);
  }
  set(UC_ARM_REG_PC, (pc_ + 2) | 1);
  expected_ = pc_ + 2;
}

void Cpu::take_exceptions() {
  kick_ = false;
  static_cast<void>(system_.nvic().take_change());
  if (pending_fault_ != 0) {
    const int exception = pending_fault_;
    pending_fault_ = 0;
    guard_end_ = 0;  // one report; the handler may use the stack
    fault(exception, pending_cfsr_, pending_address_,
          exception == kMemManage ? "the stack reached its guard at " + hex(pending_address_)
                                  : "floating point before the FPU is on");
    return;
  }
  if (const int next = takeable(); next != 0) {
    sleeping_ = false;
    enter(next, false, 0);
  }
}

/// Runs unicorn until something needs us, and sorts out what.
void Cpu::execute() {
  stopping_ = waiting_ = false;
  interrupt_ = -1;
  if (const std::uint32_t it = interrupt_it_blocks_ ? it_bits(get(UC_ARM_REG_PC) & ~1U) : 0; it != 0)
    set(UC_ARM_REG_XPSR, (get(UC_ARM_REG_XPSR) & ~kItBits) | it);
  const uc_err error = uc_emu_start(uc_, get(UC_ARM_REG_PC) | 1, 0xFFFFFFFEU, 0, 0);
  const std::uint32_t stopped_at = get(UC_ARM_REG_PC);
  const bool returning =
      interrupt_ == kExceptionReturn || (error == UC_ERR_FETCH_UNMAPPED && stopped_at >= 0xFFFFFF00U);
  if (returning) return leave(stopped_at | 1);
  if (interrupt_ == kBreakpoint || interrupt_ == kSemihosting) return semihosting();
  if (interrupt_ == kSvc) return system_.nvic().pend(kSvCall);
  if (interrupt_ == kUndefined || error == UC_ERR_INSN_INVALID)
    return fault(kUsageFault, kUndefinedInstruction, 0, "undefined instruction at " + hex(pc_));
  if (interrupt_ == kNoCoprocessor) return fault(kUsageFault, kNoFpu, 0, "no coprocessor at " + hex(pc_));
  if (interrupt_ == kInvalidState) return fault(kUsageFault, kBadState, 0, "jump out of Thumb state at " + hex(pc_));
  if (error == UC_ERR_FETCH_UNMAPPED || error == UC_ERR_FETCH_PROT || interrupt_ == kPrefetchAbort)
    return fault(kBusFault, kInstructionBus, 0, "no instruction at " + hex(stopped_at));
  if (error != UC_ERR_OK || interrupt_ == kDataAbort)
    return fault(kBusFault, kPreciseBus | kBusAddress, bad_address_,
                 "access to " + hex(bad_address_) + " at " + hex(pc_));
  if (interrupt_ >= 0)
    return fault(kUsageFault, kUndefinedInstruction, 0, "exception " + std::to_string(interrupt_) + " at " + hex(pc_));
  if (waiting_ && !stopping_) {
    sleeping_ = true;
    if (stopped_at == pc_) set(UC_ARM_REG_PC, (pc_ + 2) | 1);
    expected_ = pc_ + 2;
  }
}

Stop Cpu::run_until(Time end) {
  end_ = end;
  while (time_ < end && !exited_ && !locked_up_) {
    queue_.run(time_);
    cycle_ = system_.clock().period();
    if (system_.take_reset_request() && on_reset_request) on_reset_request();
    take_exceptions();
    if (locked_up_) break;
    if (sleeping_) {
      // Masked interrupts wake the core too, without being taken: ARMv7-M B1.5.18.
      const int next = system_.nvic().most_urgent();
      if (next != 0 && system_.nvic().priority(next) < system_.nvic().active_priority()) sleeping_ = false;
    }
    const Time next_event = queue_.next();
    if (sleeping_) {
      if (next_event == kNever) return Stop::dead;
      const Time until = next_event < end ? next_event : end;
      if (until > time_) {
        idle_ += until - time_;
        system_.slept(until - time_);
        time_ = until;
      }
      continue;
    }
    next_stop_ = next_event < end ? next_event : end;
    execute();
  }
  return exited_ ? Stop::exit : locked_up_ ? Stop::lockup : Stop::time;
}

}  // namespace finemote::emulator
