#include "generator/cli/options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <sstream>

#include "generator/cli/command_words.hpp"
#include "generator/cli/exit_status.hpp"
#include "generator/cli/finish.hpp"
#include "generator/diagnostic/render.hpp"
#include "generator/diagnostic/suggest.hpp"
#include "generator/lint/rules.hpp"
#include "generator/version.hpp"

namespace finemote::gen {
namespace {

std::string version_text() {
  std::ostringstream text;
  text << "finemote " << kVersion << "\nextension version 1 to " << kExtensionVersion << ", output format "
       << kOutputFormat << ", device descriptors finemote.device/1, boards finemote.board/1";
  return text.str();
}

constexpr const char* kArgumentsHelp =
    "name:=value, any number and anywhere: the value of a <xacro:arg> (of a file that is read as xacro)";

void add_load_options(CLI::App& command, Options& options) {
  command.add_option("--board", options.board, "use this board instead of the one the robot names");
  command.add_option("--device-path", options.device_paths, "further folder with device descriptors");
  command.add_option("--package", options.packages, "name=dir: where a package lies");
}

/// For commands that read a stranger's file and start nothing.
void add_sandbox(CLI::App& command, Options& options) {
  command.add_flag("--sandbox", options.sandbox,
                   "read only below the folder of IN, packages named with --package, and shipped data");
}

/// For commands that compile or run what the file describes: whoever asks for a sandbox must not believe in one.
void refuse_sandbox(CLI::App& command) {
  command.add_flag_callback(
      "--sandbox",
      [] { throw CLI::ValidationError("--sandbox", "it compiles the robot's own code, which no sandbox holds"); },
      "refused: this command compiles the robot's own code");
}

void add_input_options(CLI::App& command, Options& options) {
  command.add_option("IN", options.input, "robot description: .urdf, .xacro, or - for standard input")->required();
  command.footer(kArgumentsHelp);
  add_load_options(command, options);
}

/// An option with a few possible words.
template <typename Value>
CLI::Option* add_choice(CLI::App& app, const char* name, const std::vector<std::pair<std::string, Value>>& choices,
                        Value& target, const char* help) {
  std::string words_text;
  for (const auto& [word, value] : choices) words_text += (words_text.empty() ? "" : "|") + word;
  CLI::Option* option = app.add_option(
      name,
      [name, choices, &target](const CLI::results_t& words) {
        std::vector<std::string> valid;
        for (const auto& [word, value] : choices) {
          if (word == words.back()) return target = value, true;
          valid.push_back(word);
        }
        throw CLI::ValidationError(name, "'" + words.back() + "': " + did_you_mean(words.back(), valid));
      },
      help);
  return option->option_text(words_text);
}

const std::vector<std::pair<std::string, Format>> kFormats{{"text", Format::text},
                                                           {"json", Format::json},
                                                           {"sarif", Format::sarif},
                                                           {"github", Format::github},
                                                           {"gcc", Format::gcc}};

void add_global_options(CLI::App& app, Options& options) {
  add_choice<Format>(app, "--format", kFormats, options.format,
                     "of the result: text or json; of the diagnostics alone: sarif, github or gcc");
  add_choice<ColorMode>(app, "--color",
                        {{"auto", ColorMode::automatic}, {"always", ColorMode::always}, {"never", ColorMode::never}},
                        options.color, "colour of the diagnostics");
  app.add_option("--data-dir", options.data_dir, "folder with schemas, templates and runtime");
  app.add_flag("-q,--quiet", options.quiet, "print no summary");
  app.add_flag("-v,--verbose", options.verbose, "say what is done");
  add_choice<bool>(app, "-W", {{"error", true}}, options.warnings_are_errors, "treat warnings as errors");
}

void add_generate(CLI::App& app, Options& options) {
  CLI::App* command = app.add_subcommand("generate", "write the firmware sources of a robot");
  add_input_options(*command, options);
  command->add_option("-o,--output", options.out, "folder to write to");
  command->add_option("--depfile", options.depfile, "write a Makefile rule with every input");
  add_sandbox(*command, options);
  command->add_flag("--list", options.list, "print the names of the files and write nothing");
  command->add_flag("--dry-run", options.dry_run, "say what would be written and write nothing");
  command->add_flag("--force", options.force, "keep files of yours that are in the way as NAME.orig, and write");
  command->add_flag("--allow-unschedulable", options.allow_unschedulable, "write even if a deadline can be missed");
}

void add_check(CLI::App& app, Options& options) {
  CLI::App* command = app.add_subcommand("check", "say whether generated files are what would be generated now");
  add_input_options(*command, options);
  command->add_option("-o,--output", options.out, "folder that was generated")->required();
  add_sandbox(*command, options);
  command->add_flag("--diff", options.diff, "print a unified diff of what would change");
  command->add_option("--allow", options.allow, "lint code that is not reported");
  command->add_option("--deny", options.deny, "lint code that makes the exit status 1");
}

void add_views(CLI::App& app, Options& options) {
  CLI::App* tree = app.add_subcommand("tree", "show the device trees and the order they run in");
  add_input_options(*tree, options);
  add_sandbox(*tree, options);
  CLI::App* board = app.add_subcommand("board", "show boards, and make their sources");
  board->require_subcommand(1);
  CLI::App* show = board->add_subcommand("show", "ports, pins, DMA streams and interrupt lines of a board");
  show->add_option("BOARD", options.input, "name of a board; without it: all boards");
  CLI::App* sources = board->add_subcommand("sources", "write what the runtime compiles for a board, from its file");
  sources->add_option("BOARD", options.input, "name of a board")->required();
  sources->add_option("-o,--output", options.out, "folder: runtime/boards/BOARD/generated")->required();
  sources->add_flag("--dry-run", options.dry_run, "write nothing; exit status 1 when a file would change");
}

void add_xacro(CLI::App& app, Options& options) {
  CLI::App* command = app.add_subcommand("xacro", "expand a xacro file, as ROS xacro does");
  command->add_option("FILE", options.input, "xacro file, or - for standard input")->required();
  command->footer(kArgumentsHelp);
  command->add_option("-o", options.out, "file to write instead of standard output");
  command->add_option("--package", options.packages, "name=dir: where a package lies");
  add_sandbox(*command, options);
  command->add_flag("--deps", options.deps, "print the names of all files read");
  command->add_flag("-i,--inorder", options.in_order, "accepted for compatibility: processing is always in order");
  command->add_option("--verbosity", options.verbosity, "0: no warnings, 1: default, 2 and above: more");
}

/// CLI11 wraps a number that 64 bits do not hold.
std::string check_seed(const std::string& word) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error == std::errc() && end == word.data() + word.size()) return {};
  return "'" + word + "': write a whole number from 0 to " + std::to_string(UINT64_MAX);
}

