#include "generator/cli/commands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <stdexcept>
#include <string>

#include "generator/diagnostic/catalogue.hpp"
#include "generator/diagnostic/render.hpp"
#include "generator/lint/rules.hpp"

namespace finemote::gen {
namespace {

using OptionList = std::vector<Option>;
constexpr auto kRequired = Option::Need::required;
constexpr auto kOptional = Option::Need::optional;
constexpr const char* kBoards = "board show";  ///< lists them

/// Concatenates pieces of the table.
OptionList join(std::initializer_list<OptionList> pieces) {
  OptionList all;
  for (const OptionList& piece : pieces) all.insert(all.end(), piece.begin(), piece.end());
  return all;
}

/// Where what a robot names is found.
OptionList search() {
  return {{"--board", &Options::board, "use this board instead of the one the robot names", kOptional, nullptr, nullptr,
           kBoards},
          {"--device-path", &Options::device_paths, "further folder with device descriptors"},
          {"--package", &Options::packages, "name=dir: where a package lies"}};
}

OptionList robot() {
  return join(
      {{{"IN", &Options::input, "robot description: .urdf, .xacro, or - for standard input", kRequired},
        {"--show-config", &Options::show_config, "print what finemote.json and the options set, and do nothing else"}},
       search()});
}

/// For commands that read a stranger's file and start nothing.
OptionList sandbox() {
  return {{"--sandbox", &Options::sandbox,
           "read only below the folder of IN, packages named with --package, and shipped data"}};
}

/// For commands that compile or run what the file describes: whoever asks for a sandbox must not believe in one.
OptionList no_sandbox() {
  return {{"--sandbox", Refusal{"it compiles the robot's own code, which no sandbox holds"},
           "refused: this command compiles the robot's own code"}};
}

OptionList watch() {
  return {{"--watch", &Options::watch, "answer again whenever a file changes that matters, until Ctrl-C", kOptional,
           nullptr, "--sandbox"}};
}

OptionList dump() {
  const std::vector<std::string> stages(std::begin(kStageNames), std::end(kStageNames));
  return {{"--dump", Choice{stages, [](Options& o, std::size_t word) { o.dump = static_cast<DumpStage>(word); }},
           "print this stage of the pipeline as JSON, and do nothing else"}};
}

OptionList chains() { return {{"--chain", &Options::chains, "a->b: a chain beside the default ones"}}; }

/// What `analyze` and `simulate` ask of the analysis.
OptionList question() {
  return join(
      {chains(),
       {{"--profile", &Options::profile, "profile that decides the verdict", kOptional, "paper|tight|target"},
        {"--assume-wcet", &Options::assume_wcet, "time for every stage without a known one, for example 50us"}}});
}

std::string arguments_footer() {
  return "name:=value, any number and anywhere: the value of a <xacro:arg> (of a file that is read as xacro)";
}

/// What `--allow` and `--deny` take.
std::string rules_footer() {
  std::string text = "Codes:\n";
  for (const Rule& rule : lint_rules_by_number()) text += fmt::format("  {}  {}\n", code_name(rule.code), rule.finding);
  return text + "\n" + arguments_footer();
}

OptionList options_of_generate() {
  return join({robot(),
               {{"-o,--output", &Options::out, "folder to write to"},
                {"--depfile", &Options::depfile, "write a Makefile rule with every input"}},
               sandbox(),
               {{"--list", &Options::list, "print the names of the files and write nothing"},
                {"--dry-run", &Options::dry_run, "say what would be written and write nothing"},
                {"--force", &Options::force, "keep files of yours that are in the way as NAME.orig, and write"},
                {"--allow-unschedulable", &Options::allow_unschedulable, "write even if a deadline can be missed"}},
               dump()});
}

OptionList options_of_check() {
  return join({robot(),
               {{"-o,--output", &Options::out, "folder that was generated; required"}},
               sandbox(),
               {{"--diff", &Options::diff, "print a unified diff of what would change"},
                {"--allow", &Options::allow, "lint code that is not reported"},
                {"--deny", &Options::deny, "lint code that makes the exit status 1"}},
               watch(),
               dump()});
}

OptionList options_of_init() {
  return {{"DIR", &Options::input, "folder of the project; created if missing", kRequired},
          {"--board", &Options::board, "board of the robot that is written", kOptional, nullptr, nullptr, kBoards},
          {"--from", &Options::from, "a robot of yours, which is copied with what it reads"},
          {"--example", &Options::example, "a robot of the examples, by name", kOptional, nullptr, "--from"}};
}

OptionList options_of_scaffold() {
  return {{"NAME", &Options::input, "name of the new type or board", kRequired},
          {"-o,--output", &Options::out, "folder; without it src of a project that init wrote, else this one"}};
}

OptionList options_of_board_sources() {
  return {{"BOARD", &Options::input, "name of a board", kRequired, nullptr, nullptr, kBoards},
          {"-o,--output", &Options::out, "folder: runtime/boards/BOARD/generated", kRequired},
          {"--dry-run", &Options::dry_run, "write nothing; exit status 1 when a file would change"}};
}

OptionList options_of_run() {
  return join(
      {robot(),
       no_sandbox(),
       {{"--duration", &Options::duration, "time to run on the board, for example 100ms"}},
       chains(),
       {{"--scenario", &Options::scenario, "file with stimuli and faults (emulated board)"},
        {"-o", &Options::out, "write a trace for Perfetto to this file"},
        {"--flash", Choice{{"hit", "miss"}, [](Options& o, std::size_t word) { o.flash_misses = word == 1; }},
         "emulated board: fetches hit the flash accelerator, or miss it always"},
        {"--silicon", &Options::silicon,
         "emulated board: strict, or strict:NAME,.. for a chip that uses the freedom its manual leaves"},
        {"--slowest", &Options::slowest, "emulated board: its slowest mode, --flash miss and --silicon strict"},
        {"--audit", &Options::audit, "write the raw record of the run to this file, as JSON Lines"},
        {"--phases", &Options::phases, "run so often, with random phases and clock errors of parts and board"},
        {"--seed", &Options::seed, "of the random phases and of the silicon"},
        {"--json", &Options::json, "also write what --format json prints to this file"},
        {"--keep", &Options::keep, "keep generated sources and build in this folder"},
        {"--trace", &Options::trace, "build the trace in, and count its cost in the bounds"},
        {"--monitor", &Options::monitor, "build the monitor in: worst response and data age beside their bounds"},
        {"--require-judged", &Options::require_judged, "exit status 1 where some bound was not judged"},
        {"--build-only", &Options::build_only, "stop after the image is built"},
        {"--allow-unschedulable", &Options::allow_unschedulable,
         "exit 0 after a good run even when analyze says that a deadline can be missed"}},
       dump()});
}

OptionList options_of_wcet() {
  return join({robot(),
               no_sandbox(),
               {{"-o,--output", &Options::out, "write the bounds to this file, as finemote.wcet/1"},
                {"--elf", &Options::elf, "an image of this robot that was linked elsewhere"},
                {"--explain", &Options::explained,
                 "the longest way through a stage or a routine of the table, for example imu.update"}}});
}

OptionList options_of_bench_kit() {
  return join(
      {{{"-o,--output", &Options::out, "folder of the kit: sources, drawing, and the image where it can be built"},
        {"--read", &Options::read, "a record that the image printed, to be judged", kOptional, nullptr, "--output"},
        {"--robot", &Options::robot, "a robot whose stages are measured; without it: the board's own parts"}},
       search(),
       no_sandbox()});
}

/// @param words  the formats there are, of kFormatWords
Option format(std::size_t words, const char* help) {
  return {"--format",
          Choice{{kFormatWords, kFormatWords + words},
                 [](Options& o, std::size_t word) { o.format = static_cast<Format>(word); }},
          help};
}

OptionList options_of_diff() {
  return join({{{"A", &Options::input, "robot, model (.json) or generated folder", kRequired},
                {"B", &Options::other, "the other one", kRequired},
                format(std::size(kFormatWords), "as for all commands; md: for a comment on a code host")},
               search(),
               sandbox(),
               {{"--sizes", &Options::sizes, "compile both robots, and compare flash, RAM and proven stack", kOptional,
                 nullptr, "--sandbox"}}});
}

OptionList options_of_graph() {
  return join({robot(),
               sandbox(),
               {{"--format",
                 Choice{{std::begin(kGraphFormatWords), std::end(kGraphFormatWords)},
                        [](Options& o, std::size_t word) { o.graph_format = static_cast<GraphFormat>(word); }},
                 "a picture, or a text for Graphviz or Mermaid"}}});
}

OptionList options_of_report() {
  return join({robot(),
               sandbox(),
               question(),
               {{"-o,--output", &Options::out, "the page to write", kRequired},
                {"--run", &Options::run_file, "what 'run --format json' printed: adds measured values and sizes"},
                {"--against", &Options::against,
                 "a robot, or what 'analyze --format json' printed of one: adds what changed since"}},
               watch()});
}

OptionList options_of_lint() {
  return join(
      {robot(),
       {{"--allow", &Options::allow, "code that is not reported, for example FM3153"},
        {"--deny", &Options::deny, "code that makes the exit status 1"}},
       sandbox(),
       {{"--fix", &Options::fix, "fix the mechanical findings in the files", kOptional, nullptr, "--sandbox"}}});
}

OptionList options_of_import() {
  return join({{{"IN", &Options::input, "robot with <ros2_control> elements: .urdf, .xacro, or -", kRequired},
                {"-o,--output", &Options::out, "write the whole robot to this file, with the element in it"},
                {"--package", &Options::packages, "name=dir: where a package lies"}},
               sandbox()});
}

OptionList options_of_fmt() {
  return {
      {"FILE", &Options::input, "file with <finemote> elements; of - (standard input) the text is printed", kRequired},
      {"--dry-run", &Options::dry_run,
       "write nothing, print a unified diff; exit status 1 where the file would change"}};
}

OptionList options_of_docs() {
  return {{"-o,--output", &Options::out, "folder of the reference: devices/ and boards/ in it", kRequired},
          {"--dry-run", &Options::dry_run, "write nothing; exit status 1 when a page would change"}};
}

OptionList options_of_xacro() {
  return join({{{"FILE", &Options::input, "xacro file, or - for standard input", kRequired},
                {"-o", &Options::out, "file to write instead of standard output"},
                {"--package", &Options::packages, "name=dir: where a package lies"}},
               sandbox(),
               {{"--deps", &Options::deps, "print the names of all files read"},
                {"-i,--inorder", &Options::in_order, "accepted for compatibility: processing is always in order"},
                {"--verbosity", &Options::verbosity, "0: no warnings; 1 and above: warnings, the default"}}});
}

OptionList options_of_analyze() {
  return join(
      {robot(),
       sandbox(),
       question(),
       {{"--crossover", &Options::crossover,
         "frequency of a loop, for example 2Hz: degrees by which each chain lags there"},
        {"--slack", &Options::slack, "the factor by which execution times may grow"},
        {"--require-static", &Options::require_static, "exit with status 1 unless every execution time is computed"},
        {"--suggest-order", &Options::suggest_order, "suggest an order of siblings and trees with shorter bounds"},
        {"--trace", &Options::trace, "of the firmware with the trace built in"},
        {"--monitor", &Options::monitor, "of the firmware with the monitor built in"}},
       watch(),
       dump()});
}

OptionList options_of_simulate() {
  return join({robot(),
               sandbox(),
               question(),
               {{"--seed", &Options::seed, "of the random numbers"},
                {"--duration", &Options::duration, "simulated time, for example 10s"},
                {"-o", &Options::out, "write a trace for Perfetto to this file"}},
               dump()});
}

OptionList options_of_completion() {
  return {{"SHELL",
           Choice{{std::begin(kShellWords), std::end(kShellWords)},
                  [](Options& o, std::size_t word) { o.input = kShellWords[word]; }},
           "whose completion", kRequired}};
}

/// Of projects and their descriptions.
std::vector<Command> commands_of_projects() {
  return {
      {"init", "write a project around a robot, which builds at once", options_of_init(), run_init},
      {"import", "make a <finemote> element to start from of <ros2_control> elements", options_of_import(), run_import,
       arguments_footer},
      {"scaffold device", "write the first lines of a device type: descriptor, header, test", options_of_scaffold(),
       run_scaffold_device},
      {"scaffold board", "write the first lines of a board file", options_of_scaffold(), run_scaffold_board},
      {"generate", "write the firmware sources of a robot", options_of_generate(), run_generate, arguments_footer},
      {"check", "say whether generated files are what would be generated now", options_of_check(), run_check,
       arguments_footer},
      {"diff", "what changed between two robots, models or generated folders", options_of_diff(), run_diff},
      {"lint", "warn about valid but suspicious descriptions", options_of_lint(), run_lint, rules_footer},
      {"fmt", "bring the <finemote> elements of a file into their canonical layout", options_of_fmt(), run_fmt},
      {"xacro", "expand a xacro file, as ROS xacro does", options_of_xacro(), run_xacro, arguments_footer},
  };
}

/// Of how a robot behaves.
std::vector<Command> commands_of_analyses() {
  return {
      {"tree", "show the device trees and the order they run in", join({robot(), sandbox()}), run_tree,
       arguments_footer},
      {"graph", "draw the device trees with buses, types and periods", options_of_graph(), run_graph, arguments_footer},
      {"analyze", "schedulability, response times, latency of chains", options_of_analyze(), run_analyze,
       arguments_footer},
      {"simulate", "run the schedule with random execution times beside its bounds", options_of_simulate(),
       run_simulate, arguments_footer},
      {"report", "write what is known of a robot as one page to look at", options_of_report(), run_report,
       arguments_footer},
      {"run", "generate, compile, run and measure the firmware of a robot", options_of_run(), run_run,
       arguments_footer},
      {"wcet", "bound execution times from the linked image", options_of_wcet(), run_wcet, arguments_footer},
      {"bench-kit", "write a self-test for a bare board, or judge what it printed", options_of_bench_kit(),
       run_bench_kit, arguments_footer},
  };
}

/// Of what is shipped, and of the tool itself.
std::vector<Command> commands_of_tool() {
  return {
      {"explain",
       "explain a diagnostic and how to fix it; without a code, list all",
       {{"CODE", &Options::input, "for example FM3012", kOptional, nullptr, nullptr, "explain"}},
       run_explain},
      {"board show",
       "ports, pins, DMA streams and interrupt lines of a board",
       {{"BOARD", &Options::input, "name of a board; without it: all boards", kOptional, nullptr, nullptr, kBoards}},
       run_board_show},
      {"board sources", "write what the runtime compiles for a board, from its file", options_of_board_sources(),
       run_board_sources},
      {"schema",
       "print a schema for editors; without a name, list them",
       {{"NAME", &Options::input, "device, expander, board, scenario, settings or xsd", kOptional, nullptr, nullptr,
         "schema"}},
       run_schema},
      {"docs", "write the reference pages of device types and board peripherals", options_of_docs(), run_docs},
      {"completion", "print what completes the words of a command line", options_of_completion(), run_completion},
      {"man", "print the manual page", {}, run_man},
  };
}

std::vector<Command> make_commands() {
  std::vector<Command> all;
  for (const auto& group : {commands_of_projects(), commands_of_analyses(), commands_of_tool()})
    all.insert(all.end(), group.begin(), group.end());
  return all;
}

OptionList make_common_options() {
  return {
      format(std::size(kFormatWords) - 1,  // without md
             "of the result: text or json; of the diagnostics alone: sarif, github or gcc"),
      {"--color",
       Choice{{"auto", "always", "never"},
              [](Options& o, std::size_t word) { o.color = static_cast<ColorMode>(word); }},
       "colour of the diagnostics"},
      {"--data-dir", &Options::data_dir, "folder with schemas, templates and runtime"},
      {"-q,--quiet", &Options::quiet, "print no summary"},
      {"-v,--verbose", &Options::verbose, "say what is done"},
      {"-W", Choice{{"error"}, [](Options& o, std::size_t) { o.warnings_are_errors = true; }},
       "treat warnings as errors"},
  };
}

}  // namespace

const std::vector<Command>& commands() {
  static const std::vector<Command> kCommands = make_commands();
  return kCommands;
}

bool has_option(const Command& command, std::string_view name) {
  return std::any_of(command.options.begin(), command.options.end(),
                     [&](const Option& option) { return option.names == name; });
}

const Command& command_named(std::string_view name) {
  const auto found =
      std::find_if(commands().begin(), commands().end(), [&](const Command& command) { return command.name == name; });
  if (found == commands().end()) throw std::logic_error("no command " + std::string(name));
  return *found;
}

const char* group_summary(std::string_view word) {
  if (word == "scaffold") return "write the first lines of a device type or a board";
  if (word == "board") return "show boards, and make their sources";
  throw std::logic_error("no commands below " + std::string(word));
}

const std::vector<Option>& common_options() {
  static const std::vector<Option> kOptions = make_common_options();
  return kOptions;
}

}  // namespace finemote::gen
