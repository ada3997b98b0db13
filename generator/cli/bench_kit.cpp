// finemote bench-kit: a self-test for a bare board, and what its record says.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "generator/bench_kit/bench_ports.hpp"
#include "generator/bench_kit/board_tests.hpp"
#include "generator/bench_kit/jumpers.hpp"
#include "generator/bench_kit/plan.hpp"
#include "generator/bench_kit/record.hpp"
#include "generator/bench_kit/robot_tests.hpp"
#include "generator/bus/bus_type.hpp"
#include "generator/cli/answer.hpp"
#include "generator/cli/commands.hpp"
#include "generator/cli/robot_input.hpp"
#include "generator/cli/settings.hpp"
#include "generator/diagnostic/code_scenario.hpp"
#include "generator/run/build_firmware.hpp"
#include "generator/run/check_wcet.hpp"
#include "generator/run/project.hpp"
#include "generator/scaffold/fill_folder.hpp"
#include "generator/tasks/from_robot.hpp"
#include "generator/tasks/robot_costs.hpp"

namespace finemote::gen {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

constexpr const char *kBoard = "robomaster_type_c", *kKitRobot = "/templates/bench_kit/robot.urdf";

/// The robot of --robot, or the board's own.
std::optional<Input> robot_of(const Options& options, Sources& sources, Diagnostics& diagnostics) {
  Options of_robot = options;
  of_robot.input = options.robot;
  if (!options.robot.empty()) return input_of(settings_of(of_robot, sources, diagnostics).options, diagnostics);
  auto input = input_of(of_robot, diagnostics);
  if (input) input->path = input->data_dir + kKitRobot;
  return input;
}

/// The kit measures the flash, too, so that its code runs from there: bounds of an image in SRAM say nothing of it.
std::optional<PlannedRobot> plan_for_bench(Input input, Sources& sources, Diagnostics& diagnostics) {
  input.code = "flash";
  input.without_timing_file = true;
  auto planned = plan_robot(input, sources, diagnostics);
  if (!planned || planned->robot.board->name == kBoard) return planned;
  diagnostics
      .error(code::usage, {},
             fmt::format("there is no bench kit for the board '{}' of the robot", planned->robot.board->name))
      .hint(fmt::format("it is written for '{}'", kBoard));
  return std::nullopt;
}

Ground ground_of(Wcet::Source source) {
  switch (source) {
    case Wcet::Source::static_analysis:
    case Wcet::Source::budget:
    case Wcet::Source::computed:
      return Ground::declared;
    case Wcet::Source::measured:
      return Ground::measured;
    case Wcet::Source::assumed:
      break;
  }
  return Ground::assumed;
}

/// Of the release interrupt as the analysis has it, less what only those feel whom it interrupts.
Duration release_limit(const PlannedRobot& planned, const timing::Model& model) {
  const auto buckets = static_cast<std::int64_t>(planned.schedule.buckets.size());
  return model.costs.release - timing::board_costs(planned.robot).preemption + buckets * model.costs.release_per_bucket;
}

std::vector<StageLimits> stage_limits(const PlannedRobot& planned, const timing::Model& model) {
  const auto wcets = analysed_wcets(planned.robot, planned.forest, model);
  std::vector<StageLimits> limits;
  for (const Rank rank : planned.forest.order.ids()) {
    const DeviceId device = planned.forest.order[rank];
    limits.push_back({planned.robot.devices[device].name.text, wcets[device].update, wcets[device].handle,
                      ground_of(wcets[device].source)});
  }
  return limits;
}

/// A line that only hears: without anybody who sends there is nothing to measure.
std::string needs_of(const Bus& bus) {
  return bus_type(bus.kind).port_class == PortClass::uart ? "traffic at " + bus.port : std::string();
}

/// Adds what is charged for one run of a routine of the bus, and its lines; nothing where it has no interrupts.
void add_bus(const Robot& robot, const Bus& bus, const timing::Bus& charged, std::vector<RoutineLimit>& limits,
             std::vector<BusLine>& lines) {
  const Port* port = robot.board->port(bus.port);
  const Driver* driver = robot.board->driver(bus.kind);
  if (port == nullptr || driver == nullptr || !charged.sources || charged.sources->empty()) return;
  Duration most;
  for (const timing::InterruptSource& source : *charged.sources) most = std::max(most, source.wcet);
  for (const InterruptLine& line : port->interrupts) lines.push_back({line.number, limits.size()});
  limits.push_back({bus.name.text, most, driver->is_assumed ? Ground::assumed : Ground::measured, needs_of(bus)});
}

/// Tests of the board, then of the robot. Reports what is wrong with the robot where its times cannot be added up.
std::optional<BenchPlan> plan_of(const PlannedRobot& planned, Diagnostics& diagnostics) {
  Diagnostics findings;
  const auto model = timing::make_timing_model(planned.robot, planned.forest, planned.schedule, findings);
  if (!model) {
    add_findings(findings, diagnostics);
    return std::nullopt;
  }
  const Robot& robot = planned.robot;
  const std::vector<StageLimits> stages = stage_limits(planned, *model);
  // Buckets take the lines of the board in their order.
  BenchPlan plan{*robot.board, robot.name.text, board_tests(*robot.board), robot.board->lines.back().number,
                 2 * stages.size()};
  std::vector<RoutineLimit> routines;
  for (const timing::Bus& charged : model->buses) {
    const auto bus = std::find_if(robot.buses.begin(), robot.buses.end(),
                                  [&](const Bus& it) { return it.name.text == charged.name; });
    if (bus != robot.buses.end()) add_bus(robot, *bus, charged, routines, plan.bus_lines);
  }
  plan.buses = routines.size();
  for (BenchTest& test : robot_tests(stages, routines, release_limit(planned, *model)))
    plan.tests.push_back(std::move(test));
  return plan;
}

/// Every file of a folder of the data, as one below `folder` of the kit.
void add_copies(std::vector<OutputFile>& files, const std::string& from, const std::string& folder) {
  for (OutputFile& file : fill_folder(from, {})) files.push_back({folder + file.name, std::move(file.text)});
}

/// What the folder of the kit holds beside the generated sources of the robot.
std::vector<OutputFile> files_of_kit(const Options& options, const BenchPlan& plan, const FirmwareRequest& request) {
  const Keys keys{{"data_dir", fs::absolute(request.data_dir).lexically_normal().generic_string()},
                  {"board", request.board},
                  {"robot", plan.robot},
                  {"report", plan.board.port(bench_ports::kReport)->connector},
                  {"robot_option", options.robot.empty() ? "" : " --robot " + options.robot},
                  {"include_dirs", cmake_words(request.include_dirs)},
                  {"sources", cmake_words(request.sources)}};
  std::vector<OutputFile> files = fill_folder(request.data_dir + "/templates/bench_kit/project", keys);
  add_copies(files, request.data_dir + "/templates/project/openocd", "openocd/");
  add_copies(files, request.data_dir + "/runtime/bench_kit", "src/");
  const std::vector<Jumper> jumpers = bench_jumpers(plan.board);
  files.push_back({"jumpers.svg", jumper_drawing(jumpers)});
  files.push_back({"jumpers.json", jumper_scenario(jumpers).dump(2) + "\n"});
  files.push_back({"src/bench_plan.hpp", bench_plan_header(plan)});
  std::sort(files.begin(), files.end(), [](const OutputFile& a, const OutputFile& b) { return a.name < b.name; });
  return files;
}

Answer answer_of_kit(const std::string& folder, const std::optional<std::string>& image) {
  Answer answer{kExitYes};
  if (image) {
    answer.text = fmt::format(
        "{0}\n\nFlash it, for example:\n"
        "  openocd -f {1}/openocd/stlink.cfg -c \"program {0} verify reset exit\"\n"
        "  pyocd flash --target stm32f407ighx {0}\n"
        "then read its record as {1}/README.md says: finemote bench-kit --read FILE\n",
        *image, folder);
  } else {
    answer.text = fmt::format("{0}\n\nThere is no compiler for the board here: see {0}/README.md\n", folder);
  }
  answer.document = {{"schema", "finemote.bench-kit/1"}, {"output", folder}, {"image", image ? Json(*image) : Json()}};
  return answer;
}

Answer write_kit(const Options& options, Sources& sources, Diagnostics& diagnostics) {
  const auto input = robot_of(options, sources, diagnostics);
  if (!input || diagnostics.has_errors()) return no_answer();
  const auto planned = plan_for_bench(*input, sources, diagnostics);
  if (!planned) return no_answer();
  const Analysis analysis = analyse_robot(*planned, Hints::left_out);
  auto generated = emit_files(*planned, prove_bounds(*planned, analysis), input->data_dir, diagnostics);
  if (diagnostics.has_errors()) return no_answer();
  FirmwareRequest request = firmware_of(planned->robot, options.out, input->data_dir);
  request.name = "bench";
  const auto plan = plan_of(*planned, diagnostics);
  if (!plan) return no_answer();
  Output robot = output_of(std::move(generated), *planned, *input, sources);
  Output kit = make_output(files_of_kit(options, *plan, request), robot.manifest.inputs, plan->robot);
  const Project project{request, std::move(robot), std::move(kit), "-o"};
  if (!is_free_to_write(project, {}, sources, diagnostics)) return no_answer();
  if (!can_build(request)) {
    if (!write_project(project, sources, diagnostics)) return no_answer();
    return answer_of_kit(options.out, std::nullopt);
  }
  const auto image = make_image(project, sources, diagnostics);
  return image ? answer_of_kit(options.out, image) : no_answer();
}

std::string words_for(const Json& expected) {
  if (expected.is_null()) return "anything";
  if (!expected.is_object()) return expected.dump();
  return fmt::format("{} to {}", expected.value("min", Json()).dump(), expected.value("max", Json()).dump());
}

std::string text_of(const BenchJudgement& judgement) {
  std::string text;
  for (const BenchVerdict& it : judgement.tests) {
    const std::string value = it.value ? std::to_string(*it.value) : "none: " + it.why;
    const std::string ground = it.source.empty() ? it.ground : it.ground + ": " + it.source;
    text += fmt::format("{}  {:<34} {:>12}  expected {} ({})\n", it.is_ok ? "ok     " : "DIFFERS", it.name, value,
                        words_for(it.expected), ground);
  }
  for (const auto& [name, why] : judgement.not_done) text += fmt::format("not done {} (needs {})\n", name, why);
  const auto differ =
      std::count_if(judgement.tests.begin(), judgement.tests.end(), [](const BenchVerdict& it) { return !it.is_ok; });
  return text + fmt::format("\n{} tests, {} differ, {} not done\n", judgement.tests.size() + judgement.not_done.size(),
                            differ, judgement.not_done.size());
}

Json document_of(const BenchRecord& record, const BenchJudgement& judgement) {
  Json tests = Json::array(), not_done = Json::array();
  for (const BenchVerdict& it : judgement.tests) {
    tests.push_back({{"name", it.name},
                     {"value", it.value ? Json(*it.value) : Json()},
                     {"expected", it.expected},
                     {"ok", it.is_ok},
                     {"ground", it.ground},
                     {"source", it.source}});
    if (!it.why.empty()) tests.back()["why"] = it.why;
  }
  for (const auto& [name, why] : judgement.not_done) not_done.push_back({{"name", name}, {"why", why}});
  return {{"schema", kBenchFormat}, {"board", record.board}, {"robot", record.robot},
          {"plan", record.plan},    {"tests", tests},        {"not_done", not_done}};
}

/// The text of the file; FM0002 where it cannot be read.
std::optional<std::string> text_of_file(const std::string& path, Diagnostics& diagnostics) {
  auto text = read_bytes(path);
  if (!text) diagnostics.error(code::unreadable_file, {}, fmt::format("cannot read '{}'", path));
  return text;
}

Answer read_record(const Options& options, Sources& sources, Diagnostics& diagnostics) {
  const auto text = text_of_file(options.read, diagnostics);
  const auto input = robot_of(options, sources, diagnostics);
  if (!text || !input || diagnostics.has_errors()) return no_answer();
  const auto record = find_bench_record(*text);
  if (!record) {
    diagnostics.error(code::bench_record, {}, fmt::format("'{}' holds no whole record {}", options.read, kBenchFormat))
        .hint("the image prints it as one line every two seconds: record for five");
    return no_answer();
  }
  if (record->board != kBoard) {
    diagnostics
        .error(code::bench_record, {},
               fmt::format("the record in '{}' is of the board '{}'", options.read, record->board))
        .hint(fmt::format("the bench kit is written for '{}'", kBoard));
    return no_answer();
  }
  const auto planned = plan_for_bench(*input, sources, diagnostics);
  const auto plan = planned ? plan_of(*planned, diagnostics) : std::nullopt;
  if (!plan) return no_answer();
  const BenchJudgement judgement = judge_bench(*record, *plan);
  return {judgement.is_good() ? kExitYes : kExitNo, text_of(judgement), document_of(*record, judgement)};
}

}  // namespace

Answer run_bench_kit(const Options& options, Sources& sources, Diagnostics& diagnostics) {
  if (options.out.empty() != options.read.empty())
    return options.read.empty() ? write_kit(options, sources, diagnostics) : read_record(options, sources, diagnostics);
  diagnostics.error(code::usage, {}, "bench-kit needs -o DIR, to write a kit, or --read FILE, to judge a record");
  return no_answer();
}

}  // namespace finemote::gen
