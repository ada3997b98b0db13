#include "generator/cli/robot_input.hpp"

#include <iostream>

#include "generator/cli/data_dir.hpp"
#include "generator/input/read_document.hpp"
#include "generator/output/input_files.hpp"

namespace finemote::gen {
namespace {

/// What changes the files beside the inputs, as on the command line: `--board NAME`, then `name:=value`, sorted.
std::vector<std::string> output_options(const Input& input, const std::string& board) {
  std::vector<std::string> words = argument_words(input);
  if (!board.empty()) words.insert(words.begin(), "--board " + board);
  return words;
}

}  // namespace

std::optional<Input> input_of(const Options& options, Diagnostics& diagnostics) {
  Input input;
  input.path = options.input;
  input.arguments = options.arguments;
  input.packages = options.packages;
  input.device_paths = options.device_paths;
  input.data_dir = find_data_dir(options.data_dir, diagnostics);
  input.board = options.board;
  input.messages = &std::cerr;
  if (input.data_dir.empty()) return std::nullopt;
  return input;
}

Output output_of(std::vector<OutputFile> files, const PlannedRobot& planned, const Input& input,
                 const Sources& sources) {
  auto inputs = input_files(sources, input_folder(input.path), input.data_dir);
  return make_output(std::move(files), std::move(inputs), planned.robot.name.text,
                     output_options(input, planned.board));
}

}  // namespace finemote::gen
