// The command line to what the pipeline is asked.
#pragma once

#include <optional>

#include "generator/cli/options.hpp"
#include "generator/diagnostic/diagnostics.hpp"
#include "generator/input/input.hpp"
#include "generator/output/folder.hpp"
#include "generator/pipeline.hpp"

namespace finemote::gen {

/// IN, and where what it names is found. Reports FM0007 and returns nothing when there is no data folder.
std::optional<Input> input_of(const Options& options, Diagnostics& diagnostics);

/// The files of `planned`, with the manifest that says what they were made from.
Output output_of(std::vector<OutputFile> files, const PlannedRobot& planned, const Input& input,
                 const Sources& sources);

}  // namespace finemote::gen
