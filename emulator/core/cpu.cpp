#include "emulator/core/cpu.hpp"

#include <cstring>
#include <utility>

#include "emulator/core/factory_memory.hpp"
#include "emulator/core/word_text.hpp"

namespace finemote::emulator {
namespace {

// PM0214 4.4.13: configurable fault status.
constexpr std::uint32_t kInstructionBus = 1U << 8, kPreciseBus = 1U << 9, kBusAddress = 1U << 15,
                        kUndefinedInstruction = 1U << 16, kBadState = 1U << 17, kNoFpu = 1U << 19,
                        kUnaligned = 1U << 24, kInstructionMem = 1, kDataMem = 1U << 1, kMemAddress = 1U << 7;

}  // namespace

Cpu::Cpu(const Around& around, CostModel cost, FlashModel flash)
    : queue_(around.queue),
      reports_(around.reports),
      system_(around.system),
      bus_(around.bus),
      provenance_(around.provenance),
      tags_(around.tags),
      silicon_(around.silicon),
      flash_(Memories::kFlashBytes, 0xFF),
      ram_(Memories::kRamBytes, 0xA5),  // not zero: an image that forgets to clear shows
      core_ram_(Memories::kCoreRamBytes, 0xA5),
      system_memory_(factory_memory()),
      core_(Memories{flash_.data(), ram_.data(), core_ram_.data(), system_memory_.data()}, *this, around.tags),
      asked_flash_(flash) {
  core_.pace.cost = cost;
  core_.pace.flash = flash;
}

void Cpu::set_flash(bool accelerator, unsigned wait_states) {
  if (asked_flash_ != FlashModel::hit) return;
  const FlashModel now = accelerator || wait_states == 0 ? FlashModel::hit : FlashModel::miss_always;
  if (now == core_.pace.flash && wait_states == core_.pace.flash_wait) return;
  core_.pace.flash = now;
  core_.pace.flash_wait = wait_states;
  kick();
}

/// Interrupts and the probe wait for the end of an IT block, unless they are let in.
bool Cpu::stops(std::uint32_t address) {
  if (!interrupt_it_blocks_ && core_.pace.in_it_block(address)) return false;
  if (probe_) probe_(address);
  return kick_ || core_.pace.time >= next_stop_;
}

void Cpu::masks_changed() {
  const Registers& g = core_.registers;
  const bool masked = g.primask != 0 || g.faultmask != 0 || g.basepri != 0;
  if (masked != masked_) note(masked ? ExecutionEvent::Kind::mask : ExecutionEvent::Kind::unmask, 0);
  masked_ = masked;
  kick();
}

/// What an event of the queue makes pending is so since the event was due, be it in the middle of an instruction.
void Cpu::set_log(ExecutionLog* log) {
  log_ = log;
  system_.nvic().on_due = [this](int exception) {
    const Time at = queue_.running() != kNever ? queue_.running() : now();
    if (log_ != nullptr) log_->push_back({at, static_cast<std::uint32_t>(exception), ExecutionEvent::Kind::due});
  };
}

void Cpu::watch(std::uint32_t address, MarkedPlace what) {
  const std::uint32_t place = address < Memories::kMainRamBytes ? Memories::kRamBase + address : address;
  marks_.emplace(place, what);
  core_.mark(place);
}

/// The stamp of the device whose update ends at this mark.
Claim Cpu::claim_at_end(std::uint32_t mark) {
  constexpr std::uint32_t kValidOffset = 8;  // finemote::Stamp: 64 bits of time in ns, then whether it is valid
  const auto stamp = mark % 2 == 1 ? stamps_.find(mark / 2) : stamps_.end();
  const std::uint8_t* bytes = stamp == stamps_.end() ? nullptr : memory(stamp->second, kValidOffset + 1);
  if (bytes == nullptr || bytes[kValidOffset] == 0) return std::nullopt;
  std::int64_t origin_ns = 0;
  std::memcpy(&origin_ns, bytes, sizeof origin_ns);
  return origin_ns;
}

void Cpu::passed(std::uint32_t address, Time at) {
  const auto [first, end] = marks_.equal_range(core_.physical(address));
  for (auto it = first; it != end; ++it) {
    const auto& [number, kind] = it->second;
    if (tags_.is_on() && kind == ExecutionEvent::Kind::mark) provenance_.pass_mark(number, at, claim_at_end(number));
    if (log_ != nullptr) log_->push_back({at, number, kind});
  }
}

void Cpu::saved_float(Time at, Time took) {
  if (log_ != nullptr) log_->push_back({at, static_cast<std::uint32_t>(took), ExecutionEvent::Kind::save});
}

void Cpu::report_unmodelled(const char* what) { reports_.add(Misuse::unmodelled, what, now(), pc()); }

void Cpu::reset() {
  set_flash(true, 0);  // ACR after a reset: RM0090 3.9.1
  system_.reset();
  map_ram_to_zero(false);
  note(ExecutionEvent::Kind::reset, 0);
  provenance_.reset();
  tags_.reset();
  masked_ = false;
  active_.clear();
  left_it_blocks_.clear();
  Registers& g = core_.registers;
  g = Registers{};
  g.r[13] = vector(0) & ~3U;
  g.r[14] = 0xFFFFFFFFU;
  g.next = vector(kReset) & ~1U;
  g.r[15] = g.next + 4;
  core_.pace.expected = g.next;
  core_.pace.cycle = system_.clock().period();
  core_.pace.it_begin = core_.pace.it_end = 0;
  core_.fp_active = core_.lazy_frame = core_.fpu_on = core_.traps_unaligned = false;
  sleeping_ = kick_ = false;
  guard_begin_ = guard_end_ = core_.stack_alarm = 0;
}

void Cpu::stack_moved() {
  const std::uint32_t sp = core_.registers.r[13];
  core_.stack_alarm = guard_end_;
  if (sp < guard_end_ && sp >= guard_begin_ && guard_end_ != 0 && pending_fault_ == 0) {
    pending_fault_ = kMemManage;
    pending_cfsr_ = kDataMem | kMemAddress;
    pending_address_ = sp;
    kick();
  }
}

/// A peripheral may have asked for an interrupt or an earlier event.
void Cpu::after_access() {
  const Time next = queue_.next();
  next_stop_ = next < end_ ? next : end_;
  core_.pace.cycle = system_.clock().period();
  if (system_.nvic().changed() || system_.reset_requested()) kick_ = true;
  set_stop();
}

/// Only what is more urgent comes through.
int Cpu::priority_limit() const {
  int limit = system_.nvic().active_priority();
  const Registers& g = core_.registers;
  if (g.faultmask != 0 && limit > -1) limit = -1;
  if (g.primask != 0 && limit > 0) limit = 0;
  const int masked_from = system_.nvic().group_of(g.basepri);
  if (g.basepri != 0 && limit > masked_from) limit = masked_from;
  return limit;
}

int Cpu::takeable() const {
  const int next = system_.nvic().most_urgent();
  return next != 0 && system_.nvic().priority(next) < priority_limit() ? next : 0;
}

/// Out of sleep; where the chip is strict in this, without the instruction after the WFI: ES0182.
void Cpu::wake() {
  if (!sleeping_) return;
  sleeping_ = false;
  const std::uint32_t slept_at = pc(), place = slept_at % 8;
  const bool in_flash = slept_at < Memories::kFlashBase + Memories::kFlashBytes && (place == 2 || place == 4);
  if (!in_flash || !system_.debug_clock_in_sleep() || silicon_.draw_or_zero(Strictness::wake_up) == 0) return;
  std::uint32_t& next = core_.registers.next;
  const std::uint8_t* lost = memory(next, 2);
  next += lost != nullptr && lost[1] >= 0xE8 ? 4 : 2;
  core_.pace.expected = next;
}

/// Runs instructions until something needs us, and sorts out what.
void Cpu::execute() {
  const Halt why = core_.run();
  const std::uint32_t next = core_.registers.next;
  switch (why) {
    case Halt::asked:
      return;
    case Halt::sleep:
      sleeping_ = true;
      core_.pace.expected = next;
      return;
    case Halt::supervisor_call:
      return call_supervisor();
    case Halt::breakpoint:
      return semihosting();
    case Halt::exception_return:
      return leave(next | 1);
    case Halt::undefined:
      return fault(kUsageFault, kUndefinedInstruction, 0, "undefined instruction at " + hex(next));
    case Halt::no_fpu:
      return fault(kUsageFault, kNoFpu, 0, "floating point before the FPU is on");
    case Halt::bad_state:
      return fault(kUsageFault, kBadState, 0, "jump out of Thumb state at " + hex(pc()));
    case Halt::no_instruction:
      if (!may_execute(next)) return fault(kMemManage, kInstructionMem, 0, "execution is denied at " + hex(next));
      return fault(kBusFault, kInstructionBus, 0, "no instruction at " + hex(next));
    case Halt::bad_access:
      if (core_.takes_unaligned())
        return fault(kUsageFault, kUnaligned, 0,
                     "access to " + hex(core_.bad_address()) + " at " + hex(next) + " is not aligned");
      if (std::exchange(denied_, false))
        return fault(kMemManage, kDataMem | kMemAddress, core_.bad_address(),
                     "write to protected " + hex(core_.bad_address()) + " at " + hex(next));
      return fault(kBusFault, kPreciseBus | kBusAddress, core_.bad_address(),
                   "access to " + hex(core_.bad_address()) + " at " + hex(next));
  }
}

/// What PRIMASK alone keeps out wakes the core too, without being taken: ARMv7-M B1.5.18.
bool Cpu::wakes() const {
  const Nvic& nvic = system_.nvic();
  const int next = nvic.most_urgent();
  const std::uint32_t basepri = core_.registers.basepri;
  if (next == 0 || (basepri != 0 && nvic.priority(next) >= nvic.group_of(basepri))) return false;
  return nvic.priority(next) < nvic.active_priority();
}

Stop Cpu::run_until(Time end) {
  end_ = end;
  Time& time = core_.pace.time;
  while (time < end && !exited_ && !locked_up_) {
    queue_.run(time);
    core_.pace.cycle = system_.clock().period();
    if (system_.take_reset_request() && on_reset_request) on_reset_request();
    take_exceptions();
    if (locked_up_) break;
    if (sleeping_ && wakes()) wake();
    const Time next_event = queue_.next();
    if (sleeping_) {
      if (next_event == kNever) return Stop::dead;
      const Time until = next_event < end ? next_event : end;
      if (until > time) {
        idle_ += until - time;
        system_.slept(until - time);
        time = until;
      }
      continue;
    }
    next_stop_ = next_event < end ? next_event : end;
    set_stop();
    execute();
  }
  if (time >= end) queue_.run(time);  // what is due at the end itself too
  return exited_ ? Stop::exit : locked_up_ ? Stop::lockup : Stop::time;
}

}  // namespace finemote::emulator
