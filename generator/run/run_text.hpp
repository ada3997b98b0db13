// The result of a run for people.
#pragma once

#include <ostream>

#include "generator/run/run_result.hpp"

namespace finemote::gen {

/// A summary up to the first blank line, whose first line says whether the run passed; then the chains with the least
/// room, buses, and what is not as it should be.
/// @param failures    why it did not pass, a few words each; empty: it passed
/// @param is_verbose  also the observed order, all parts of all chains, and all responses
void print_run(const RunResult& result, const std::vector<std::string>& failures, bool is_verbose, std::ostream& out);

/// `flash 14032 B, RAM 3560 B, stack 1208 B (proven)`; nothing for a host executable.
void print_image(const ImageFacts& image, std::ostream& out);

}  // namespace finemote::gen
