// The host board's virtual time: for tests, and for models of what hangs on the buses.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "finemote/time.hpp"

namespace finemote::host {

/// One recorded begin or end of a stage.
struct Event {
  Time at;
  std::uint16_t stage;  ///< 2 * device index + (0 update, 1 handle)
  bool end;
};

/// Runs `routine` as an interrupt at `when` (>= now), above every bucket: in order of time, ties in order of asking.
/// It takes no virtual time of its own.
void interrupt_at(Time when, std::function<void()> routine);

/// Runs the linked robot (`finemote_schedule`) from its start to `duration`: releases, preemption, overruns. Jobs still
/// running at the end are finished, but what happens from `duration` on is not recorded. Time passes in busy() alone
/// and between jobs; a stage sees the releases and interrupts of the instant it begins at. False when the robot stopped
/// itself: see stop_text().
bool run(Duration duration);

/// Lets virtual time pass without a robot, interrupts included: for tests of buses and devices.
void advance(Duration duration);

/// What run() recorded, in the order it happened; empty unless built with FINEMOTE_TRACE.
const std::vector<Event>& events();

/// True while the watchdog would be fed: every bucket completes jobs.
bool watchdog_fed();

/// Set by stop_safely(): the text it was given, empty while the robot has not stopped.
const std::string& stop_text();

/// Forgets everything: time 0, no interrupts, no events.
void reset();

/// The run protocol on stdout: `E <ns> <stage> B|E`, then `O <bucket> <overruns>`, `B <bus> <transfers> <errors>`
/// for every bus that counts in the order they were started, `F <module> <number> <count>`, `S <ns>` where
/// it stopped itself, and with the monitor `M <device> <worst response> <worst age> <late> <old>`.
void print_run();

}  // namespace finemote::host
