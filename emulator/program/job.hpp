// Turns a job (an image, what hangs on the board, how long) into a record of what the board did.
//
// Both are JSON documents between this program and the one that starts it, of the same build, so without a version.
// Job: `board` (what of its board file the emulator wires: emulator/chip/wiring.hpp), `image` (path of an ELF; without
// it the parts are wired and nothing runs), `flash` (hit or miss), `run_ns` (how long, from the first release on),
// `duration_ns` (how much of it stages are recorded), `parts` and, where there is one, `events` (documents
// finemote.scenario/1), `ports` (the buses to account for). Record: `stop` (null when the time was over), `error`
// (instead of everything else: `events` cannot be wired), `reports`, `resets`, `faulty`, `fault_counts`, `stages`,
// `parts`, `expectations`, `buses`, `monitor`; with a `stop` only `reports`, `fault_counts` and `fault_ns`, when the
// first fault was seen. Times are ns since the first release, those of reports and faults since power-on.
#pragma once

#include <nlohmann/json.hpp>

namespace finemote::emulator {

/// @throws std::exception  a job of another shape, or an image that cannot be loaded
nlohmann::ordered_json run_job(const nlohmann::ordered_json& job);

}  // namespace finemote::emulator
