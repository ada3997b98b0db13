// What a command has found out, and how that is printed.
#pragma once

#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string>
#include <string_view>

#include "generator/cli/exit_status.hpp"
#include "generator/cli/options.hpp"
#include "generator/diagnostic/diagnostics.hpp"
#include "generator/diagnostic/source.hpp"

namespace finemote::gen {

/// What a command returns; finish() prints it beside the findings of the run.
struct Answer {
  int status = kExitInvalid;
  std::string text = {};                      ///< standard output with --format text, for people: before the findings
  nlohmann::ordered_json document = nullptr;  ///< the same with --format json; null: `text` is a document by itself
  Diagnostics judged = {};                    ///< findings that have settled `status` (of lint, of the timing analysis)
  std::string summary = {}, closing = {};     ///< standard error, before and after the findings
  std::shared_ptr<const Sources> sources = {};  ///< beside the command's own: what its findings point into
  std::string file = {};  ///< standard output with --format text, for programs: after the findings
};

/// The command ends without one: what is wrong has been reported.
inline Answer no_answer() { return {}; }

/// Whether -W error is given, and there is something it is given for.
bool denies_warnings(const Options& options, const Diagnostics& findings);

/// Whether findings are taken as errors: some are, or -W error makes all of them.
bool is_refused(const Options& options, const Diagnostics& findings);

/// Prints an answer and the findings as the options say, and returns the exit status: kExitInvalid when `diagnostics`
/// refuse an answer, else the answer's own. With --format json there is no document for the statuses 2 and 3; findings
/// stand in its `diagnostics`, too.
int finish(const Options& options, Answer answer, const Diagnostics& diagnostics, std::ostream& out, std::ostream& err);

/// As every command writes one: what is no UTF-8, as a name of the user's may be, is replaced.
std::string document_text(const nlohmann::ordered_json& document);

/// The findings in the formats for editors and CI, `input` being what the command works on; empty for text and json.
std::string render_for_ci(Format format, const Diagnostics& findings, const std::string& input);

/// Appends all findings of `from` to those of `to`.
void add_findings(const Diagnostics& from, Diagnostics& to);

/// Writes `text` as the whole of a file a user asked for, all or nothing; reports FM5002 with the system's reason.
bool write_result(const std::string& path, std::string_view text, Diagnostics& diagnostics);

/// Reports FM5002 for a file that could not be written, with the system's reason.
void report_unwritten(const std::string& path, const std::string& reason, Diagnostics& diagnostics);

}  // namespace finemote::gen
