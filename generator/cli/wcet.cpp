// finemote wcet: bounds of the execution times of a robot's image, computed from the image.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "generator/cli/answer.hpp"
#include "generator/cli/commands.hpp"
#include "generator/cli/progress.hpp"
#include "generator/cli/robot_input.hpp"
#include "generator/image/constants.hpp"
#include "generator/input/read_document.hpp"
#include "generator/run/compiled_files.hpp"
#include "generator/run/compiler.hpp"
#include "generator/run/image_owner.hpp"
#include "generator/run/library_gaps.hpp"
#include "generator/run/project.hpp"
#include "generator/run/wcet_explain.hpp"
#include "generator/run/wcet_scheduler.hpp"
#include "generator/run/work_folder.hpp"
#include "generator/tasks/bounds.hpp"
#include "generator/timing_file/user_code.hpp"

namespace finemote::gen {
namespace {

/// Reports boards whose chip the cost model does not know.
bool has_model(const Robot& robot, Diagnostics& diagnostics) {
  if (robot.board->is_emulated && robot.board->cpu_hz > 0) return true;
  diagnostics.error(code::usage, {}, fmt::format("no execution times are known of the board '{}'", robot.board->name))
      .note("bounds are computed for the STM32F405 and STM32F407")
      .hint("choose one of these boards: finemote board show");
  return false;
}

/// Makes the image of the generated sources. Of all that is compiled a timing file has to show when it changes, and all
/// has to be looked through for words that count.
std::optional<std::string> own_image(const Project& project, const Robot& robot, const TimingState& state,
                                     Sources& sources, Diagnostics& diagnostics) {
  auto path = make_image(project, sources, diagnostics);
  const auto compiled = path ? compiled_files(project.request, diagnostics) : std::nullopt;
  const bool is_known = compiled && are_known(*compiled, state.user_files, diagnostics) &&
                        are_known(*compiled, user_files(robot, sources.access()), diagnostics);
  return is_known ? path : std::nullopt;
}

void report_unknown_row(const std::string& asked, Diagnostics& diagnostics) {
  diagnostics.error(code::usage, {}, fmt::format("no stage or routine '{}' with a bound", asked))
      .hint("name it as the table does: 'imu.update', 'release', 'bucket 1 ms'");
}

Answer answer_of(const Options& options, const TimedRobot& timed, Diagnostics& diagnostics) {
  const int status = timed.times.gaps.empty() ? kExitYes : kExitNo;
  if (!options.explained.empty()) {
    const auto text = explain_longest_way(timed, options.explained);
    if (!text) report_unknown_row(options.explained, diagnostics);
    return text ? Answer{status, *text, wcet_document(timed)} : no_answer();
  }
  nlohmann::ordered_json document = wcet_document(timed);
  if (!options.out.empty() && !write_result(options.out, document_text(document), diagnostics)) return no_answer();
  return {status, wcet_text(timed), std::move(document)};
}

/// Beside the robot's description.
std::vector<std::string> files_read(const Robot& robot, const Options& options, const Sources& sources) {
  std::vector<std::string> files = user_files(robot, sources.access());
  if (!options.elf.empty()) files.push_back(options.elf);
  return files;
}

}  // namespace

Answer run_wcet(const Options& options, Sources& sources, Diagnostics& diagnostics) {
  auto input = input_of(options, diagnostics);
  if (input) input->without_timing_file = true;
  const auto planned = input ? plan_robot(*input, sources, diagnostics) : std::nullopt;
  if (!planned || !has_model(planned->robot, diagnostics)) return no_answer();
  if (!check_results({{options.out, "-o"}}, sources, diagnostics, files_read(planned->robot, options, sources)))
    return no_answer();
  const WorkFolder work({}, diagnostics);
  if (diagnostics.has_errors()) return no_answer();
  // Without bounds: they do not change what is computed here, and are computed from it.
  const timing::RobotBounds unknown = timing::robot_bounds(std::nullopt, planned->forest, planned->schedule);
  auto files = emit_files(*planned, {unknown, unknown}, input->data_dir, diagnostics);
  if (diagnostics.has_errors()) return no_answer();
  FirmwareRequest request = firmware_of(planned->robot, work.path(), input->data_dir);
  request.is_reproducible = true;
  WcetInputs inputs;
  inputs.clock_hz = planned->robot.board->cpu_hz;
  inputs.arguments = argument_words(*input);
  inputs.board = planned->board;
  TimingState state;
  if (options.elf.empty()) {
    state = timing_state_of(*planned, input->data_dir, sources.access());
    inputs.compiler = compiler_for_board();
    inputs.hash = state.hash;
  }
  const Project project =
      make_project(request, output_of(std::move(files), *planned, *input, sources), planned->robot, nullptr);
  Progress progress(options);
  if (options.elf.empty()) progress.say("compiling the firmware");
  const auto path = options.elf.empty() ? own_image(project, planned->robot, state, sources, diagnostics) : options.elf;
  const auto image = path ? read_image(*path, diagnostics) : std::nullopt;
  if (!image || (!options.elf.empty() &&
                 !is_image_of(planned->robot, planned->forest, planned->schedule, *image, *path, diagnostics)))
    return no_answer();
  const UserWords words = user_words(planned->robot, sources.access());
  const KeptMembers kept = kept_members(*path, {words.has_mutable, words.makes_in_place}, diagnostics);
  if (diagnostics.has_errors()) return no_answer();
  progress.say("bounding execution times");
  inputs.placement = wcet::placement_of(*image);
  wcet::ImageTimes times = wcet::time_image(*image, kept, inputs.placement);
  const SourceLines lines(*path);
  const SourceNames names(input->data_dir, input_folder(input->path));
  times.gaps = blame_callers_of_libraries(times.gaps, lines, names);
  const TimedRobot timed{planned->robot, planned->forest, planned->schedule, times, lines, names, std::move(inputs)};
  std::vector<wcet::TimeGap> found = times.gaps.empty() ? vanished_stages(timed) : std::vector<wcet::TimeGap>();
  std::vector<wcet::TimeGap> foreign = foreign_routines(timed);
  std::move(foreign.begin(), foreign.end(), std::back_inserter(found));
  std::move(found.begin(), found.end(), std::back_inserter(times.gaps));
  return answer_of(options, timed, diagnostics);
}

}  // namespace finemote::gen
