// The words of the command line to one value.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "generator/cli/command_words.hpp"

namespace finemote::gen {

enum class Format { text, json, sarif, github, gcc };
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
  ColorMode color = ColorMode::automatic;
  bool quiet = false;
  bool verbose = false;
  bool warnings_are_errors = false;
  bool sandbox = false;  ///< --sandbox: read only what the user named, and not without end

  std::string out;  ///< -o
  std::string depfile;
  bool list = false;
  bool dry_run = false;
  bool force = false;  ///< generate --force
  bool allow_unschedulable = false;
  bool diff = false;
  std::string duration;             ///< --duration
  std::string flash = "hit";        ///< --flash: what fetches from the emulated flash cost, hit or miss
  std::string keep;                 ///< --keep: folder for the sources and build of `run`
  std::string scenario;             ///< --scenario: stimuli and faults for `run`
  bool deps = false;                ///< xacro --deps
  bool in_order = false;            ///< xacro --inorder
  int verbosity = 1;                ///< xacro --verbosity
  std::vector<std::string> chains;  ///< --chain a->b
  std::string profile;              ///< --profile
  std::string assume_wcet;          ///< --assume-wcet
  bool slack = false;
  bool fix = false;                      ///< lint --fix
  std::vector<std::string> allow, deny;  ///< lint --allow, --deny
  bool suggest_order = false;
  std::uint64_t seed = 1;   ///< simulate --seed
  bool monitor = false;     ///< --monitor: the firmware holds itself to its bounds
  bool build_only = false;  ///< --build-only: stop after the image
};

/// What the words ask for: a command to run, or a text to print and stop (help, version, or a usage error).
struct ParsedCommandLine {
  std::optional<Options> options;
  int exit_status = 0;
  std::string text;      ///< for stdout when the status is 0, else for stderr
  std::string findings;  ///< for stdout when it is not: the same in the format that was asked for, sarif, github or gcc
};

/// Options may stand before or after the command, `name:=value` anywhere. Words that mean nothing are a usage error
/// (FM0001) even beside --help and --version.
ParsedCommandLine parse_command_line(const std::vector<std::string>& words);

/// Every command and option there is, for the test of the page that describes them.
CommandWords command_line_words();

}  // namespace finemote::gen
