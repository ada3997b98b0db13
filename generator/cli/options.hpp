// Everything a user can say on the command line, as one value.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace finemote::gen {

/// A stage of the pipeline that --dump shows.
enum class DumpStage { document, model, forest, schedule, tasks, plan };
inline constexpr const char* kStageNames[] = {"document", "model", "forest", "schedule", "tasks", "plan"};

enum class Format { text, json, sarif, github, gcc, markdown };
inline constexpr const char* kFormatWords[] = {"text", "json", "sarif", "github", "gcc", "md"};  ///< in the same order
enum class GraphFormat { svg, dot, mermaid };
inline constexpr const char* kGraphFormatWords[] = {"svg", "dot", "mermaid"};  ///< in the same order
inline constexpr const char* kShellWords[] = {"bash", "zsh", "fish"};          ///< that `completion` knows
enum class ColorMode { automatic, always, never };

/// Everything the user can say. One flat value: each command reads what concerns it.
struct Options {
  std::string command;
  std::string input;                                           ///< IN, or the first of two
  std::string other;                                           ///< the second of two
  std::vector<std::pair<std::string, std::string>> arguments;  ///< name:=value, for xacro
  std::vector<std::string> packages;                           ///< name=dir
  std::vector<std::string> device_paths;
  std::string data_dir;  ///< --data-dir; empty: found
  std::string board;     ///< --board
  Format format = Format::text;
  GraphFormat graph_format = GraphFormat::svg;  ///< graph --format
  ColorMode color = ColorMode::automatic;
  bool quiet = false;
  bool verbose = false;
  bool warnings_are_errors = false;
  std::optional<DumpStage> dump;  ///< --dump: show this stage instead
  bool sandbox = false;           ///< --sandbox: read only what the user named, and not without end

  std::string out;           ///< -o
  bool show_config = false;  ///< --show-config: print what is set, by whom, and do nothing else
  bool watch = false;        ///< --watch: answer again whenever something changed
  std::string run_file;      ///< report --run
  std::string against;       ///< report --against
  std::string depfile;
  bool list = false;
  bool dry_run = false;
  bool force = false;  ///< generate --force
  bool allow_unschedulable = false;
  bool diff = false;
  std::string from;                 ///< init --from
  std::string robot;                ///< bench-kit --robot
  std::string read;                 ///< bench-kit --read
  std::string elf;                  ///< wcet --elf
  std::string explained;            ///< wcet --explain
  std::string example;              ///< init --example
  std::string duration;             ///< --duration
  bool flash_misses = false;        ///< --flash miss: fetches from the emulated flash are never there already
  bool slowest = false;             ///< --slowest: --flash miss and --silicon strict
  std::string silicon;              ///< --silicon: which freedom of its manual the emulated chip uses
  std::string keep;                 ///< --keep: folder for the sources and build of `run`
  std::string scenario;             ///< --scenario: stimuli and faults for `run`
  bool deps = false;                ///< xacro --deps
  bool in_order = false;            ///< xacro --inorder
  int verbosity = 1;                ///< xacro --verbosity
  std::vector<std::string> chains;  ///< --chain a->b
  std::string profile;              ///< --profile
  std::string assume_wcet;          ///< --assume-wcet
  std::string crossover;            ///< --crossover
  bool slack = false;
  bool require_static = false;
  bool fix = false;                      ///< lint --fix
  std::vector<std::string> allow, deny;  ///< lint --allow, --deny
  bool suggest_order = false;
  std::uint64_t seed = 1;       ///< simulate --seed, run --seed
  std::string audit;            ///< --audit: file for the raw record of `run`
  std::uint64_t phases = 0;     ///< --phases: the number of runs with random phases and clock errors; 0: one without
  bool monitor = false;         ///< --monitor: the firmware holds itself to its bounds
  bool trace = false;           ///< --trace: the firmware records every start and end of a stage
  bool require_judged = false;  ///< --require-judged: every bound has to be held against a sample
  bool sizes = false;           ///< diff --sizes: compile both robots
  bool build_only = false;      ///< --build-only: stop after the image
  std::string json;             ///< run --json: file for the document, whatever is printed
};

}  // namespace finemote::gen