void add_timing(CLI::App& app, Options& options) {
  CLI::App* analyze = app.add_subcommand("analyze", "schedulability, response times, latency of every chain");
  CLI::App* simulate = app.add_subcommand("simulate", "run the schedule with random execution times beside its bounds");
  for (CLI::App* command : {analyze, simulate}) {
    add_input_options(*command, options);
    add_sandbox(*command, options);
    command->add_option("--chain", options.chains, "a->b: a chain beside the default ones");
    command->add_option("--profile", options.profile, "profile that decides the verdict")
        ->option_text("paper|tight|target");
    command->add_option("--assume-wcet", options.assume_wcet,
                        "time for every stage without a known one, for example 50us");
  }
  analyze->add_flag("--slack", options.slack, "the factor by which execution times may grow");
  analyze->add_flag("--suggest-order", options.suggest_order,
                    "suggest an order of siblings and trees with shorter bounds");
  simulate->add_option("--seed", options.seed, "of the random numbers")->check(check_seed, "");
  simulate->add_option("--duration", options.duration, "simulated time, for example 10s");
  simulate->add_option("-o", options.out, "write a trace for Perfetto to this file");
}

void add_reference(CLI::App& app, Options& options) {
  CLI::App* explain = app.add_subcommand("explain", "explain a diagnostic and how to fix it; without a code, list all");
  explain->add_option("CODE", options.input, "for example FM3012");
  CLI::App* schema = app.add_subcommand("schema", "print a schema for editors; without a name, list them");
  schema->add_option("NAME", options.input, "device, expander, board, scenario or xsd");
}

void add_docs(CLI::App& app, Options& options) {
  CLI::App* command = app.add_subcommand("docs", "write the reference pages of device types and board peripherals");
  command->add_option("-o,--output", options.out, "folder of the reference: devices/ and boards/ in it")->required();
  command->add_flag("--dry-run", options.dry_run, "write nothing; exit status 1 when a page would change");
}

/// What `--allow` and `--deny` take.
std::string rules_help() {
  std::string text = "Codes:\n";
  for (const Rule& rule : lint_rules_by_number()) text += fmt::format("  {}  {}\n", code_name(rule.code), rule.finding);
  return text;
}

