// finemote man: the table of commands as a manual page.
#include <fmt/format.h>

#include "generator/cli/answer.hpp"
#include "generator/cli/commands.hpp"
#include "generator/diagnostic/roff.hpp"
#include "generator/version.hpp"

namespace finemote::gen {
namespace {

/// `fB\-o\fR, \fB\-\-output\fR \fIVALUE\fR`.
std::string option_term(const Option& option) {
  std::string term;
  for (const std::string& name : names_of(option))
    term += fmt::format("{}\\fB{}\\fR", term.empty() ? "" : ", ", roff(name));
  if (is_operand(option) || !takes_value(option)) return term;
  std::string values;
  for (const std::string& value : values_of(option)) values += (values.empty() ? "" : "|") + value;
  return term + " \\fI" + (values.empty() ? "VALUE" : roff(values)) + "\\fR";
}

std::string option_list(const std::vector<Option>& options) {
  std::string text;
  for (const Option& option : options) text += fmt::format(".TP\n{}\n{}.\n", option_term(option), roff(option.help));
  return text;
}

/// `finemote board show [OPTIONS] [BOARD]`.
std::string synopsis(const Command& command) {
  std::string operands;
  for (const Option& option : command.options) {
    if (!is_operand(option)) continue;
    const std::string name = fmt::format("\\fI{}\\fR", option.names);
    operands += option.need == Option::Need::required ? " " + name : " [" + name + "]";
  }
  return fmt::format("\\fB{}\\fR{}", roff(command.name), operands);
}

constexpr const char* kIntroduction =
    R"(finemote reads the URDF or xacro file of a robot that is extended with a board, buses, devices and periods, proves how
old every command of the robot can be, and writes its firmware as C++17. The words \fIname\fR:=\fIvalue\fR, any number and
anywhere, are the arguments of a xacro file.
)";

constexpr const char* kStatus = R"(.SH EXIT STATUS
.TP
0
Done; the answer is yes.
.TP
1
Ran; the answer is no: stale, different, unschedulable, a requirement fails, measured above a bound.
.TP
2
No answer: wrong usage, unreadable or invalid input, a missing tool.
.TP
3
An internal error of finemote.
.SH ENVIRONMENT
.TP
\fBFINEMOTE_DATA\fR
Folder with schemas, templates and runtime, instead of the installed one.
.TP
\fBROS_PACKAGE_PATH\fR, \fBAMENT_PREFIX_PATH\fR
Where the packages lie that a xacro file names.
.TP
\fBNO_COLOR\fR
Diagnostics have no colour.
.SH FILES
.TP
\fIshare/finemote/README.md\fR
Where the manual begins, in the folder that also has the programs' \fIbin\fR. Its pages are in \fIshare/finemote/docs\fR:
\fItutorial.md\fR, \fIhowto/onto-the-board.md\fR, \fIhowto/bench-kit.md\fR for the first board of its kind.
)";

std::string man_page() {
  std::string text = fmt::format(
      ".TH FINEMOTE 1 \"\" \"finemote {}\" \"User Commands\"\n"
      ".SH NAME\nfinemote \\- firmware of robots from their URDF, with proven latency\n"
      ".SH SYNOPSIS\n\\fBfinemote\\fR \\fICOMMAND\\fR [\\fIOPTION\\fR]... [\\fIname\\fR:=\\fIvalue\\fR]...\n"
      ".SH DESCRIPTION\n{}.SH COMMANDS\n",
      roff(kVersion), kIntroduction);
  for (const Command& command : commands())
    text += fmt::format(".SS {}\n{}.\n{}", synopsis(command), roff(command.summary), option_list(command.options));
  return text + ".SH OPTIONS OF ALL COMMANDS\n" + option_list(common_options()) + kStatus;
}

}  // namespace

Answer run_man(const Options& /*options*/, Sources& /*sources*/, Diagnostics& /*diagnostics*/) {
  return {kExitYes, man_page()};
}

}  // namespace finemote::gen
