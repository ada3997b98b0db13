// The commands of the tool: a table with a row for each, and their functions, each in a file of its own.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "generator/cli/answer.hpp"
#include "generator/cli/option.hpp"
#include "generator/cli/options.hpp"
#include "generator/diagnostic/diagnostics.hpp"

namespace finemote::gen {

/// What the definition of the command line, --help and the test of docs/reference/commands.md are made from.
struct Command {
  const char* name;  ///< of two words for one below another: `board show`
  const char* summary;
  std::vector<Option> options;  ///< in the order of --help, operands first
  Answer (*run)(const Options& options, Sources& sources, Diagnostics& diagnostics);
  std::string (*footer)() = nullptr;  ///< below the options in --help
};

/// In the order of --help.
const std::vector<Command>& commands();

/// Whether the command has an option of this name: `--show-config`.
bool has_option(const Command& command, std::string_view name);

/// The command of this name, which must exist.
const Command& command_named(std::string_view name);

/// Of the first word of commands of two: what --help says of it.
const char* group_summary(std::string_view word);

/// The options that every command takes.
const std::vector<Option>& common_options();

Answer run_generate(const Options& options, Sources& sources, Diagnostics& diagnostics);
Answer run_check(const Options& options, Sources& sources, Diagnostics& diagnostics);
Answer run_tree(const Options& options, Sources& sources, Diagnostics& diagnostics);
Answer run_graph(const Options& options, Sources& sources, Diagnostics& diagnostics);
Answer run_report(const Options& options, Sources& sources, Diagnostics& diagnostics);
Answer run_board_show(const Options& options, Sources& sources, Diagnostics& diagnostics);
Answer run_init(const Options& options, Sources& sources, Diagnostics& diagnostics);
Answer run_scaffold_device(const Options& options, Sources& sources, Diagnostics& diagnostics);
Answer run_scaffold_board(const Options& options, Sources& sources, Diagnostics& diagnostics);
Answer run_board_sources(const Options& options, Sources& sources, Diagnostics& diagnostics);
Answer run_run(const Options& options, Sources& sources, Diagnostics& diagnostics);
Answer run_bench_kit(const Options& options, Sources& sources, Diagnostics& diagnostics);
Answer run_wcet(const Options& options, Sources& sources, Diagnostics& diagnostics);
Answer run_diff(const Options& options, Sources& sources, Diagnostics& diagnostics);
Answer run_import(const Options& options, Sources& sources, Diagnostics& diagnostics);
Answer run_fmt(const Options& options, Sources& sources, Diagnostics& diagnostics);
Answer run_lint(const Options& options, Sources& sources, Diagnostics& diagnostics);
Answer run_docs(const Options& options, Sources& sources, Diagnostics& diagnostics);
Answer run_explain(const Options& options, Sources& sources, Diagnostics& diagnostics);
Answer run_schema(const Options& options, Sources& sources, Diagnostics& diagnostics);
Answer run_completion(const Options& options, Sources& sources, Diagnostics& diagnostics);
Answer run_man(const Options& options, Sources& sources, Diagnostics& diagnostics);
Answer run_xacro(const Options& options, Sources& sources, Diagnostics& diagnostics);
Answer run_analyze(const Options& options, Sources& sources, Diagnostics& diagnostics);
Answer run_simulate(const Options& options, Sources& sources, Diagnostics& diagnostics);

}  // namespace finemote::gen