void add_lint(CLI::App& app, Options& options) {
  CLI::App* command = app.add_subcommand("lint", "warn about valid but suspicious descriptions");
  add_input_options(*command, options);
  command->add_option("--allow", options.allow, "code that is not reported, for example FM3153");
  command->add_option("--deny", options.deny, "code that makes the exit status 1");
  command->footer(rules_help() + "\n" + kArgumentsHelp);
  add_sandbox(*command, options);
  command->add_flag("--fix", options.fix, "fix the mechanical findings in the files")->excludes("--sandbox");
}

void add_diff(CLI::App& app, Options& options) {
  CLI::App* command = app.add_subcommand("diff", "what changed between two robots, models or generated folders");
  command->add_option("A", options.input, "robot, model (.json) or generated folder")->required();
  command->add_option("B", options.other, "the other one")->required();
  add_load_options(*command, options);
  add_sandbox(*command, options);
}

void add_run(CLI::App& app, Options& options) {
  CLI::App* command = app.add_subcommand("run", "generate, compile, run and measure the firmware of a robot");
  add_input_options(*command, options);
  refuse_sandbox(*command);
  command->add_option("--duration", options.duration, "time to run on the board, for example 100ms");
  command->add_option("--chain", options.chains, "a->b: a chain beside the default ones");
  command->add_option("--scenario", options.scenario, "file with stimuli and faults (emulated Type C board)");
  command->add_option("-o", options.out, "write a trace for Perfetto to this file");
  add_choice<std::string>(*command, "--flash", {{"hit", "hit"}, {"miss", "miss"}}, options.flash,
                          "emulated board: fetches hit the flash accelerator, or miss it always");
  command->add_option("--keep", options.keep, "keep generated sources and build in this folder");
  command->add_flag("--monitor", options.monitor,
                    "build the monitor in: worst response and data age beside their bounds");
  command->add_flag("--build-only", options.build_only, "stop after the image is built");
  command->add_flag("--allow-unschedulable", options.allow_unschedulable,
                    "exit 0 after a good run even when analyze says that a deadline can be missed");
}

/// The whole definition; the values of a parse go to `options`.
void define_command_line(CLI::App& app, Options& options) {
  app.description("From a robot description to firmware with a proven bound on how old every command can be.");
  app.name("finemote");
  app.require_subcommand(1);
  app.fallthrough();
  app.set_version_flag("--version", version_text());
  add_global_options(app, options);
  add_generate(app, options);
  add_check(app, options);
  add_views(app, options);
  add_run(app, options);
  add_diff(app, options);
  add_lint(app, options);
  add_docs(app, options);
  add_reference(app, options);
  add_xacro(app, options);
  add_timing(app, options);
}

/// Of words that may hold mistakes: the last format that is one.
Format asked_format(const std::vector<std::string>& words) {
  Format format = Format::text;
  std::string before;
  for (const std::string& word : words) {
    constexpr std::string_view kOption = "--format";
    const bool is_joined = word.rfind(std::string(kOption) + "=", 0) == 0;
    const std::string value = is_joined ? word.substr(kOption.size() + 1) : before == kOption ? word : "";
    for (const auto& [name, known] : kFormats) {
      if (value == name) format = known;
    }
    before = word;
  }
  return format;
}

}  // namespace

CommandWords command_line_words() {
  Options options;
  CLI::App app;
  define_command_line(app, options);
  return words_of(app);
}

ParsedCommandLine parse_command_line(const std::vector<std::string>& words) {
  Options options;
  CLI::App app;
  define_command_line(app, options);
  const std::vector<std::string> ordered = command_first(app, take_arguments(words, options.arguments));
  try {
    app.parse(std::vector<std::string>(ordered.rbegin(), ordered.rend()));  // CLI11 takes the words last first
  } catch (const CLI::ParseError& error) {
    std::ostringstream out;
    std::ostringstream err;
    const bool asked = app.exit(error, out, err) == 0 && app.remaining(true).empty();
    if (asked) return {std::nullopt, kExitYes, out.str(), {}};
    const Diagnostics mistake = usage_error(app, ordered, error);
    return {std::nullopt, kExitInvalid, render_text(mistake, false), render_for_ci(asked_format(words), mistake, "")};
  }
  options.command = chosen_command(app);
  return {std::move(options), kExitYes, {}, {}};
}

}  // namespace finemote::gen
