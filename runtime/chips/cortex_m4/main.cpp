// main of every Cortex-M4 image: start, release, idle; and what is left of the robot once it has stopped.
#include "finemote/board.hpp"
#include "finemote/fault.hpp"
#include "finemote/schedule.hpp"
#include "runtime/chips/cortex_m4/core.hpp"
#include "runtime/chips/cortex_m4/fault.hpp"
#include "runtime/chips/cortex_m4/registers.hpp"
#include "runtime/chips/cortex_m4/release.hpp"
#include "runtime/src/start.hpp"

namespace finemote {
namespace {

// The release timer counts 2^24 cycles; ticks are whole units of cycles.
constexpr std::int64_t kLongestTick =
    std::int64_t{cortex_m4::systick::kMaxInterval} * cortex_m4::kNsPerUnit / cortex_m4::kCyclesPerUnit;
constexpr detail::ReleaseTimer kTimer{kLongestTick, cortex_m4::kNsPerUnit, true};

/// How long the start-up waits at most, in cycles, for buses that do not become quiet: one on which nobody
/// acknowledges, for example. A burst to sixteen outputs of an expander takes 7 ms at 100 kHz, 64 bytes at 9600 baud
/// take 67 ms.
constexpr std::uint32_t kLongestStart = cortex_m4::kCoreHz / 10;
/// The same where cycles are not counted: a poll takes 30 cycles at least.
constexpr std::uint32_t kStartPolls = kLongestStart / 30;

/// Why the robot stopped safely. Not zeroed at start: a stop outlasts restarts that nobody asked for.
struct LastStop {
  std::uint32_t magic;  // kStopMagic when the rest is meant
  Module module;
  std::uint8_t number;
};
constexpr std::uint32_t kStopMagic = 0x53544F50;
__attribute__((section(".noinit"))) LastStop last_stop;

/// Stops again where the robot had stopped before the watchdog, or a sagging supply, restarted the board.
void stay_stopped(bool restarted_unasked) {
  const bool had_stopped = last_stop.magic == kStopMagic;
  last_stop.magic = 0;
  if (restarted_unasked && had_stopped) {
    stop_safely(last_stop.module, last_stop.number, FINEMOTE_TEXT("restarted after a safe stop"));
  }
}

/// The first job finds quiet buses: what the start-up sent, safe outputs among it, is over.
void settle(const Schedule& schedule) {
  if (schedule.buses_quiet == nullptr) return;
  const std::uint32_t start = cortex_m4::cycles();
  for (std::uint32_t polls = kStartPolls; polls != 0; --polls) {
    if (schedule.buses_quiet() || cortex_m4::cycles() - start >= kLongestStart) return;
  }
}

}  // namespace

// Raises the mask to the release level: no bucket and no release runs any more, bus interrupts do.
void stop_safely(Module module, std::uint8_t number, const char* text) {
  cortex_m4::mask_from(cortex_m4::kReleasePriority);
  count_fault(module, number);
  last_stop = {kStopMagic, module, number};
  detail::set_stopped(true);
  if (detail::outputs_started()) finemote_schedule.safe_outputs();
  board::say(text);
  board::say(FINEMOTE_TEXT("\n"));
  board::stopped();
  for (;;) {
    // Again at every instant: a bus that is being recovered takes the safe output as its first transfer.
    if (cortex_m4::pass_instant() && detail::outputs_started()) finemote_schedule.safe_outputs();
  }
}

}  // namespace finemote

int main() {
  using namespace finemote;
  cortex_m4::start_guards();
  const bool restarted_unasked = board::restarted_unasked();  // first: what fails below would leave the cause in place
  board::start_hardware();
  cortex_m4::start_cycles(0);  // bus start-up measures its bounded waits with it
  detail::start_robot(finemote_schedule, kTimer);
  settle(finemote_schedule);
  cortex_m4::start_releases(finemote_schedule);
  CoreFault fault;
  if (cortex_m4::restarted_by_fault(fault)) {
    stop_safely(Module::core, static_cast<std::uint8_t>(fault), FINEMOTE_TEXT("restarted after a processor fault"));
  }
  stay_stopped(restarted_unasked);
  cortex_m4::idle();
}
