// The record as one line of JSON, finemote.bench/1: on the serial port of the plan, and in memory behind an RTT control
// block, where a debug probe finds it whatever the clocks do.
#pragma once

#include <cstdint>

namespace finemote::bench_kit {

/// Writes the text into memory; a probe may read it from now on.
void write_report();

/// Sends it. Waits for each byte at most as long as three take.
/// @param bus_hz  what the port's rate is divided from, now
void send_report(std::uint32_t bus_hz);

}  // namespace finemote::bench_kit
