#include "generator/run/emulate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>

#include "emulator/scenario/grammar.hpp"
#include "generator/diagnostic/code_scenario.hpp"
#include "generator/diagnostic/suggest.hpp"
#include "generator/file/replace_file.hpp"
#include "generator/image/exception.hpp"
#include "generator/run/board_wiring.hpp"
#include "generator/run/bring_up.hpp"
#include "generator/run/emulation.hpp"
#include "generator/run/parts.hpp"
#include "generator/run/process.hpp"
#include "generator/run/program_folder.hpp"
#include "generator/run/read_record.hpp"
#include "generator/units/units.hpp"

namespace finemote::gen {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// The port that a part of this name hangs on; empty: none of these parts has that name.
std::string port_of(const Json& parts, const std::string& name) {
  const auto part =
      std::find_if(parts.begin(), parts.end(), [&](const Json& one) { return one.value("name", "") == name; });
  return part == parts.end() ? std::string() : part->value("port", "");
}

/// Ports on whose lines events of a scenario put bytes that nobody declares, without violating an assumption.
std::vector<std::string> ports_with_text(const Json& scenario, const Json& robots_parts) {
  std::vector<std::string> ports;
  const Json own_parts = scenario.value("parts", Json::array());
  for (const Json& event : scenario.value("events", Json::array())) {
    if (event.value("do", "") != "send") continue;
    const std::string part = event.value("part", ""), own = port_of(own_parts, part);
    ports.push_back(event.value("port", own.empty() ? port_of(robots_parts, part) : own));
  }
  return ports;
}

Json bus_ports(const Robot& robot) {
  Json ports = Json::array();
  for (const Bus& bus : robot.buses) {
    if (!bus.port.empty()) ports.push_back(bus.port);
  }
  return ports;
}

/// In the order of the plan.
Json bucket_exceptions(const Schedule& schedule) {
  Json list = Json::array();
  for (const Bucket& bucket : schedule.buckets) list.push_back(exception_of(bucket.line));
  return list;
}

/// Runs the job; null and FM0006 or FM6003 where the program is missing or fails.
Json run_job(const Json& job, const std::string& stem, Duration duration, Diagnostics& diagnostics) {
  const std::string job_file = stem + ".job.json", record_file = stem + ".record.json";
  if (const auto reason = replace_file(job_file, job.dump() + "\n")) {
    diagnostics.error(code::output_not_writable, {}, fmt::format("cannot write '{}': {}", job_file, *reason));
    return {};
  }
  fs::remove(record_file);
  const std::chrono::seconds limit(120 + 60 * floor_div(duration, seconds(1)));
  const std::string program = (program_folder() / "finemote-emulator").string();
  const ProcessResult result = run_process({program, job_file, record_file}, limit);
  std::ifstream file(record_file);
  if (result.started && !result.timed_out && result.exit_status == 0 && file) return Json::parse(file);
  if (!result.started) {
    report_not_started(program, "the emulated board is a program that is built and installed beside finemote",
                       diagnostics);
    return {};
  }
  auto& finding = diagnostics.error(code::broken_record, {}, fmt::format("'{}' cannot run the image", program));
  if (result.timed_out) finding.note(fmt::format("stopped after {} s", limit.count()));
  if (!result.output.empty()) finding.note(result.output);
  return {};
}

bool overrun_stops(const Robot& robot) {
  return param_value(robot.board_params, "overrun", std::string()) == "safe_stop";
}

/// To whole milliseconds: the emulated board looks for faults now and then.
std::string when_at_start(const Json& record) {
  const Json& fault = record.at("fault_ns");
  if (fault.is_null()) return "before its first release";
  return fmt::format("before its first release, within {} of power-on",
                     units::format_duration(round_up(time_of(fault), milliseconds(1))));
}

/// The processor no longer runs.
void report_end(const Json& record, const FaultTable& table, Diagnostics& diagnostics) {
  const std::vector<FaultCount> faults = faults_of(record);
  auto& finding = diagnostics.error(code::firmware_stopped, {},
                                    fmt::format("the firmware {}", record.at("stop").get<std::string>()));
  for (const FaultCount& fault : faults) finding.note("it counted: " + fault_text(table, fault));
  for (const Json& report : record.at("reports")) {
    finding.note(fmt::format("{} at {} ns: {}", report.at("misuse").get<std::string>(),
                             report.at("first_ns").get<std::uint64_t>(), report.at("text").get<std::string>()));
  }
}

/// A firmware that did not come to its first release.
void report_stop_at_start(const Json& record, const FaultTable& table, Diagnostics& diagnostics) {
  const std::vector<FaultCount> faults = faults_of(record);
  if (const FaultCount* stop = stopping_fault(table, faults, false))
    return report_safe_stop(table, faults, *stop, when_at_start(record), diagnostics);
  report_end(record, table, diagnostics);
}

/// Why a firmware that came to its first release runs no longer, FM6002; empty: it does. A safe stop that a scenario
/// may have caused is left alone.
std::vector<Diagnostic> why_stopped(const Json& record, const Robot& robot, const FaultTable& table) {
  Diagnostics said;
  const std::vector<FaultCount> faults = undisturbed_faults_of(record);
  if (const FaultCount* stop = stopping_fault(table, faults, overrun_stops(robot))) {
    const Json& stages = record.at("stages");
    const Duration last = stages.empty() ? Duration::zero() : time_of(stages.back().at(0));
    report_safe_stop(table, faults, *stop, fmt::format("after its last stage at {}", units::format_duration(last)),
                     said);
  } else if (!record.at("stop").is_null()) {
    report_end(record, table, said);
  }
  return said.in_file_order();
}

/// How far the clocks of parts may be off, as the types of their devices say, by their names.
std::map<std::string, double> declared_ppm(const Robot& robot) {
  std::map<std::string, double> declared;
  for (const Device& device : robot.devices) {
    if (device.type->acquisition) declared[device.name.text] = static_cast<double>(device.type->clock_ppm());
  }
  return declared;
}

/// Devices on a bus for which neither the robot nor a scenario (null: none) has a part of that name.
std::vector<std::string> silent_beside(const EmulatedParts& parts, const Scenario* scenario) {
  std::vector<std::string> silent = parts.silent;
  if (scenario == nullptr || !scenario->document.contains("parts")) return silent;
  const Json& given = scenario->document.at("parts");
  std::erase_if(silent, [&](const std::string& device) {
    return std::any_of(given.begin(), given.end(), [&](const Json& part) { return part.value("name", "") == device; });
  });
  return silent;
}

void warn_of_misuse(const Json& record, Diagnostics& diagnostics) {
  for (const Json& report : record.at("reports")) {
    diagnostics.warning(
        code::hardware_misuse, {},
        fmt::format("{}: {} ({} times, first at {} ns, pc {:#010x})", report.at("misuse").get<std::string>(),
                    report.at("text").get<std::string>(), report.at("count").get<std::uint32_t>(),
                    report.at("first_ns").get<std::uint64_t>(), report.at("pc").get<std::uint32_t>()));
  }
}

}  // namespace

