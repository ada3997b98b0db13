// IN to a planned robot: runs the pipeline up to the schedule.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/cli/context.hpp"
#include "generator/descriptor/library.hpp"
#include "generator/emit/render.hpp"
#include "generator/output/manifest.hpp"
#include "generator/xacro/expand.hpp"

namespace finemote::gen {

/// A robot with everything that was made from it. `robot` points into `library`, which must live as long.
struct Loaded {
  std::string data_dir;
  Library library;
  Robot robot;
  Forest forest;
  Schedule schedule;

  [[nodiscard]] Plan plan() const { return {robot, forest, schedule}; }
};

/// Reads, checks and plans. All mistakes are in the context's diagnostics; with one there is no robot.
/// @param edited  the text of IN instead of what is in the file; null: the file
std::optional<Loaded> load_robot(Context& context, const std::string* edited = nullptr);

/// The generated files of a robot, bounds included. Reports what render_files reports.
std::vector<OutputFile> render_robot(Context& context, const Loaded& loaded);

/// Name and folder of every `--package name=dir`; reports FM0001 for words of another form.
std::vector<std::pair<std::string, std::string>> package_folders(Context& context);

/// `name:=value` words as xacro takes them.
xacro::Arguments xacro_arguments(const Options& options);

/// Every file that was read, named for the manifest (relative to the folder of IN, `package://` outside it,
/// `builtin:` for shipped data) and hashed; sorted by name.
std::vector<HashedFile> input_files(const Context& context, const Loaded& loaded);

/// The words of the command line that change what is generated beside the inputs: `--board NAME`, `name:=value`;
/// sorted.
std::vector<std::string> output_options(const Options& options);

}  // namespace finemote::gen
