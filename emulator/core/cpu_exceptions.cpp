// Exceptions: taken, entered, left, and faults on the way.
#include <cstring>

#include "emulator/core/cpu.hpp"
#include "emulator/core/word_text.hpp"

namespace finemote::emulator {
namespace {

// Exception entry and return without wait states, a return that restores the floating-point registers, and a
// tail-chained entry: Cortex-M4 TRM 3.9.1 and ARMv7-M B1.5.
constexpr unsigned kEntryCycles = 12, kReturnCycles = 10, kFloatReturnCycles = 27, kTailCycles = 6;

// PM0214 4.4.13: configurable fault status.
constexpr std::uint32_t kStackingMem = 1U << 4, kBadReturn = 1U << 18;

}  // namespace

/// An SVC that cannot be taken at once is a hard fault: B1.5.2.
void Cpu::call_supervisor() {
  if (system_.nvic().priority(kSvCall) < priority_limit()) return system_.nvic().pend(kSvCall);
  fault(kHardFault, 0, 0, "supervisor call while it is masked");
}

void Cpu::enter(int exception, bool tail_chained, std::uint32_t chained_return) {
  note(tail_chained ? ExecutionEvent::Kind::tail : ExecutionEvent::Kind::enter, exception);
  std::uint32_t exc_return = chained_return;
  Registers& g = core_.registers;
  Pace& pace = core_.pace;
  if (!tail_chained) {
    const bool fp = core_.fp_active, process = g.on_process_stack();
    const std::uint32_t sp = g.r[13], pad = sp & 4, frame = sp - pad - (fp ? 104U : 32U);
    std::uint8_t* bytes = memory(frame, fp ? 104 : 32);
    const bool guarded = guard_end_ != 0 && frame < guard_end_ && frame + 32 > guard_begin_;
    if (bytes == nullptr || guarded) {  // stacking fails: hard fault without a usable frame is the end
      reports_.add(Misuse::fault, "exception " + std::to_string(exception) + " finds no stack at " + hex(frame), now(),
                   pc());
      system_.note_fault(kStackingMem, frame, true);
      locked_up_ = true;
      return;
    }
    const std::uint32_t saved[] = {g.r[0],  g.r[1],  g.r[2], g.r[3],
                                   g.r[12], g.r[14], g.next, g.xpsr() | (pad != 0 ? 0x200U : 0)};
    std::memcpy(bytes, saved, sizeof saved);
    ram_changed(frame, fp ? 104 : 32);
    if (fp) {
      std::memcpy(bytes + 32, g.s.data(), 64);
      std::memcpy(bytes + 96, &g.fpscr, 4);
    }
    left_it_blocks_.leave({pace.it_begin, pace.it_end}, frame);
    g.r[13] = frame;
    exc_return = 0xFFFFFFE1U | (fp ? 0U : 0x10U) | (active_.empty() ? 8U : 0U) | (process ? 4U : 0U);
    if (fp) core_.lazy_frame = true;  // without, what an outer routine interrupted may still wait to be saved
    provenance_.enter(frame);
    tags_.enter(frame);
    pace.charge(kEntryCycles);
  } else {
    provenance_.tail();
    pace.charge(kTailCycles);
  }
  core_.fp_active = false;
  active_.push_back(exception);
  system_.nvic().enter(exception);
  system_.set_active_exception(exception);
  g.set_xpsr(static_cast<std::uint32_t>(exception));
  g.choose_stack(false);  // B1.5.6
  g.exclusive = false;
  g.r[14] = exc_return;
  if (pace.is_flash(system_.vector_table())) pace.read_flash();
  g.next = vector(exception) & ~1U;
  g.r[15] = g.next + 4;
  pace.expected = g.next;
  pace.it_begin = pace.it_end = 0;
  stack_moved();
}

/// Back to a handler, or to thread mode on either stack; which of them, the number of active exceptions says: B1.5.8.
bool Cpu::fits_return(std::uint32_t exc_return) const {
  const std::uint32_t target = exc_return & ~0x10U;
  if (active_.size() > 1) return target == 0xFFFFFFE1U;
  return target == 0xFFFFFFE9U || target == 0xFFFFFFEDU;
}

void Cpu::leave(std::uint32_t exc_return) {
  if (active_.empty()) return fault(kUsageFault, kBadReturn, 0, "exception return without an exception");
  if (!fits_return(exc_return))
    return fault(kUsageFault, kBadReturn, 0, "exception return with " + hex(exc_return) + " in the link register");
  Registers& g = core_.registers;
  Pace& pace = core_.pace;
  const int exception = active_.back();
  active_.pop_back();
  note(ExecutionEvent::Kind::leave, exception);
  bus_.returning(exception);
  system_.nvic().leave(exception);
  if (on_return) on_return(exception);
  g.exclusive = false;
  if (exception != kHardFault && exception != kNmi) g.faultmask = 0;
  if (const int next = takeable(); next != 0) {
    static_cast<void>(system_.nvic().take_change());
    enter(next, true, exc_return);
    return;
  }
  const bool fp = (exc_return & 0x10) == 0;
  const bool process = (exc_return & 4) != 0;
  g.choose_stack(process);
  const std::uint32_t frame = process ? g.process_stack() : g.r[13];
  const std::uint8_t* bytes = memory(frame, fp ? 104 : 32);
  if (bytes == nullptr) {
    reports_.add(Misuse::fault, "exception return finds no frame at " + hex(frame), now(), pc());
    locked_up_ = true;
    return;
  }
  std::uint32_t saved[8];
  std::memcpy(saved, bytes, sizeof saved);
  const std::uint32_t xpsr = saved[7];
  (process ? g.process_stack() : g.r[13]) = frame + (fp ? 104U : 32U) + ((xpsr & 0x200) != 0 ? 4U : 0U);
  const auto active = static_cast<std::uint32_t>(active_.empty() ? 0 : active_.back());
  g.set_xpsr((xpsr & ~0x3FFU) | active);
  for (unsigned i = 0; i < 4; ++i) g.r[i] = saved[i];
  g.r[12] = saved[4];
  g.r[14] = saved[5];
  g.next = saved[6] & ~1U;
  g.r[15] = g.next + 4;
  if (fp) {
    std::memcpy(g.s.data(), bytes + 32, 64);
    std::memcpy(&g.fpscr, bytes + 96, 4);
  }
  const ItBlock left = left_it_blocks_.come_back(frame);
  pace.it_begin = left.begin;
  pace.it_end = left.end;
  core_.fp_active = fp;
  const bool restores = fp && !core_.lazy_frame;  // where no routine used them the registers still hold
  if (fp) core_.lazy_frame = false;
  system_.set_active_exception(static_cast<int>(active));
  pace.expected = g.next;
  pace.charge(restores ? kFloatReturnCycles : kReturnCycles);
  provenance_.resume(frame);
  tags_.resume(frame);
  note(ExecutionEvent::Kind::resume, exception);
  sleeping_ = active_.empty() && system_.sleeps_on_exit();
}

void Cpu::fault(int exception, std::uint32_t cfsr, std::uint32_t address, const std::string& what) {
  const auto accessed = address != 0 ? std::optional(address) : std::nullopt;
  reports_.add(Misuse::fault, what, now(), pc(), accessed);
  const Nvic& nvic = system_.nvic();
  const bool masked = core_.registers.primask != 0;
  const bool reachable = nvic.is_enabled(exception) && nvic.priority(exception) < nvic.active_priority() && !masked;
  if (!reachable && nvic.active_priority() <= -1) {
    locked_up_ = true;
    return;
  }
  system_.note_fault(cfsr, address, !reachable);
  core_.registers.next = pc();
  enter(reachable ? exception : static_cast<int>(kHardFault), false, 0);
}

void Cpu::take_exceptions() {
  kick_ = false;
  static_cast<void>(system_.nvic().take_change());
  if (pending_fault_ != 0) {
    const int exception = pending_fault_;
    pending_fault_ = 0;
    guard_end_ = 0;  // one report; the handler may use the stack
    fault(exception, pending_cfsr_, pending_address_, "the stack reached its guard at " + hex(pending_address_));
    return;
  }
  if (const int next = takeable(); next != 0) {
    wake();
    enter(next, false, 0);
  }
}

}  // namespace finemote::emulator
