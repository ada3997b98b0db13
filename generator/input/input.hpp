// What a user asks about: the description of a robot, and where all it names is found.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace finemote::gen {

struct Input {
  std::string path;                                            ///< `.urdf` or `.xacro`; `-`: URDF on standard input
  const std::string* text = nullptr;                           ///< instead of what is in the file; null: the file's
  std::vector<std::pair<std::string, std::string>> arguments;  ///< `name:=value` as written, for xacro
  std::vector<std::string> packages;                           ///< `name=dir`: where a ROS package lies
  std::vector<std::string> device_paths;                       ///< further folders with device descriptors
  std::string data_dir;                                        ///< holds schemas/ and templates/
  std::string board;                                           ///< instead of the one the robot names; empty: that one
  std::string code;                  ///< where it runs, instead of the board's param; empty: there
  bool without_timing_file = false;  ///< as if there were none beside it
  std::ostream* messages = nullptr;  ///< where xacro.message() writes; null: nowhere
};

/// `.xacro`: the text is expanded before it is read.
bool is_xacro(const std::string& path);

/// `.json`: the tasks as the timing analysis takes them, in place of a robot.
bool is_timing_model(const std::string& path);

/// A word `name=dir` in two; none where it has another form.
std::optional<std::pair<std::string, std::string>> package_of(const std::string& word);

/// How outputs call the input: its file's name, `stdin` for standard input.
std::string input_name(const std::string& path);

/// The folder of the input; of standard input the working directory.
std::string input_folder(const std::string& path);

}  // namespace finemote::gen
