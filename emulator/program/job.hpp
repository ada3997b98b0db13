// Turns a job (an image, what hangs on the board, how long) into a record of what the board did.
//
// Both are JSON documents between this program and the one that starts it, of the same build, so without a version.
// Job: `board` (what of its board file the emulator wires: emulator/chip/wiring.hpp), `image` (path of an ELF; without
// it the parts are wired and nothing runs), `flash` (hit or miss), `silicon`
// (`names` of what the chip is meaner in, and `seed`; without it: nothing), `await` (parts whose first sample, or first
// `output`, ends the bring-up), `bring_up_ns` (how long that may take from the first release on), `duration_ns` (how
// long it runs from then on), `last_event_ns` (up to when it runs at least, from the first release on), `parts` and,
// where there is one, `events` (documents finemote.scenario/1), `ports` (the buses to account for), `audit` (exceptions
// of the buckets: asks for every event; emulator/program/audit.hpp) and `works` (further marks to tell there). Record:
// `stop` (null when the time was over), `error` (instead of everything else: `events` cannot be wired), `reports`,
// `resets`, `violated` (each `assumption` of the bounds that `events` violate, by `part` or `port`, empty where none is
// named), `fault_counts`, `first_release_ns` (since power-on), `ready_ns` (when the bring-up ended, since the first
// release), `faults_at_ready`
// (`fault_counts` then), `absent` (awaited parts that were not seen), `stages`, `parts`, `uses` (which samples each
// update took), `own_stages`, `own_works` and `own_exceptions`, `expectations`, `buses`, `monitor`, `audit` (null where
// it was not asked for); with a `stop` only `reports`, `fault_counts` and `fault_ns`, when the first fault was seen.
// Times are ns since the first release, those of reports and faults since power-on.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>

#include "emulator/board.hpp"

namespace finemote::emulator {

/// @throws std::exception  a job of another shape, or an image that cannot be loaded
/// @param watch  called with the board before power-on, where it is set; the board keeps its log then
nlohmann::ordered_json run_job(const nlohmann::ordered_json& job, const std::function<void(Board&)>& watch = {});

}  // namespace finemote::emulator
