// --dump: a stage of the pipeline instead of what the command does.
#pragma once

#include "generator/cli/answer.hpp"
#include "generator/cli/options.hpp"
#include "generator/input/input.hpp"
#include "generator/tasks/from_robot.hpp"

namespace finemote::gen {

/// The stage `options.dump`, which must be set. `document` needs a text that can be read; every other stage needs a
/// robot without mistakes.
/// @param tasks  of stage `tasks`
Answer dump_robot(const Options& options, const Input& input, const timing::RobotTimingOptions& tasks, Sources& sources,
                  Diagnostics& diagnostics);

/// The same for commands whose IN may be a timing model, which has stage `tasks` alone: FM0001 for another one.
Answer dump_subject(const Options& options, const timing::RobotTimingOptions& tasks, Sources& sources,
                    Diagnostics& diagnostics);

}  // namespace finemote::gen
