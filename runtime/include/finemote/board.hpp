// What a board gives to the runtime. One definition per linked board; robots and devices do not use it.
#pragma once

#include <cstdint>

#include "finemote/fault.hpp"
#include "finemote/time.hpp"

namespace finemote::board {

/// Clocks, power, flash: everything before the first bus. Called once, first thing in main. Bounded waits only.
void start_hardware();

/// Whether a watchdog or a sagging supply restarted the board, which it then counts as a fault. Called once, before
/// start_hardware(). False on a board that cannot tell.
bool restarted_unasked();

/// Starts a watchdog that resets the board when not fed for clearly longer than `longest_gap`, even with its slowest
/// clock reading fast. Called once, just before the first release. A board without a watchdog does nothing.
void start_watchdog(Duration longest_gap);
void feed_watchdog();

/// Text for whoever listens (semihosting, host), or null: nothing. Start-up and stops only.
void say(const char* text);

/// Called by stop_safely() once, after the first safe outputs, and by nobody else: a board that runs under a test ends
/// the run with an exit status other than 0; any other returns.
void stopped();

}  // namespace finemote::board