void warn_of_undriven(const EmulatedParts& parts, Diagnostics& diagnostics) {
  for (const UndrivenBody& body : parts.undriven) {
    auto& finding = diagnostics.warning(code::undriven_plant, body.at, body.message);
    for (const std::string& note : body.notes) finding.note(note);
  }
}

bool has_models(const Robot& robot, Diagnostics& diagnostics) {
  std::vector<std::string> known;
  for (const scenario::Model& model : scenario::models()) known.push_back(model.type);
  std::set<std::string> reported;
  const auto check = [&](const auto& type, Position at, std::size_t tag_length) {
    const std::string& part = type.emulation.part;
    if (scenario::find_model(part) != nullptr || !reported.insert(type.name).second) return;
    diagnostics.error(code::emulated_part, at, fmt::format("the emulated board has no part '{}'", part))
        .underline(tag_length)
        .note(fmt::format("'{}' names it as the model of type '{}'", type.display_path, type.name))
        .hint(did_you_mean(part, known))
        .hint("or leave out 'emulation': the part never answers then");
  };
  for (const Expander& expander : robot.expanders) {
    if (has_part(robot, expander)) check(*expander.type, expander.at, std::string_view("<expander").size());
  }
  for (const Device& device : robot.devices) {
    if (has_part(robot, device)) check(*device.type, device.at, std::string_view("<device").size());
  }
  return reported.empty();
}

