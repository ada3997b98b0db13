// Ends a command: prints the findings and settles the exit status.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "generator/cli/context.hpp"

namespace finemote::gen {

/// The findings as text, coloured when the options and the terminal say so.
std::string render_findings(const Context& context);
std::string render_findings(const Context& context, const Diagnostics& findings);

/// The findings in the formats for editors and CI, `input` being what the command works on; empty for text and json.
std::string render_for_ci(Format format, const Diagnostics& findings, const std::string& input);

/// Copies all findings of `from` behind those of `to`.
void add_findings(const Diagnostics& from, Diagnostics& to);

/// Writes `text` as the whole of a file a user asked for, all or nothing; reports FM5002 with the system's reason.
bool write_result(Context& context, const std::string& path, std::string_view text);

/// Reports FM5002 for a file that could not be written, with the system's reason.
void report_unwritten(Context& context, const std::string& path, const std::string& reason);

/// Whether the command has no answer: errors, or warnings under -W error.
bool is_refused(const Context& context);

/// Prints the findings as the options say and returns the exit status: kExitInvalid when there are errors (or warnings
/// under -W error), else `status`. With --format json `document` is printed to stdout, with the findings in its
/// `diagnostics`, unless the status is 2 or 3; a null document prints nothing.
int finish(Context& context, int status, nlohmann::ordered_json document = nullptr);

/// The same with findings that have settled `status` already (of lint, of the timing analysis): they are printed and
/// listed with the others, and change the status no more.
int finish_with(Context& context, int status, const Diagnostics& judged, nlohmann::ordered_json document);

}  // namespace finemote::gen
