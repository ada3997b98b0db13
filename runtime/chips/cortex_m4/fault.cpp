// Processor faults, unexpected interrupts and the stack guard: recorded, then the board restarts and stays safe.
//
// After a fault neither stack nor bus drivers can be trusted, so the outputs are made safe by a fresh start: the reset
// runs start-up, the safe outputs are the first transfer of every bus, and no bucket is released.
#include "fault.hpp"

#include "finemote/board.hpp"
#include "runtime/chips/cortex_m4/registers.hpp"

extern "C" {
extern std::uint32_t _stack_guard, _stack_bottom, _stack_top;  // sections.ld
}

namespace finemote::cortex_m4 {

__attribute__((section(".noinit"))) LastFault last_fault;

namespace {

// CFSR bits, PM0214 4.4.10.
constexpr std::uint32_t kMemoryStacking = bit(4) | bit(5), kMemoryAddressValid = bit(7);
constexpr std::uint32_t kBusAddressValid = bit(15);

std::uint32_t address_of(const void* symbol) { return reinterpret_cast<std::uint32_t>(symbol); }

bool in_stack(std::uint32_t frame) {
  return frame >= address_of(&_stack_bottom) && frame <= address_of(&_stack_top) - 32;
}

bool in_guard(std::uint32_t address) {
  return address >= address_of(&_stack_guard) && address < address_of(&_stack_bottom);
}

CoreFault kind_of(std::uint32_t exception, std::uint32_t status, std::uint32_t address, std::uint32_t frame) {
  const bool guard = (status & kMemoryAddressValid) != 0 && in_guard(address);
  if (exception == 4 && (guard || (status & kMemoryStacking) != 0 || !in_stack(frame))) return CoreFault::stack;
  switch (exception) {
    case 2:
      return CoreFault::nmi;
    case 3:
      return CoreFault::hard;
    case 4:
      return CoreFault::memory;
    case 5:
      return CoreFault::bus;
    case 6:
      return CoreFault::usage;
    default:
      return CoreFault::unexpected_interrupt;
  }
}

#ifndef FINEMOTE_SILENT
const char* text_of(CoreFault fault) {
  switch (fault) {
    case CoreFault::stack:
      return "core: stack overflow\n";
    case CoreFault::unexpected_interrupt:
      return "core: interrupt line without a routine\n";
    case CoreFault::nmi:
      return "core: non-maskable interrupt\n";
    case CoreFault::memory:
      return "core: memory fault\n";
    case CoreFault::bus:
      return "core: bus fault\n";
    case CoreFault::usage:
      return "core: usage fault\n";
    case CoreFault::code_copy:
      return "core: the copy of the code was wrong\n";
    default:
      return "core: hard fault\n";
  }
}
#endif

}  // namespace

void start_guards() {
  scb::set_priority(4, 0);
  scb::set_priority(5, 0);
  scb::set_priority(6, 0);
  scb::HandlerControl::set(scb::kMemoryFault | scb::kBusFault | scb::kUsageFault);
#ifdef FINEMOTE_CODE_IN_SRAM
  protect_code();
#endif
  // A region of 256 bytes without access at the lower end of the stack, before all others: PM0214 4.2.9, 4.2.10.
  mpu::set_region(7, address_of(&_stack_guard), (7U << 1) | mpu::kExecuteNever);  // 2^(7 + 1) bytes, AP 000: no access
  mpu::Control::write(mpu::kEnable | mpu::kBackground);
  barrier();
}

bool restarted_by_fault(CoreFault& fault) {
  if (last_fault.magic != kFaultMagic) return false;
  last_fault.magic = 0;
  fault = last_fault.fault;
  return true;
}

}  // namespace finemote::cortex_m4

/// `frame`: the stack pointer at entry, on which the exception frame lies if stacking worked.
extern "C" [[noreturn]] __attribute__((used)) void finemote_fault(const std::uint32_t* frame) {
  using namespace finemote;
  using namespace finemote::cortex_m4;
  const auto at = reinterpret_cast<std::uint32_t>(frame);
  const std::uint32_t status = scb::FaultStatus::read();
  LastFault& last = last_fault;
  last.exception = exception_number();
  last.status = status;
  last.address = (status & kBusAddressValid) != 0 ? scb::BusFaultAddress::read() : scb::MemoryFaultAddress::read();
  last.fault = kind_of(last.exception, status, last.address, at);
  const bool frame_valid = in_stack(at) && last.fault != CoreFault::stack;
  last.lr = frame_valid ? frame[5] : 0;  // r0 r1 r2 r3 r12 lr pc xpsr: PM0214 2.3.7
  last.pc = frame_valid ? frame[6] : 0;
  last.magic = kFaultMagic;
  count_fault(Module::core, static_cast<std::uint8_t>(last.fault));
  board::say(FINEMOTE_TEXT(text_of(last.fault)));
  board::stopped();
  barrier();
  scb::ResetControl::write(scb::kResetKey | (scb::ResetControl::read() & scb::kPriorityGroupMask) | scb::kSystemReset);
  barrier();
  for (;;) {}
}

/// The stack may have overflowed: what follows gets a fresh one, nothing returns to the old.
extern "C" __attribute__((naked)) void finemote_fault_entry() {
  asm volatile(
      "mrs r0, msp\n\t"
      "ldr r1, =_stack_top\n\t"
      "msr msp, r1\n\t"
      "b finemote_fault");
}