bool rehearse(const Board& board, const EmulatedParts& parts, const Scenario* scenario, const std::string& stem,
              Diagnostics& diagnostics) {
  Json job{{"board", board_wiring(board)}, {"parts", parts.scenario}};
  if (scenario != nullptr) job["events"] = scenario->document;
  const Json json = run_job(job, stem, Duration::zero(), diagnostics);
  if (json.is_null()) return false;
  if (json.contains("error")) {
    const bool is_given = scenario != nullptr;
    diagnostics.error(is_given ? code::bad_scenario : code::emulated_part,
                      is_given ? Position{scenario->file, 1, 1, nullptr} : Position{},
                      json.at("error").get<std::string>());
  }
  return !json.contains("error");
}

std::optional<RunRecord> emulate(const std::string& image, const Robot& robot, const Forest& forest, Duration duration,
                                 const EmulationOptions& options, Diagnostics& diagnostics) {
  Json parts = options.parts.scenario;
  const auto most_ppm = static_cast<double>(options.board.clock_ppm);
  const std::optional<Phase> phase = options.phase ? options.phase : clocks_of(options.silicon);
  const double clock_ppm = phase ? shift_clocks(*phase, most_ppm, declared_ppm(robot), parts.at("parts")) : 0;
  const char* flash = options.flash_misses ? "miss" : "hit";
  const Duration last_event = options.scenario == nullptr ? Duration::zero() : options.scenario->last_event;
  Json job = {{"board", board_wiring(options.board)},
              {"image", image},
              {"flash", flash},
              {"await", awaited_parts(robot)},
              {"bring_up_ns", longest_bring_up(robot).ns()},
              {"least_bring_up_ns", shortest_bring_up(robot).ns()},
              {"duration_ns", duration.ns()},
              {"last_event_ns", last_event.ns()},
              {"ports", bus_ports(robot)},
              {"parts", std::move(parts)}};
  if (!options.silicon.names.empty()) job["silicon"] = silicon_json(options.silicon);
  if (!options.loops.empty()) job["loops"] = watched_loops(options.loops);
  if (options.audit != nullptr) job["audit"] = bucket_exceptions(*options.audit);
  if (options.scenario != nullptr) job["events"] = options.scenario->document;
  const Json json = run_job(job, image, longest_bring_up(robot) + std::max(duration, last_event), diagnostics);
  if (json.is_null()) return std::nullopt;
  if (!json.contains("ready_ns")) {
    report_stop_at_start(json, options.faults, diagnostics);
    return std::nullopt;
  }
  warn_of_misuse(json, diagnostics);
  RunRecord record = read_record(json, robot, forest);
  record.stopped = why_stopped(json, robot, options.faults);
  record.silent = silent_beside(options.parts, options.scenario);
  record.judged_for = std::max(duration, last_event - record.ready);
  if (options.scenario != nullptr)
    record.text_ports = ports_with_text(options.scenario->document, options.parts.scenario.at("parts"));
  record.clock_ppm = clock_ppm;
  record.flash = flash;
  record.silicon = options.silicon;
  return record;
}

}  // namespace finemote::gen
