// The command line to what a run may read and use up.
#pragma once

#include "generator/cli/options.hpp"
#include "generator/diagnostic/diagnostics.hpp"

namespace finemote::gen {

/// The policy that `--sandbox` asks for: the folders of the inputs, of `--package` and `--device-path`, and shipped
/// data. Reports FM0008 for a folder that is reached through a link out of the working directory, and for the root of
/// the file system. Without `--sandbox`: every regular file.
files::Access read_access(const Options& options, Diagnostics& diagnostics);

/// Bounds memory and processor time of the process, for a command in the sandbox. What reaches them ends with FM0009.
void bound_resources();

/// FM0009, for a run that needs more memory than bound_resources() leaves.
void report_memory_limit(Diagnostics& diagnostics);

}  // namespace finemote::gen
