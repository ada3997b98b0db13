#include "emulator/core/system_space.hpp"

#include <string>

#include "emulator/core/word_text.hpp"

namespace finemote::emulator {
namespace {
constexpr std::uint32_t kTrapDivision = 0x10;  // CCR, DIV_0_TRP: PM0214 4.4.7

bool in(std::uint32_t address, std::uint32_t from, std::uint32_t end) { return address >= from && address < end; }

constexpr std::uint32_t kCycleCountOn = 1, kTraceOn = 1U << 24;

/// ITM and TPIU, which a debugger has to turn on: without one they keep nothing and read as off. PM0214 2.2.
bool is_trace(std::uint32_t address) {
  return in(address, 0xE0000000, 0xE0001000) || in(address, 0xE0040000, 0xE0041000);
}

}  // namespace

void SystemSpace::reset() {
  nvic_.reset();
  systick_.reset();
  vtor_ = cpacr_ = shcsr_ = cfsr_ = hfsr_ = mmfar_ = bfar_ = aircr_ = scr_ = fpdscr_ = demcr_ = 0;
  ccr_ = 0x200;          // STKALIGN: PM0214 4.4.7
  fpccr_ = 0xC0000000U;  // ASPEN and LSPEN: PM0214 4.6.2
  mpu_.reset();
  dwt_control_ = 0;
  dwt_held_ = 0;
}

void SystemSpace::slept(Time duration) {
  const bool counts = debug_clock_in_sleep() && counts_in_sleep;  // DBGMCU_CR.DBG_SLEEP: RM0090 38.16.3
  if (!counts) dwt_zero_ += duration / clock_.period();
}

void SystemSpace::change_clock(Time now, Time period) {
  clock_.change(now, period);
  systick_.clock_changed(now);
}

void SystemSpace::note_fault(std::uint32_t cfsr, std::uint32_t address, bool escalated) {
  cfsr_ |= cfsr;
  if ((cfsr & 0x80) != 0) mmfar_ = address;
  if ((cfsr & 0x8000) != 0) bfar_ = address;
  if (escalated) hfsr_ |= 1U << 30;
}

std::uint32_t SystemSpace::read_bits(int first, bool (Nvic::*test)(int) const) const {
  std::uint32_t bits = 0;
  for (int i = 0; i < 32 && first + i < kExceptions; ++i) bits |= (nvic_.*test)(first + i) ? 1U << i : 0;
  return bits;
}

template <class Apply>
void SystemSpace::for_bits(std::uint32_t base, std::uint32_t address, std::uint32_t value, Apply apply) {
  const int first = 16 + static_cast<int>(address - base) * 8;
  for (int i = 0; i < 32; ++i) {
    if ((value >> i & 1) != 0 && first + i < kExceptions) apply(first + i);
  }
}

/// PM0214 4.4.3. RETTOBASE, bit 11, is of handlers alone.
std::uint32_t SystemSpace::icsr() const {
  const int next = nvic_.most_urgent();
  return static_cast<std::uint32_t>(active_exception_) | static_cast<std::uint32_t>(next) << 12 |
         (active_exception_ != 0 && nvic_.count_active() == 1 ? 1U << 11 : 0) | (next >= 16 ? 1U << 22 : 0) |
         (nvic_.is_pending(kSysTick) ? 1U << 26 : 0) | (nvic_.is_pending(kPendSv) ? 1U << 28 : 0);
}

/// PM0214 4.4.9: which of the system's exceptions are enabled, pending and active.
std::uint32_t SystemSpace::shcsr() const {
  struct Bit {
    int exception;
    unsigned active, pending;
  };
  constexpr Bit kBits[] = {{kMemManage, 0, 13}, {kBusFault, 1, 14}, {kUsageFault, 3, 12}, {kSvCall, 7, 15}};
  std::uint32_t bits = shcsr_;
  for (const Bit& it : kBits) {
    bits |= nvic_.is_active(it.exception) ? 1U << it.active : 0;
    bits |= nvic_.is_pending(it.exception) ? 1U << it.pending : 0;
  }
  return bits | (nvic_.is_active(kPendSv) ? 1U << 10 : 0) | (nvic_.is_active(kSysTick) ? 1U << 11 : 0);
}

std::uint32_t SystemSpace::read(std::uint32_t address, unsigned bytes, Time now, std::uint32_t pc) {
  const std::uint32_t shift = (address & 3) * 8;
  const std::uint32_t word = read_word(address & ~3U, now, pc) >> shift;
  return bytes == 4 ? word : word & ((1U << (bytes * 8)) - 1);
}

void SystemSpace::write(std::uint32_t address, unsigned bytes, std::uint32_t value, Time now, std::uint32_t pc) {
  if (bytes == 4) return write_word(address, value, now, pc);
  const std::uint32_t shift = (address & 3) * 8, mask = ((1U << (bytes * 8)) - 1) << shift;
  const std::uint32_t old = read_word(address & ~3U, now, pc);
  write_word(address & ~3U, (old & ~mask) | (value << shift & mask), now, pc);
}

std::uint32_t SystemSpace::read_word(std::uint32_t address, Time now, std::uint32_t pc) {
  if (is_trace(address)) return 0;
  if (in(address, 0xE000E010, 0xE000E020)) return systick_.read(address - 0xE000E010, now);
  if (in(address, 0xE000E100, 0xE000E10C))
    return read_bits(16 + static_cast<int>(address - 0xE000E100) * 8, &Nvic::is_enabled);
  if (in(address, 0xE000E180, 0xE000E18C))
    return read_bits(16 + static_cast<int>(address - 0xE000E180) * 8, &Nvic::is_enabled);
  if (in(address, 0xE000E200, 0xE000E20C))
    return read_bits(16 + static_cast<int>(address - 0xE000E200) * 8, &Nvic::is_pending);
  if (in(address, 0xE000E280, 0xE000E28C))
    return read_bits(16 + static_cast<int>(address - 0xE000E280) * 8, &Nvic::is_pending);
  if (in(address, 0xE000E300, 0xE000E30C))
    return read_bits(16 + static_cast<int>(address - 0xE000E300) * 8, &Nvic::is_active);
  if (in(address, 0xE000E400, 0xE000E454) || in(address, 0xE000ED18, 0xE000ED24)) {
    const int first =
        address < 0xE000ED00 ? 16 + static_cast<int>(address - 0xE000E400) : 4 + static_cast<int>(address - 0xE000ED18);
    std::uint32_t word = 0;
    for (int i = 0; i < 4 && first + i < kExceptions; ++i)
      word |= std::uint32_t{nvic_.priority_register(first + i)} << (8 * i);
    return word;
  }
  if (const auto value = mpu_.read(address)) return *value;
  switch (address) {
    case 0xE000E004:
      return 2;  // ICTR: 65 to 96 lines
    case 0xE000E008:
      return 0;  // ACTLR
    case 0xE000ED00:
      return 0x410FC241;  // CPUID of a Cortex-M4 r0p1
    case 0xE000ED04:
      return icsr();
    case 0xE000ED08:
      return vtor_;
    case 0xE000ED0C:
      return 0xFA050000U | aircr_;
    case 0xE000ED10:
      return scr_;
    case 0xE000ED14:
      return ccr_;
    case 0xE000ED24:
      return shcsr();
    case 0xE000ED28:
      return cfsr_;
    case 0xE000ED2C:
      return hfsr_;
    case 0xE000ED30:
      return 0;
    case 0xE000ED34:
      return mmfar_;
    case 0xE000ED38:
      return bfar_;
    case 0xE000ED88:
      return cpacr_;
    case 0xE000EDF0:
      return 0;  // DHCSR: no debugger
    case 0xE000EDFC:
      return demcr_;
    case 0xE000EF34:
      return fpccr_;
    case 0xE000EF38:
      return 0;
    case 0xE000EF3C:
      return fpdscr_;
    case 0xE000EF40:
      return 0x10110021;  // MVFR0: Cortex-M4 TRM table 7-3
    case 0xE000EF44:
      return 0x11000011;  // MVFR1
    case 0xE0001000:
      return 0x40000000U | dwt_control_;
    case 0xE0001004:
      return (dwt_control_ & kCycleCountOn) != 0 ? static_cast<std::uint32_t>(clock_.cycles(now) - dwt_zero_)
                                                 : dwt_held_;
    case 0xE0042000:
      return device_id;  // DBGMCU_IDCODE: RM0090 38.6.1
    case 0xE0042004:
      return debug_control_;
    case 0xE0042008:
    case 0xE004200C:
      return debug_freeze_[(address - 0xE0042008) / 4];
    default:
      break;
  }
  reports_.add(Misuse::unmodelled, "core register " + hex(address) + " read", now, pc, address);
  return 0;
}

void SystemSpace::write_word(std::uint32_t address, std::uint32_t value, Time now, std::uint32_t pc) {
  if (is_trace(address)) return;
  if (in(address, 0xE000E010, 0xE000E01C)) return systick_.write(address - 0xE000E010, value, now);
  if (in(address, 0xE000E100, 0xE000E10C))
    return for_bits(0xE000E100, address, value, [this](int e) { nvic_.enable(e, true); });
  if (in(address, 0xE000E180, 0xE000E18C))
    return for_bits(0xE000E180, address, value, [this](int e) { nvic_.enable(e, false); });
  if (in(address, 0xE000E200, 0xE000E20C))
    return for_bits(0xE000E200, address, value, [this](int e) { nvic_.pend(e); });
  if (in(address, 0xE000E280, 0xE000E28C))
    return for_bits(0xE000E280, address, value, [this](int e) { nvic_.unpend(e); });
  if (in(address, 0xE000E400, 0xE000E454) || in(address, 0xE000ED18, 0xE000ED24)) {
    const int first =
        address < 0xE000ED00 ? 16 + static_cast<int>(address - 0xE000E400) : 4 + static_cast<int>(address - 0xE000ED18);
    for (int i = 0; i < 4 && first + i < kExceptions; ++i)
      nvic_.set_priority(first + i, static_cast<std::uint8_t>(value >> (8 * i)));
    return;
  }
  if (mpu_.write(address, value)) return;
  switch (address) {
    case 0xE000E008:
      return;
    case 0xE000ED04:
      if ((value >> 28 & 1) != 0) nvic_.pend(kPendSv);
      if ((value >> 27 & 1) != 0) nvic_.unpend(kPendSv);
      if ((value >> 26 & 1) != 0) nvic_.pend(kSysTick);
      if ((value >> 25 & 1) != 0) nvic_.unpend(kSysTick);
      if ((value >> 31 & 1) != 0) nvic_.pend(kNmi);
      return;
    case 0xE000ED08:
      vtor_ = value & 0x3FFFFF80U;
      return;
    case 0xE000ED0C:
      if (value >> 16 != 0x05FA) return;
      aircr_ = value & 0x700;
      nvic_.set_grouping(aircr_ >> 8);
      if ((value & 4) != 0) reset_request_ = true;
      return;
    case 0xE000ED10:
      scr_ = value;
      return;
    case 0xE000ED14:
      if ((value & kTrapDivision) != 0)
        reports_.add(Misuse::unmodelled, "core register CCR bit " + hex(kTrapDivision), now, pc, address);
      ccr_ = value;
      return;
    case 0xE000ED24:
      shcsr_ = value & 0x70000;
      for (int e = kMemManage; e <= kUsageFault; ++e) nvic_.enable(e, (value >> (16 + e - kMemManage) & 1) != 0);
      return;
    case 0xE000ED28:
      cfsr_ &= ~value;
      return;
    case 0xE000ED2C:
      hfsr_ &= ~value;
      return;
    case 0xE000ED30:
      return;
    case 0xE000ED88:
      cpacr_ = value & 0xF00000;
      return;
    case 0xE000EDFC:
      demcr_ = value;
      return;
    case 0xE000EF00:
      nvic_.pend(16 + static_cast<int>(value & 0x1FF) % (kExceptions - 16));
      return;
    case 0xE000EF34:
      fpccr_ = value;
      return;
    case 0xE000EF3C:
      fpdscr_ = value;
      return;
    case 0xE000EDF0:
      return;  // DHCSR: without its key, or by the core itself, nothing happens
    case 0xE0001000: {
      const bool on = (value & kCycleCountOn) != 0 && (demcr_ & kTraceOn) != 0;
      const bool was = (dwt_control_ & kCycleCountOn) != 0;
      if (on && !was) dwt_zero_ = clock_.cycles(now) - dwt_held_;
      if (!on && was) dwt_held_ = static_cast<std::uint32_t>(clock_.cycles(now) - dwt_zero_);
      dwt_control_ = on ? kCycleCountOn : 0;
      return;
    }
    case 0xE0001004:
      dwt_held_ = value;
      dwt_zero_ = clock_.cycles(now) - value;
      return;
    case 0xE0042004:
      debug_control_ = value;
      return;
    case 0xE0042008:  // what stands still while a debugger holds the core: nobody does
    case 0xE004200C:
      debug_freeze_[(address - 0xE0042008) / 4] = value;
      return;
    case 0xE0001FB0:
      return;  // DWT_LAR: no lock on this core
    default:
      break;
  }
  reports_.add(Misuse::unmodelled, "core register " + hex(address) + " written", now, pc, address);
}

}  // namespace finemote::emulator
