// Turns a job (an image, what hangs on the board, how long) into a record of what the board did.
//
// Both are JSON documents between this program and the one that starts it, of the same build, so without a version.
// Times are in ns (those whose name ends in _ps, in ps) since the first release; of reports and faults since power-on.
//
// Job; what is in brackets may be missing:
// - `board`: what of its board file the emulator wires (emulator/chip/wiring.hpp)
// - [`image`]: path of an ELF; without it the parts are wired and nothing runs
// - [`flash`]: `hit`, which is the default, or `miss`: every new line costs the wait states
// - [`silicon`]: `names` of the freedom that the chip uses, and the `seed` that draws how much
// - [`tags`]: whether the board follows where bytes come from; true by default
// - `parts`: what hangs on the board, a document finemote.scenario/1
// - [`events`]: another one: what happens (its `events`), and what has to be seen (its `expect`)
// - `await`: each `part` whose first sample, or first `output`, ends the bring-up
// - `bring_up_ns`: how long that may take from the first release on
// - [`least_bring_up_ns`]: how long it takes at least
// - `duration_ns`: how long the board runs from the end of the bring-up on
// - `last_event_ns`: up to when it runs at least
// - `ports`: the buses to account for
// - [`loops`]: `[place, borders]`, addresses of each loop whose passes are counted
// - [`audit`]: exceptions of the buckets; asks for every event (emulator/program/audit.hpp)
// - [`works`]: further marks to tell there
//
// Record of a board that ran to the end; empty where there was no image:
// - `stop`: null
// - `reports`: what the firmware did wrong with the hardware: `misuse`, `text`, `count`, `first_ns`, `pc`
// - `resets`: how many, without those that `events` asked for
// - `scripted_resets`: those
// - `overruns`: how many, by bucket, those before a reset included
// - `violated`: each `assumption` of the bounds that `events` violate, by `part` or `port`, empty where none is named
// - `violated_from_ns`: when the first of these events happens; null: none does
// - `undisturbed`: `fault_counts`, `monitor` and `traffic` then; null where it is before the end of the bring-up, or
// none
// - `fault_counts`: `[module, number, count]` of each fault
// - `first_release_ns`: since power-on
// - `ready_ns`: when the bring-up ended
// - `faults_at_ready`: `fault_counts` then
// - `absent`: awaited parts that were not seen
// - `stages`: `[time, stage, whether it begins]`
// - `parts`: samples and outputs: `part`, `output`, `channel`, `from_ps`, `at_ps`, `n`; of an output also its `value`
//   and the `stage` of the handle whose run `n` it carries, null where none is known
// - `uses`: samples that updates took: `[time in ps, stage, part, channel, n, claimed time in ps or null]`
// - `handed_over`: `[stage, run]` of each handle that gave a driver something to send
// - `expectations`: `part`, `value`, `from_ns`, `to_ns`, `min`, `max`; seen: `lowest`, `highest`, `finite`; `ok`
// - `series`: values of the parts over time (emulator/program/value_series.hpp)
// - `buses`: of each of `ports` the `transfers`, `errors`, and the share of time that it was `busy`
// - `traffic`: what they carried from then on, when the bring-up was over (emulator/program/traffic_count.hpp)
// - `own_stages`: `[stage, longest in ps, runs]`
// - `own_works`: the same of marks that are no stages'
// - `own_exceptions`: the same of exceptions
// - `loop_passes`: how often the place of each of `loops` was passed at most; 0: it was never entered
// - `monitor`: the monitor's records (runtime/include/finemote/monitor.hpp)
// - `audit`: every event; null where it was not asked for
//
// Record of a board that stopped: `stop`, in words, `reports`, `fault_counts`, and
// - `fault_ns`: when the first fault was seen; null where none was
//
// Record of `events` that cannot be wired:
// - `error`: why
#pragma once

#include <functional>
#include <nlohmann/json.hpp>

#include "emulator/board.hpp"

namespace finemote::emulator {

/// @throws std::exception  a job of another shape, or an image that cannot be loaded
/// @param watch  called with the board before power-on, where it is set; the board keeps its log then
nlohmann::ordered_json run_job(const nlohmann::ordered_json& job, const std::function<void(Board&)>& watch = {});

}  // namespace finemote::emulator
