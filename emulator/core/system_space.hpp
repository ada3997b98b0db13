// The registers of the core itself, 0xE0000000 and up: NVIC, SysTick, system control, MPU, FPU, DWT.
#pragma once

#include <array>
#include <cstdint>

#include "emulator/core/core_clock.hpp"
#include "emulator/core/mpu.hpp"
#include "emulator/core/nvic.hpp"
#include "emulator/core/systick.hpp"
#include "emulator/event_queue.hpp"
#include "emulator/report.hpp"

namespace finemote::emulator {

class SystemSpace {
 public:
  SystemSpace(EventQueue& queue, Reports& reports) : reports_(reports), systick_(clock_, queue, nvic_) { reset(); }

  void reset();
  [[nodiscard]] std::uint32_t read(std::uint32_t address, unsigned bytes, Time now, std::uint32_t pc);
  void write(std::uint32_t address, unsigned bytes, std::uint32_t value, Time now, std::uint32_t pc);

  Nvic& nvic() { return nvic_; }
  CoreClock& clock() { return clock_; }
  SysTick& systick() { return systick_; }
  void change_clock(Time now, Time period);
  /// The core slept: its cycle counter stood, unless the debug clock was kept on.
  void slept(Time duration);

  [[nodiscard]] std::uint32_t vector_table() const { return vtor_; }
  /// Peripherals of APB1 that stop with the core in a debugger's hands, as DBGMCU_APB1_FZ has them: RM0090 38.16.4.
  [[nodiscard]] std::uint32_t frozen_in_debug() const { return debug_freeze_[0]; }
  /// CCR, UNALIGN_TRP: PM0214 4.4.7.
  [[nodiscard]] bool traps_unaligned() const { return (ccr_ & 8) != 0; }
  [[nodiscard]] bool fpu_enabled() const { return ((cpacr_ >> 20) & 0xF) == 0xF; }
  [[nodiscard]] bool sleeps_on_exit() const { return (scr_ & 2) != 0; }
  [[nodiscard]] const Mpu& mpu() const { return mpu_; }
  [[nodiscard]] bool reset_requested() const { return reset_request_; }
  [[nodiscard]] bool take_reset_request() {
    const bool wanted = reset_request_;
    reset_request_ = false;
    return wanted;
  }
  /// Notes a fault in the status registers: PM0214 4.4.13 to 4.4.17.
  void note_fault(std::uint32_t cfsr, std::uint32_t address, bool escalated);
  void set_active_exception(int exception) { active_exception_ = exception; }

  /// The debug clock keeps the cycle counter going in sleep, as RM0090 38.16.3 reads.
  bool counts_in_sleep = true;
  [[nodiscard]] bool debug_clock_in_sleep() const { return (debug_control_ & 1) != 0; }

  std::uint32_t device_id = 0x100F6413;  ///< DBGMCU_IDCODE, RM0090 38.6.1; 0x20006411 is revision A: ES0182

 private:
  std::uint32_t read_word(std::uint32_t address, Time now, std::uint32_t pc);
  void write_word(std::uint32_t address, std::uint32_t value, Time now, std::uint32_t pc);
  std::uint32_t read_bits(int first, bool (Nvic::*test)(int) const) const;
  template <class Apply>
  void for_bits(std::uint32_t base, std::uint32_t address, std::uint32_t value, Apply apply);
  [[nodiscard]] std::uint32_t icsr() const;
  [[nodiscard]] std::uint32_t shcsr() const;

  Reports& reports_;
  Nvic nvic_;
  CoreClock clock_;
  SysTick systick_;
  std::uint32_t vtor_ = 0, cpacr_ = 0, shcsr_ = 0, cfsr_ = 0, hfsr_ = 0, mmfar_ = 0, bfar_ = 0, aircr_ = 0, scr_ = 0,
                ccr_ = 0, fpccr_ = 0, fpdscr_ = 0, demcr_ = 0, debug_control_ = 0;
  Mpu mpu_;
  std::array<std::uint32_t, 2> debug_freeze_{};
  std::uint32_t dwt_control_ = 0;
  std::uint64_t dwt_zero_ = 0;  ///< core cycle at which CYCCNT was 0
  std::uint32_t dwt_held_ = 0;  ///< CYCCNT while it stands
  bool reset_request_ = false;
  int active_exception_ = 0;
};

}  // namespace finemote::emulator
