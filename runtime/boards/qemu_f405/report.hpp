// Writes what happened as text lines: the run protocol of the host board, by semihosting.
#pragma once

namespace finemote::qemu_f405 {

/// `E <ns> <stage> B|E` for every event in the ring. Called from the idle loop, so that the ring does not fill.
void report_events();

/// The remaining events, then `O <bucket> <overruns>`, `B <bus> <transfers> <errors>`
/// for every bus that counts in the order they were started, `F <module> <number> <count>`, `L <lost events>` if any.
void report_run();

/// `S <ns>`: the time of the safe stop.
void report_stop();

}  // namespace finemote::qemu_f405
