#include "generator/run/execute.hpp"

#include <fmt/format.h>

#include "generator/run/printed_record.hpp"
#include "generator/run/process.hpp"
#include "generator/units/units.hpp"

namespace finemote::gen {
namespace {

/// QEMU counts instructions: 2^shift ns for each, the same on every machine and under any load.
constexpr unsigned kInstructionShift = 3;

std::vector<std::string> qemu_command(const std::string& image) {
  return {"qemu-system-arm",
          "-M",
          "netduinoplus2",
          "-nographic",
          "-monitor",
          "none",
          "-serial",
          "none",
          "-chardev",
          "stdio,id=sh",
          "-semihosting-config",
          "enable=on,target=native,chardev=sh",
          "-icount",
          fmt::format("shift={},align=off,sleep=off", kInstructionShift),
          "-kernel",
          image};
}

/// A firmware that ended by itself, or not at all.
void report_end(const ProcessResult& result, std::chrono::seconds limit, const std::optional<RunRecord>& record,
                const FaultTable& faults, Diagnostics& diagnostics) {
  auto& finding =
      diagnostics.error(code::firmware_stopped, {},
                        result.timed_out ? fmt::format("the firmware did not end within {} s", limit.count())
                                         : fmt::format("the firmware ended with status {}", result.exit_status));
  if (record) {
    for (const FaultCount& fault : record->faults) finding.note("it counted: " + fault_text(faults, fault));
  }
  const auto last_line = result.output.find_last_not_of('\n');
  if (last_line == std::string::npos) return;
  const auto begin = result.output.find_last_of('\n', last_line);
  finding.note("its last output: " + result.output.substr(begin == std::string::npos ? 0 : begin + 1));
}

}  // namespace

std::optional<RunRecord> execute(const std::string& program, const Board& board, const Robot& robot,
                                 const Forest& forest, Duration duration, const FaultTable& faults,
                                 Diagnostics& diagnostics) {
  // An emulated second takes well under a second; the limit only ends images that hang.
  const std::chrono::seconds limit(60 + 10 * floor_div(duration, seconds(1)));
  const std::vector<std::string> command =
      board.is_host() ? std::vector<std::string>{program, std::to_string(duration.ns())} : qemu_command(program);
  const ProcessResult result = run_process(command, limit);
  if (!result.started) {
    report_not_started(command.front(),
                       board.is_host()
                           ? "it was built just now: programs may not run where it lies (mount option noexec)"
                           : "apt-get install qemu-system-arm",
                       diagnostics);
    return std::nullopt;
  }
  auto record = parse_record(result.output, forest, robot.buses.size(), duration);
  if (result.timed_out || result.exit_status != 0) {
    const FaultCount* stop = record && record->stopped_at ? stopping_fault(faults, record->faults, true) : nullptr;
    if (stop == nullptr) {
      report_end(result, limit, record, faults, diagnostics);
      return std::nullopt;
    }
    Diagnostics said;
    report_safe_stop(faults, record->faults, *stop, "at " + units::format_duration(*record->stopped_at), said);
    if (record->events.empty()) {
      for (const Diagnostic& finding : said.in_file_order()) diagnostics.add(finding);
      return std::nullopt;
    }
    record->stopped = said.in_file_order();
  }
  if (!record) diagnostics.error(code::broken_record, {}, "cannot read the record printed by the firmware");
  if (record && !board.is_host()) record->instruction_time = nanoseconds(1 << kInstructionShift);
  return record;
}

}  // namespace finemote::gen
